#include "common/fem/elastic_body.hpp"

#include "common/fem/point_elasticity.hpp"
#include "common/input/input_error.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace enduring {
namespace {

const ElasticMaterial& checked(const ElasticMaterial& material)
{
    check(material);
    return material;
}

/// How a step comes to the forces of its end.
struct Approach {
    int steps = 30;  ///< until a body settles, at most
    /// Error of a change, over what the step changes: less than what another factor may leave between a run
    /// and a resumed one. A tenth: the same motion, and an iteration more. Ten times: the same motion still;
    /// a change leaves far more.
    double error = 1e-9;
    int halvings = 8;      ///< of the length of a change, at most, until ...
    double descent = 0.1;  ///< ... it takes away this share of what Newton's method promises
    /// of the body's length, in a step: what counts as a motion without gravity. Rounding makes less
    double least_change = 1e-7;
};
constexpr Approach approach;

}  // namespace

ElasticBody::ElasticBody(ElasticMesh mesh, const ElasticMaterial& material, const ElasticOptions& options)
    : mesh_(std::move(mesh)), material_(checked(material)), options_(options),
      lame_(lame_constants(material)), mass_matrix_(enduring::mass_matrix(mesh_, material.density)),
      masses_(lumped_masses(mass_matrix_)), inverse_masses_(masses_.cwiseInverse()),
      fixed_(mesh_.node_count(), 0), positions_(mesh_.rest()),
      velocities_(NodalVectors::Zero(3, mesh_.node_count())),
      external_forces_(NodalVectors::Zero(3, mesh_.node_count())),
      last_prediction_(NodalVectors::Zero(3, mesh_.node_count())),
      last_response_(NodalVectors::Zero(3, mesh_.node_count())),
      mended_impulses_(NodalVectors::Zero(3, mesh_.node_count())),
      mended_response_(NodalVectors::Zero(3, mesh_.node_count())),
      rotations_(mesh_.elements().size(), Mat3::Identity()),
      length_((mesh_.rest().rowwise().maxCoeff() - mesh_.rest().rowwise().minCoeff()).norm()),
      solver_(mesh_, mass_matrix_, options.solver_tolerance, options.linear_solver)
{
    if (options.freeze_rotations && has_point_law())
        throw InputError("rotations can be frozen in the corotated law with one frame an element only");
    if (has_point_law())
        elasticity_ = point_elasticity(material.law, mesh_, lame_, rotations_);
    else
        elasticity_ = std::make_unique<CorotatedElasticity>(mesh_, lame_, rotations_);
    // A node of no element has no mass, and no equation.
    for (int n = 0; n < mesh_.node_count(); ++n)
        if (!(masses_[n] > 0))
            throw InputError("node " + std::to_string(n) + " belongs to no element, so it has no mass");
}

void ElasticBody::place(const Mat3& rotation, const Vec3& translation)
{
    positions_ = (rotation * positions_).colwise() + translation;
    for (NodalVectors* field : {&velocities_, &last_prediction_, &last_response_})
        *field = (rotation * *field).eval();
    for (Mat3& r : rotations_)
        r = rotation * r;
}

void ElasticBody::fix(int node)
{
    if (node < 0 || node >= node_count())
        throw InputError("fixed node " + std::to_string(node) + " does not exist; allowed are 0 to " +
                         std::to_string(node_count() - 1));
    fixed_[node] = 1;
    inverse_masses_[node] = 0;
    velocities_.col(node).setZero();
    whole_turn_.reset();
    whole_assembly_.reset();
}

void ElasticBody::release(int node)
{
    fixed_[node] = 0;
    inverse_masses_[node] = 1 / masses_[node];
    solver_.forget_factor();  // in which the node stands
    whole_assembly_.reset();
}

void ElasticBody::linearise(const NodalVectors& positions)
{
    if (!options_.freeze_rotations)
        find_rotations(mesh_, positions, rotations_);
    elasticity_->linearise(positions);
}

