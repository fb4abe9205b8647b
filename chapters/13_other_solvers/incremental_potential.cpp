#include "chapters/13_other_solvers/incremental_potential.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring {

SmoothFriction smooth_friction(double slip, double full)
{
    if (slip >= full)
        return {slip, 1, 0};
    const double part = slip / full;
    return {full * (part * part * (1 - part / 3) + 1.0 / 3), part * (2 - part), 2 * (1 - part) / full};
}

namespace {

Mat3 cross_matrix(const Vec3& r)
{
    return (Mat3() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0).finished();
}

/// J of rigid-ipc: the mass' second moment in body axes, from the inertia [kg m^2].
Mat3 second_moment(const MovingBody& body)
{
    return 0.5 * body.inertia_in_body.trace() * Mat3::Identity() - body.inertia_in_body;
}

/// p - q by weights of the corners [m].
Vec3 difference(const ContactPoint& pair, const std::array<double, 4>& weights, const Poses& poses)
{
    const FourPoints x = corners_of(pair, poses);
    return weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
}

Matrix12 positive_part(const Matrix12& matrix)
{
    const Eigen::SelfAdjointEigenSolver<Matrix12> own(matrix);
    return own.eigenvectors() * own.eigenvalues().cwiseMax(0).asDiagonal() * own.eigenvectors().transpose();
}

}  // namespace

/// Gradient and Hessian by the bodies' coordinates, from those by corners.
struct IncrementalPotential::Assembly {
    Eigen::VectorXd gradient;
    std::vector<Eigen::Triplet<double>> entries;

    void add_block(int row, int column, const Eigen::Ref<const Eigen::Matrix<double, 6, 6>>& block)
    {
        for (int i = 0; row >= 0 && column >= 0 && i < 6; ++i)
            for (int j = 0; j < 6; ++j)
                entries.emplace_back(row + i, column + j, block(i, j));
    }

    //! [assemble]
    /// A corner moves by dx - r x dw - and its second derivative by the rotation vector is that of the exponential map.
    void add(const FourPoints& x, const ContactPoint& point, const std::array<Pose, 2>& poses,
             const std::array<int, 2>& first, const Vector12& slope, const Matrix12& bend)
    {
        Matrix12 rate = Matrix12::Zero(), turned = Matrix12::Zero();
        for (int i = 0; i < corner_count(point); ++i) {
            const int side = i < corners_of_a(point) ? 0 : 1;
            const auto n = static_cast<std::size_t>(side);
            if (first[n] < 0)
                continue;
            const Vec3 r = x[static_cast<std::size_t>(i)] - poses[n].position, f = slope.segment<3>(3 * i);
            rate.block<3, 3>(3 * i, 6 * side).setIdentity();
            rate.block<3, 3>(3 * i, 6 * side + 3) = -cross_matrix(r);
            turned.block<3, 3>(6 * side + 3, 6 * side + 3) += 0.5 * (f * r.transpose() + r * f.transpose()) -
                                                              f.dot(r) * Mat3::Identity();
        }
        const Vector12 by_bodies = rate.transpose() * slope;
        const Matrix12 hessian = positive_part(rate.transpose() * bend * rate + turned);
        for (int one = 0; one < 2; ++one) {
            const int row = first[static_cast<std::size_t>(one)];
            if (row >= 0)
                gradient.segment<6>(row) += by_bodies.segment<6>(6 * one);
            for (int other = 0; other < 2; ++other)
                add_block(row, first[static_cast<std::size_t>(other)],
                          hessian.block<6, 6>(6 * one, 6 * other));
        }
    }
    //! [assemble]
};

IncrementalPotential::IncrementalPotential(const RigidStep& step, const BarrierSettings& settings,
                                           double distance)
    : step_(step), settings_(settings), distance_(distance),
      full_slip_(settings.friction_speed * distance / settings.distance * step.dt)
{
    double mass = 0;
    int count = 0;
    for (const MovingBody& body : step.bodies) {
        first_.push_back(body.moves ? std::exchange(size_, size_ + 6) : -1);
        MovingBody free = body;
        free.fall(step.dt);
        free.move(step.dt);
        inertial_.push_back(body.moves ? free.pose : body.pose);
        mass += body.moves ? 1 / body.inverse_mass : 0;
        count += body.moves;
    }
    kappa_ = settings.stiffness * mass / std::max(count, 1) * std::pow(distance / step.dt, 2);
}

