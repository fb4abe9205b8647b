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
}

void ElasticBody::release(int node)
{
    fixed_[node] = 0;
    inverse_masses_[node] = 1 / masses_[node];
    solver_.forget_factor();  // in which the node stands
}

void ElasticBody::linearise(const NodalVectors& positions)
{
    if (!options_.freeze_rotations)
        find_rotations(mesh_, positions, rotations_);
    elasticity_->linearise(positions);
    const bool is_free = std::find(fixed_.begin(), fixed_.end(), 1) == fixed_.end();
    whole_turn_.reset();
    if (has_point_law() && is_free)
        whole_turn_.emplace(positions, mass_matrix_);
}

//! [predict]
void ElasticBody::predict(const Vec3& gravity, double dt)
{
    if (!(dt > 0 && std::isfinite(dt)))
        throw InputError("dt (length of the step, s) must be positive and finite, not " + std::to_string(dt));
    linearise(positions_);

    const NodalVectors outside = external_forces_ + gravity * masses_.transpose();
    NodalVectors forces = outside;
    elasticity_->add_forces(positions_, forces);
    const NodalVectors rhs = momenta() + dt * forces;

    const NodalVectors before = velocities_;
    // the first guess: the same change again, right for a free fall and for a body at rest
    velocities_ += last_prediction_;
    solver_.solve(*elasticity_, fixed_, 1 + dt * material_.mass_damping,
                  dt * (dt + material_.stiffness_damping), rhs, velocities_, 0, turn());
    if (has_point_law())
        follow_forces(before, outside, dt);
    last_prediction_ = velocities_ - before;
    mended_impulses_.setZero();
    mended_response_.setZero();
}
//! [predict]

namespace {

/// How a step that gains energy is mended.
struct Mending {
    double gain = 1e-3;     ///< of the energy, from which on it counts: a turn of 0.05 in a step gains less
    double enough = 1e-3;   ///< change of the velocities at which it ends, relative
    int steps = 30;         ///< of Newton's method, each with at most ...
    int halvings = 12;      ///< ... as many of its length
    double descent = 1e-4;  ///< Armijo's share of the slope
};
constexpr Mending mending;

}  // namespace

//! [follow_forces]
/// Phi(v) = v.Mv/2 - v.(M v0 + dt f_ext) + E(x + dt v) is least where the forces are those of the step's end. The linear step is
/// the first of Newton's method; K keeps its scale, so that the factor serves on. No stiffness damping.
void ElasticBody::follow_forces(const NodalVectors& before, const NodalVectors& outside, double dt)
{
    const double mass_scale = 1 + dt * material_.mass_damping;
    const NodalVectors pushed = before * mass_matrix_ + dt * outside;
    const auto elastic = [&](const NodalVectors& v) { return elasticity_->energy(positions_ + dt * v); };
    const auto phi = [&](const NodalVectors& v) {
        return 0.5 * mass_scale * v.cwiseProduct(v * mass_matrix_).sum() - v.cwiseProduct(pushed).sum() +
               elastic(v);
    };
    const double had = 0.5 * before.cwiseProduct(before * mass_matrix_).sum() +
                       elasticity_->energy(positions_);
    const double has = kinetic_energy() + elastic(velocities_) - dt * velocities_.cwiseProduct(outside).sum();
    if (has <= had * (1 + mending.gain) || !velocities_.allFinite())
        return;

    const auto start_of_turn = whole_turn_;
    NodalVectors v = before, change = velocities_ - before;
    double least = phi(v), slope = 0;  // the first change may lead uphill, since it is damped
    for (int step = 0; step < mending.steps; ++step) {
        double share = 1;
        for (int i = 0; i < mending.halvings && !(phi(v + share * change) <= least - share * slope); ++i)
            share /= 2;
        v += share * change;
        least = phi(v);
        if (step > 0 && change.norm() <= mending.enough * v.norm())
            break;
        linearise(positions_ + dt * v);
        NodalVectors residual = pushed - mass_scale * (v * mass_matrix_), forces = 0 * v;
        elasticity_->add_forces(positions_ + dt * v, forces);
        residual += dt * forces;
        change = NodalVectors::Zero(3, node_count());
        solver_.solve(*elasticity_, fixed_, mass_scale, dt * (dt + material_.stiffness_damping), residual,
                      change);
        slope = mending.descent * change.cwiseProduct(residual).sum();
    }
    velocities_ = v;
    whole_turn_ = start_of_turn;
    if (whole_turn_)
        whole_turn_->add_turn(
            whole_turn_->torque(pushed) / mass_scale - whole_turn_->angular_momentum(velocities_),
            velocities_);
}
//! [follow_forces]

//! [respond]
void ElasticBody::respond(const NodalVectors& impulses, double dt)
{
    // the first guess; the solver takes its best multiple, so that it cannot harm
    NodalVectors change = last_response_;
    solver_.solve(*elasticity_, fixed_, 1 + dt * material_.mass_damping,
                  dt * (dt + material_.stiffness_damping), impulses, change, 0, turn());
    velocities_ += change;
    last_response_ = change;
}
//! [respond]

//! [mend_response]
void ElasticBody::mend_response(const NodalVectors& impulses, double dt)
{
    const double given = std::abs(mended_impulses_.cwiseProduct(mended_response_).sum());
    NodalVectors change = given > 0 ? NodalVectors(NodalVectors::Zero(3, node_count())) : last_response_;
    solver_.solve(*elasticity_, fixed_, 1 + dt * material_.mass_damping,
                  dt * (dt + material_.stiffness_damping), impulses, change, given, turn());
    velocities_ += change;
    mended_impulses_ += impulses;
    mended_response_ += change;
    last_response_ = mended_response_;
}
//! [mend_response]

void ElasticBody::commit(double dt) { positions_ += dt * velocities_; }

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