/// From K, where no node is fixed: what it holds against a turn of the whole body.
void ElasticBody::take_out_turn()
{
    whole_turn_.reset();
    if (std::find(fixed_.begin(), fixed_.end(), 1) == fixed_.end())
        whole_turn_.emplace(positions_, mass_matrix_);
}

//! [predict]
void ElasticBody::predict(const Vec3& gravity, double dt)
{
    if (!(dt > 0 && std::isfinite(dt)))
        throw InputError("dt (length of the step, s) must be positive and finite, not " + std::to_string(dt));
    linearise(positions_);
    whole_turn_.reset();
    if (has_point_law())
        take_out_turn();

    NodalVectors forces = external_forces_ + gravity * masses_.transpose();
    start_velocities_ = velocities_;
    loads_ = momenta() + dt * forces;
    elasticity_->add_forces(positions_, forces);
    const NodalVectors rhs = momenta() + dt * forces;

    // the first guess: the same change again, right for a free fall and for a body at rest
    velocities_ += last_prediction_;
    solver_.solve(*elasticity_, fixed_, mass_scale(dt), stiffness_scale(dt), rhs, velocities_, 0, turn());
    mended_impulses_.setZero();
    mended_response_.setZero();
    least_change_ = std::sqrt(mass()) * std::max(gravity.norm() * dt, approach.least_change * length_ / dt);
    if (has_point_law())
        reach_end(dt);
    approaches_ = false;
    last_prediction_ = velocities_ - start_velocities_;
}
//! [predict]

/// Fixed nodes count as at rest, also where something moves them.
NodalVectors ElasticBody::free_velocities() const
{
    NodalVectors velocities = velocities_;
    for (int node = 0; node < node_count(); ++node)
        if (fixed_[node])
            velocities.col(node).setZero();
    return velocities;
}

//! [missing]
/// Frames, forces and K are those of where the step ends with the present velocities.
ElasticBody::Missing ElasticBody::find_missing(double dt)
{
    const NodalVectors v = free_velocities(), end = positions_ + dt * v,
                       momenta = mass_scale(dt) * (v * mass_matrix_);
    linearise(end);
    NodalVectors strains = v, forces = NodalVectors::Zero(3, node_count());
    if (turn())
        turn()->remove_turn(strains);
    if (material_.stiffness_damping > 0)
        elasticity_->add_stiffness_times(strains, -material_.stiffness_damping, forces);
    elasticity_->add_forces(end, forces);
    if (turn())
        turn()->remove_torque(forces);
    return {loads_ + dt * forces - momenta,
            0.5 * v.cwiseProduct(momenta).sum() - v.cwiseProduct(loads_).sum() + elasticity_->energy(end)};
}
//! [missing]

//! [approach_end]
double ElasticBody::approach_end(double dt)
{
    if (!std::exchange(approaches_, true))
        take_out_turn();
    const Missing begin = find_missing(dt);
    const NodalVectors start = velocities_, made = free_velocities() - start_velocities_;
    const double made_speed = std::hypot(std::sqrt(made.cwiseProduct(made * mass_matrix_).sum()),
                                         least_change_);

    NodalVectors change = NodalVectors::Zero(3, node_count());
    solver_.solve(*elasticity_, fixed_, mass_scale(dt), stiffness_scale(dt), begin.impulses, change,
                  std::pow(made_speed * approach.error / options_.solver_tolerance, 2), turn());
    velocities_ += change;
    const double slope = change.cwiseProduct(begin.impulses).sum(), speed = std::sqrt(std::abs(slope));
    if (speed > small_imbalance * made_speed)
        cut_change(start, change, begin.potential, slope, dt);
    return speed / made_speed;
}

/// Halves a change until Phi falls as its slope says, or less is missing.
void ElasticBody::cut_change(const NodalVectors& start, const NodalVectors& change, double potential,
                             double slope, double dt)
{
    double share = 1;
    for (int i = 0; i < approach.halvings; ++i, share /= 2) {
        velocities_ = start + share * change;
        const Missing end = find_missing(dt);
        if (end.potential <= potential - approach.descent * share * slope)
            return;
        const double left = std::abs(end.impulses.cwiseProduct(near_response(end.impulses)).sum());
        if (left <= std::pow(1 - approach.descent * share, 2) * std::abs(slope))
            return;
    }
}
//! [approach_end]