Poses IncrementalPotential::moved(const Poses& from, const Eigen::VectorXd& by) const
{
    Poses to = from;
    for (std::size_t i = 0; i < to.size(); ++i)
        if (first_[i] >= 0) {
            const Vec3 turn = by.segment<3>(first_[i] + 3);
            const Eigen::AngleAxisd about(turn.norm(), turn.stableNormalized());
            to[i] = {from[i].position + by.segment<3>(first_[i]), (about * from[i].orientation).normalized()};
        }
    return to;
}

/// Gradient and Hessian of 1/2 tr((Q - Q^) J (Q - Q^)^T) by a rotation vector from Q: with B = Q J Q^^T, twice its antisymmetric part, and
/// tr(B) 1 - B, made symmetric.
void IncrementalPotential::add_inertia(std::size_t i, const Pose& pose, Assembly& assembly) const
{
    const MovingBody& body = step_.bodies[i];
    const double rate = 1 / (step_.dt * step_.dt);
    const Mat3 b = pose.orientation.toRotationMatrix() * second_moment(body) *
                   inertial_[i].orientation.toRotationMatrix().transpose();
    assembly.gradient.segment<3>(first_[i]) = rate / body.inverse_mass *
                                              (pose.position - inertial_[i].position);
    assembly.gradient.segment<3>(first_[i] + 3) = rate * Vec3(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0),
                                                              b(1, 0) - b(0, 1));
    Eigen::Matrix<double, 6, 6> mass = Eigen::Matrix<double, 6, 6>::Zero();
    mass.topLeftCorner<3, 3>().diagonal().setConstant(rate / body.inverse_mass);
    mass.bottomRightCorner<3, 3>() = rate * (b.trace() * Mat3::Identity() - 0.5 * (b + b.transpose()));
    assembly.add_block(first_[i], first_[i], mass);
}

//! [value]
double IncrementalPotential::value(const Poses& poses) const
{
    double energy = 0;
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (first_[i] >= 0) {
            const MovingBody& body = step_.bodies[i];
            const Mat3 turn = poses[i].orientation.toRotationMatrix() -
                              inertial_[i].orientation.toRotationMatrix();
            energy += 0.5 / (step_.dt * step_.dt) *
                      ((poses[i].position - inertial_[i].position).squaredNorm() / body.inverse_mass +
                       (turn * second_moment(body) * turn.transpose()).trace());
        }
    for (const BarrierTerm& term : barrier_terms(step_, poses, distance_))
        energy += kappa_ * term.count * term.mollifier.value * term.barrier.value;
    for (const Holding& holding : holdings_)
        energy += holding.most * smooth_friction(slip(holding, poses).norm(), full_slip_).potential;
    return energy;
}
//! [value]

