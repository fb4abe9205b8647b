#include "chapters/13_other_solvers/incremental_potential.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enduring {

SmoothFriction smooth_friction(double slip, double full)
{
    if (slip >= full)
        return {slip, 1, 0};
    const double part = slip / full;
    return {full * (part * part * (1 - part / 3) + 1.0 / 3), part * (2 - part), 2 * (1 - part) / full};
}

namespace {

/// Of the reach of a step [1]: how far features beyond d^hat may be from each other and count as near. With
/// all of it, each evaluation looks at all pairs; a hundredth finds the near ones anew in nearly each.
constexpr double part_of_reach = 0.1;

/// J of rigid-ipc: the mass' second moment in body axes, from the inertia [kg m^2].
Mat3 second_moment(const MovingBody& body)
{
    return 0.5 * body.inertia_in_body.trace() * Mat3::Identity() - body.inertia_in_body;
}

/// p - q by weights of the corners [m].
Vec3 difference(const ContactPoint& pair, const std::array<double, 4>& weights, const Places& places)
{
    const FourPoints x = corners_of(pair, places);
    return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
}

/// The corners of an element at places.
FourPoints corners_at(const std::array<std::size_t, 4>& nodes, const Places& places)
{
    return {places.nodes[nodes[0]], places.nodes[nodes[1]], places.nodes[nodes[2]], places.nodes[nodes[3]]};
}

}  // namespace