double ElasticBody::reach_end(double dt)
{
    double found = approach_end(dt);
    for (int i = 1; i < approach.steps && found > small_imbalance; ++i)
        found = approach_end(dt);
    return found;
}

//! [respond]
void ElasticBody::respond(const NodalVectors& impulses, double dt)
{
    // the first guess; the solver takes its best multiple, so that it cannot harm
    NodalVectors change = last_response_;
    solver_.solve(*elasticity_, fixed_, mass_scale(dt), stiffness_scale(dt), impulses, change, 0, turn());
    velocities_ += change;
    loads_ += impulses;
    last_response_ = change;
}
//! [respond]

//! [mend_response]
void ElasticBody::mend_response(const NodalVectors& impulses, double dt)
{
    const double given = std::abs(mended_impulses_.cwiseProduct(mended_response_).sum());
    NodalVectors change = given > 0 ? NodalVectors(NodalVectors::Zero(3, node_count())) : last_response_;
    solver_.solve(*elasticity_, fixed_, mass_scale(dt), stiffness_scale(dt), impulses, change, given, turn());
    velocities_ += change;
    loads_ += impulses;
    mended_impulses_ += impulses;
    mended_response_ += change;
    last_response_ = mended_response_;
}
//! [mend_response]

WholeAssembly& ElasticBody::whole_assembly() const
{
    if (!whole_assembly_)
        whole_assembly_.emplace(mesh_, mass_matrix_, fixed_, !has_point_law());
    return *whole_assembly_;
}

WholeMatrix ElasticBody::whole_matrix(double dt) const
{
    WholeMatrix whole = whole_assembly().assemble(*elasticity_, turn(), mass_scale(dt), stiffness_scale(dt));
    whole.respond = [this](const Eigen::VectorXd& momentum) -> Eigen::VectorXd {
        const NodalVectors impulses = momentum.reshaped(3, node_count());
        return whole_assembly().values(near_response(whole_assembly().on_coefficients(impulses))).reshaped();
    };
    return whole;
}

void ElasticBody::commit(double dt)
{
    positions_ += dt * velocities_;
    if (approaches_)
        take_out_turn();
}

/// The rotations are those of the last prediction; a law with one frame an element takes its frames anew.
template <class Work>
auto ElasticBody::with_present_elasticity(const Work& work) const
{
    if (has_point_law())
        return work(*elasticity_);
    ElementRotations rotations = rotations_;
    if (!options_.freeze_rotations)
        find_rotations(mesh_, positions_, rotations);
    return work(CorotatedElasticity(mesh_, lame_, rotations));
}

NodalVectors ElasticBody::elastic_forces() const
{
    NodalVectors forces = NodalVectors::Zero(3, node_count());
    with_present_elasticity([&](const Elasticity& elasticity) { elasticity.add_forces(positions_, forces); });
    return forces;
}

double ElasticBody::elastic_energy() const
{
    return with_present_elasticity(
        [&](const Elasticity& elasticity) { return elasticity.energy(positions_); });
}

double ElasticBody::kinetic_energy() const { return 0.5 * velocities_.cwiseProduct(momenta()).sum(); }

Vec3 ElasticBody::centre_of_mass() const { return positions_ * masses_ / mass(); }

Vec3 ElasticBody::linear_momentum() const { return velocities_ * masses_; }

Vec3 ElasticBody::angular_momentum(const Vec3& about) const
{
    const NodalVectors momenta = this->momenta();
    Vec3 sum = Vec3::Zero();
    for (int n = 0; n < node_count(); ++n)
        sum += (positions_.col(n) - about).cross(momenta.col(n));
    return sum;
}

}  // namespace enduring