//! [slopes]
IncrementalPotential::Slopes IncrementalPotential::slopes(const Poses& poses) const
{
    Assembly assembly{Eigen::VectorXd::Zero(size_), {}};
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (first_[i] >= 0)
            add_inertia(i, poses[i], assembly);
    const auto add = [&](std::size_t n, const FourPoints& x, const Vector12& slope, const Matrix12& bend) {
        const ContactPoint& pair = step_.points[n];
        const auto a = static_cast<std::size_t>(pair.a), b = static_cast<std::size_t>(pair.b);
        assembly.add(x, pair, {poses[a], poses[b]}, {first_[a], first_[b]}, slope, bend);
    };
    for (const BarrierTerm& term : barrier_terms(step_, poses, distance_)) {
        const Derivatives of = term.potential(step_.points[term.point], kappa_, distance_);
        add(term.point, term.x, of.gradient, of.hessian);
    }
    for (const Holding& holding : holdings_) {
        const Vec3 slip = this->slip(holding, poses), along = slip.stableNormalized();
        const SmoothFriction law = smooth_friction(slip.norm(), full_slip_);
        const double over = slip.isZero(0) ? law.slope
                                           : law.force / slip.norm();  // f1 / y, the same in the limit
        const Mat3 surface = Mat3::Identity() - holding.normal * holding.normal.transpose();
        const Mat3 bend = holding.most * (over * surface + (law.slope - over) * along * along.transpose());
        Vector12 slope;
        Matrix12 bends;
        for (int i = 0; i < 4; ++i) {
            slope.segment<3>(3 * i) = holding.most * law.force *
                                      holding.weights[static_cast<std::size_t>(i)] * along;
            for (int j = 0; j < 4; ++j)
                bends.block<3, 3>(3 * i, 3 * j) = holding.weights[static_cast<std::size_t>(i)] *
                                                  holding.weights[static_cast<std::size_t>(j)] * bend;
        }
        add(holding.point, corners_of(step_.points[holding.point], poses), slope, bends);
    }
    Slopes slopes{assembly.gradient, Eigen::SparseMatrix<double>(size_, size_)};
    slopes.hessian.setFromTriplets(assembly.entries.begin(), assembly.entries.end());
    return slopes;
}
//! [slopes]

//! [lag]
Vec3 IncrementalPotential::slip(const Holding& holding, const Poses& poses) const
{
    const ContactPoint& pair = step_.points[holding.point];
    const Vec3 moved = difference(pair, holding.weights, poses) - holding.start + step_.dt * pair.given;
    return moved - holding.normal.dot(moved) * holding.normal;
}

void IncrementalPotential::lag(const Poses& poses)
{
    Poses start;
    for (const MovingBody& body : step_.bodies)
        start.push_back(body.start);
    holdings_.clear();
    for (const BarrierTerm& term : barrier_terms(step_, poses, distance_)) {
        const ContactPoint& pair = step_.points[term.point];
        const double length = term.nearest.difference.norm();
        const double force = -kappa_ * term.count * term.mollifier.value * term.barrier.slope * 2 * length /
                             (distance_ * distance_);
        holdings_.push_back({term.point, term.nearest.weights, term.nearest.difference / length,
                             pair.mu_s * force, difference(pair, term.nearest.weights, start)});
    }
}
//! [lag]

std::vector<Vec3> IncrementalPotential::impulses(const Poses& poses) const
{
    std::vector<Vec3> impulses(step_.points.size(), Vec3::Zero());
    for (const BarrierTerm& term : barrier_terms(step_, poses, distance_)) {
        const ContactPoint& pair = step_.points[term.point];
        const Vector12 slope = term.potential(pair, kappa_, distance_).gradient;
        for (int i = 0; i < corners_of_a(pair); ++i)
            impulses[term.point] -= step_.dt * slope.segment<3>(3 * i);
    }
    for (const Holding& holding : holdings_) {
        const Vec3 slip = this->slip(holding, poses);
        impulses[holding.point] -= step_.dt * holding.most * smooth_friction(slip.norm(), full_slip_).force *
                                   slip.stableNormalized();
    }
    return impulses;
}

//! [free_part]
double IncrementalPotential::free_part(const Poses& from, const Eigen::VectorXd& by, double reach) const
{
    double part = 1;
    for (int i = 0; i < settings_.line_search_steps; ++i) {
        const Poses to = moved(from, part * by);
        if (is_beyond(to, reach)) {
            part /= 2;
            continue;
        }
        const auto [time, any] = first_meeting(step_, from, to, distance_);
        if (!any)
            return part;
        part *= settings_.part_of_impact * time;
    }
    return 0;
}
//! [free_part]

bool IncrementalPotential::is_beyond(const Poses& poses, double reach) const
{
    for (std::size_t i = 0; i < poses.size(); ++i) {
        const MovingBody& body = step_.bodies[i];
        if (first_[i] >= 0 &&
            (poses[i].position - body.start.position).norm() +
                    body.size * poses[i].orientation.angularDistance(body.start.orientation) >
                reach)
            return true;
    }
    return false;
}

}  // namespace enduring