IncrementalPotential::IncrementalPotential(const MethodStep& step, const BarrierSettings& settings,
                                           double distance, double reach, double whole_dt)
    : step_(step), settings_(settings), distance_(distance), reach_(reach),
      full_slip_(settings.friction_speed * distance / settings.distance * step.dt), coordinates_(step),
      soft_(step.soft.begin(), step.soft.end()), slack_(part_of_reach * reach)
{
    double mass = 0;
    int count = static_cast<int>(step.soft.size());
    for (const MovingBody& body : step.bodies) {
        MovingBody free = body;
        free.fall(step.dt);
        free.move(step.dt);
        inertial_.poses.push_back(body.moves ? free.pose : body.pose);
        start_.poses.push_back(body.start);
        mass += body.moves ? 1 / body.inverse_mass : 0;
        count += body.moves;
    }
    for (const SoftNode& node : step.nodes) {
        inertial_.nodes.emplace_back(node.start + step.dt * (node.velocity + step.dt * node.gravity));
        start_.nodes.push_back(node.start);
        mass += node.inverse_mass > 0 ? 1 / node.inverse_mass : 0;
    }
    all_.resize(step.points.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    kappa_ = settings.stiffness * mass / std::max(count, 1) * std::pow(distance / whole_dt, 2);
}

/// Gradient and Hessian of 1/2 tr((Q - Q^) J (Q - Q^)^T) by a rotation vector from Q: with B = Q J Q^^T,
/// twice its antisymmetric part, and tr(B) 1 - B, made symmetric.
void IncrementalPotential::add_inertia(const Places& places, PotentialSlopes& slopes) const
{
    const double rate = 1 / (step_.dt * step_.dt);
    for (std::size_t i = 0; i < places.poses.size(); ++i) {
        if (coordinates_.of_body[i] < 0)
            continue;
        const MovingBody& body = step_.bodies[i];
        const Mat3 b = places.poses[i].orientation.toRotationMatrix() * second_moment(body) *
                       inertial_.poses[i].orientation.toRotationMatrix().transpose();
        Eigen::Matrix<double, 6, 1> slope;
        slope << (places.poses[i].position - inertial_.poses[i].position) / body.inverse_mass,
            Vec3(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
        Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
        mass.topLeftCorner<3, 3>().diagonal().setConstant(1 / body.inverse_mass);
        mass.bottomRightCorner<3, 3>() = b.trace() * Mat3::Identity() - 0.5 * (b + b.transpose());
        slopes.add_block(coordinates_.of_body[i], rate * slope, rate * mass);
    }
    for (std::size_t n = 0; n < places.nodes.size(); ++n)
        if (coordinates_.of_node[n] >= 0) {
            const double mass = rate / step_.nodes[n].inverse_mass;
            slopes.add_block(coordinates_.of_node[n], mass * (places.nodes[n] - inertial_.nodes[n]),
                             mass * Mat3::Identity());
        }
}

double IncrementalPotential::inertia(const Places& places) const
{
    double twice = 0;
    for (std::size_t i = 0; i < places.poses.size(); ++i)
        if (coordinates_.of_body[i] >= 0) {
            const MovingBody& body = step_.bodies[i];
            const Mat3 turn = places.poses[i].orientation.toRotationMatrix() -
                              inertial_.poses[i].orientation.toRotationMatrix();
            twice += (places.poses[i].position - inertial_.poses[i].position).squaredNorm() /
                         body.inverse_mass +
                     (turn * second_moment(body) * turn.transpose()).trace();
        }
    for (std::size_t n = 0; n < places.nodes.size(); ++n)
        if (coordinates_.of_node[n] >= 0)
            twice += (places.nodes[n] - inertial_.nodes[n]).squaredNorm() / step_.nodes[n].inverse_mass;
    return 0.5 / (step_.dt * step_.dt) * twice;
}

double IncrementalPotential::held(const Places& places) const
{
    double energy = 0;
    for (const BarrierTerm& term : barrier_terms(step_, near(places), places, distance_))
        energy += kappa_ * term.count * term.mollifier.value * term.barrier.value;
    return energy;
}

//! [value]
double IncrementalPotential::value(const Places& places) const
{
    double energy = inertia(places);
    for (const SoftElements& body : soft_)
        for (std::size_t e = 0; e < body.count(); ++e)
            energy += body.energy(e, corners_at(body.nodes(e), places));
    energy += held(places);
    for (const Holding& holding : holdings_)
        energy += holding.most * smooth_friction(slip(holding, places).norm(), full_slip_).potential;
    return energy;
}
//! [value]

//! [slopes]
PotentialSlopes IncrementalPotential::slopes(const Places& places) const
{
    PotentialSlopes slopes(coordinates_);
    add_inertia(places, slopes);
    for (const SoftElements& body : soft_)
        for (std::size_t e = 0; e < body.count(); ++e)
            slopes.add_nodes(body.nodes(e), body.derivatives(e, corners_at(body.nodes(e), places)));
    for (const BarrierTerm& term : barrier_terms(step_, near(places), places, distance_)) {
        const ContactPoint& pair = step_.points[term.point];
        slopes.add_pair(pair, places, term.potential(pair, kappa_, distance_));
    }
    for (const Holding& holding : holdings_)
        slopes.add_pair(step_.points[holding.point], places, friction(holding, places));
    return slopes;
}
//! [slopes]

Derivatives IncrementalPotential::friction(const Holding& holding, const Places& places) const
{
    const Vec3 slip = this->slip(holding, places), along = slip.stableNormalized();
    const SmoothFriction law = smooth_friction(slip.norm(), full_slip_);
    const double over = slip.isZero(0) ? law.slope
                                       : law.force / slip.norm();  // f1 / y, the same in the limit
    const Mat3 surface = Mat3::Identity() - holding.normal * holding.normal.transpose();
    const Mat3 bend = holding.most * (over * surface + (law.slope - over) * along * along.transpose());
    Derivatives of;
    of.value = holding.most * law.potential;
    for (int i = 0; i < 4; ++i) {
        const double weight = holding.weights[static_cast<std::size_t>(i)];
        of.gradient.segment<3>(3 * i) = holding.most * law.force * weight * along;
        for (int j = 0; j < 4; ++j)
            of.hessian.block<3, 3>(3 * i, 3 * j) = weight * holding.weights[static_cast<std::size_t>(j)] *
                                                   bend;
    }
    return of;
}

//! [lag]
Vec3 IncrementalPotential::slip(const Holding& holding, const Places& places) const
{
    const ContactPoint& pair = step_.points[holding.point];
    const Vec3 moved = difference(pair, holding.weights, places) - holding.start + step_.dt * pair.given;
    return moved - holding.normal.dot(moved) * holding.normal;
}

void IncrementalPotential::lag(const Places& places)
{
    holdings_.clear();
    for (const BarrierTerm& term : barrier_terms(step_, near(places), places, distance_)) {
        const ContactPoint& pair = step_.points[term.point];
        const double length = term.nearest.difference.norm();
        const double force = -kappa_ * term.count * term.mollifier.value * term.barrier.slope * 2 * length /
                             (distance_ * distance_);
        holdings_.push_back({term.point, term.nearest.weights, term.nearest.difference / length,
                             pair.mu_s * force, difference(pair, term.nearest.weights, start_)});
    }
}
//! [lag]

std::vector<Vec3> IncrementalPotential::impulses(const Places& places) const
{
    std::vector<Vec3> impulses(step_.points.size(), Vec3::Zero());
    for (const BarrierTerm& term : barrier_terms(step_, near(places), places, distance_)) {
        const ContactPoint& pair = step_.points[term.point];
        const Vector12 slope = term.potential(pair, kappa_, distance_).gradient;
        for (int i = 0; i < pair.corners_of_a(); ++i)
            impulses[term.point] -= step_.dt * slope.segment<3>(3 * i);
    }
    for (const Holding& holding : holdings_) {
        const Vec3 slip = this->slip(holding, places);
        impulses[holding.point] -= step_.dt * holding.most * smooth_friction(slip.norm(), full_slip_).force *
                                   slip.stableNormalized();
    }
    return impulses;
}

//! [free_part]
double IncrementalPotential::free_part(const Places& from, const Eigen::VectorXd& by) const
{
    double part = 1;
    for (int i = 0; i < settings_.line_search_steps; ++i) {
        const Places to = moved(from, part * by);
        if (is_beyond(to)) {
            part /= 2;
            continue;
        }
        const bool is_near = is_served(from) && is_served(to);
        const auto [time, any] = first_meeting(step_, is_near ? near_ : all_, from, to, distance_);
        if (!any)
            return part;
        part *= settings_.part_of_impact * time;
    }
    return 0;
}
//! [free_part]

bool IncrementalPotential::is_beyond(const Places& places) const
{
    return longest_way(start_, places) > reach_;
}

double IncrementalPotential::longest_way(const Places& from, const Places& to) const
{
    double longest = 0;
    for (std::size_t i = 0; i < to.poses.size(); ++i)
        if (coordinates_.of_body[i] >= 0)
            longest = std::max(longest, (to.poses[i].position - from.poses[i].position).norm() +
                                            step_.bodies[i].size * to.poses[i].orientation.angularDistance(
                                                                       from.poses[i].orientation));
    for (std::size_t n = 0; n < to.nodes.size(); ++n)
        longest = std::max(longest, (to.nodes[n] - from.nodes[n]).norm());
    return longest;
}

//! [near]
/// What is farther apart than d^hat and a slack stays so until one of both has moved by half of the slack.
/// Most places that Newton's method asks for lie nearer to each other than that.
const PairPlaces& IncrementalPotential::near(const Places& places) const
{
    if (!is_served(places)) {
        near_ = near_pairs(step_, places, distance_ + slack_);
        near_places_ = places;
    }
    return near_;
}

bool IncrementalPotential::is_served(const Places& places) const
{
    return !near_places_.poses.empty() && 2 * longest_way(near_places_, places) <= slack_;
}
//! [near]

}  // namespace enduring
