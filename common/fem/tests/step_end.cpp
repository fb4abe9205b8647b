#include "common/fem/tests/bodies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

using namespace enduring;
using namespace enduring::test;

namespace {

const Vec3 falls(0, -9.81, 0);

/// A bar that is thrown and bent hard: its elements turn by tenths of a radian in a step.
/// @param damping  beta [s]; alpha is a thousand times as large [1/s]
std::unique_ptr<ElasticBody> bent_bar(Basis basis, double damping = 0)
{
    auto body = std::make_unique<ElasticBody>(
        elastic(bar({1, 0.2, 0.2}, {5, 1, 1}), basis),
        ElasticMaterial{
            .young = 1e5, .poisson = 0.3, .mass_damping = 1000 * damping, .stiffness_damping = damping});
    for (int node = 0; node < body->node_count(); ++node) {
        const Vec3 x = body->positions().col(node);
        body->velocities().col(node) = Vec3(0, 40 * x.x() * x.x(), 10 * x.x());
    }
    return body;
}

/// What is missing on the free nodes in
///   M (v_new - v) = dt (M g + Q^T f_el(x + dt v_new) - alpha M v_new - beta Q^T K Q v_new) + impulses,
/// with K of the end, and Q where no node is fixed [N s].
double missing(const ElasticBody& body, const NodalVectors& before, const NodalVectors& impulses, double dt)
{
    const ElasticMaterial& material = body.material();
    ElasticBody end(body.mesh(), material);
    end.positions() = body.positions() + dt * body.velocities();
    ElementRotations rotations(body.mesh().elements().size(), Mat3::Identity());
    find_rotations(body.mesh(), end.positions(), rotations);
    const CorotatedElasticity elasticity(body.mesh(), lame_constants(material), rotations);
    const WholeTurn turn(body.positions(), body.mass_matrix());
    const bool is_free = (body.inverse_masses().array() > 0).all();
    NodalVectors strains = body.velocities(), forces = end.elastic_forces();
    if (is_free)
        turn.remove_turn(strains);
    elasticity.add_stiffness_times(strains, -material.stiffness_damping, forces);
    if (is_free)
        turn.remove_torque(forces);
    const double mass_scale = 1 + dt * material.mass_damping;
    NodalVectors sum = (mass_scale * body.velocities() - before) * body.mass_matrix() - impulses -
                       dt * (forces + falls * body.masses().transpose());
    for (int node = 0; node < body.node_count(); ++node)
        if (body.inverse_masses()[node] == 0)
            sum.col(node).setZero();
    return sum.norm();
}

double energy_of(const ElasticBody& body) { return body.kinetic_energy() + body.elastic_energy(); }

/// Most energy that a bar has which is twisted by a turn and let go, over that at first.
double most_after_twist(bool settles)
{
    ElasticBody body(elastic(bar({1, 0.2, 0.2}, {10, 2, 2}), Basis::linear), {.young = 1e6, .poisson = 0.3});
    for (int node = 0; node < body.node_count(); ++node) {
        const Vec3 x = body.positions().col(node);
        if (x.x() < -0.5 + 1e-9)
            body.fix(node);
        body.positions().col(node) = Eigen::AngleAxisd(2 * std::numbers::pi * (x.x() + 0.5), Vec3::UnitX()) *
                                     x;
    }
    const double start = energy_of(body);
    double most = start;
    for (int step = 0; step < 10; ++step) {
        body.predict(Vec3::Zero(), 0.01);
        if (settles)
            body.reach_end(0.01);
        body.commit(0.01);
        most = std::max(most, energy_of(body));
    }
    return most / start;
}

}  // namespace

TEST_CASE("step end: a body that has settled has the forces of the end of its step, its impulses included")
{
    const double dt = 0.01;
    for (const Basis basis : both_bases)
        for (const double damping : {0.0, 0.01})
            for (const bool is_held : {false, true}) {
                CAPTURE(name_of(basis));
                CAPTURE(damping);
                CAPTURE(is_held);
                const auto body = bent_bar(basis, damping);
                NodalVectors impulses = random_field(body->node_count(), 0.05, 3);
                if (is_held) {
                    body->fix(0);
                    impulses.col(0).setZero();
                }
                const NodalVectors before = body->velocities();
                body->predict(falls, dt);
                if (is_held)
                    body->mend_response(impulses, dt);
                else
                    body->respond(impulses, dt);
                const double linear = missing(*body, before, impulses, dt);
                CHECK(body->reach_end(dt) <= small_imbalance);
                CHECK(missing(*body, before, impulses, dt) <= 0.01 * linear);
                CHECK(body->approach_end(dt) <= 0.1 * small_imbalance);
                CHECK(missing(*body, before, impulses, dt) <= 2e-4 * linear);
            }
}

TEST_CASE("step end: a body at rest without gravity has nothing to settle")
{
    ElasticBody body(elastic(bar({1, 0.2, 0.2}, {5, 1, 1}), Basis::linear), {.young = 1e5, .poisson = 0.3});
    body.predict(Vec3::Zero(), 0.01);
    CHECK(body.reach_end(0.01) < 1e-3);
    CHECK(body.velocities().norm() < 1e-12);
}

TEST_CASE(
    "step end: a free body that settles keeps its angular momentum to rounding, and its impulses' levers")
{
    for (const Basis basis : both_bases)
        for (const double damping : {0.0, 0.01}) {
            CAPTURE(name_of(basis));
            CAPTURE(damping);
            const auto body = bent_bar(basis, damping);
            const double kept = 1 /
                                (1 + 0.01 * body->material().mass_damping);  // of angular momentum in a step
            Vec3 turning = body->angular_momentum(Vec3::Zero());
            for (int step = 0; step < 20; ++step) {
                NodalVectors impulses = random_field(body->node_count(), 0.01, 7);
                for (int node = 0; node < body->node_count(); ++node)
                    turning += Vec3(body->positions().col(node)).cross(Vec3(impulses.col(node)));
                body->predict(Vec3::Zero(), 0.01);
                body->reach_end(0.01);
                body->mend_response(impulses, 0.01);
                body->reach_end(0.01);
                body->commit(0.01);
                turning *= kept;
                body->respond(impulses, 0.01);  // as restitution does, where the bodies are now
                for (int node = 0; node < body->node_count(); ++node)
                    turning += kept * Vec3(body->positions().col(node)).cross(Vec3(impulses.col(node)));
            }
            CHECK((body->angular_momentum(Vec3::Zero()) - turning).norm() <= 1e-9 * turning.norm());
        }
}

TEST_CASE(
    "step end: a bar that is twisted by a turn and let go gains no energy, and without the end twice what it had")
{
    CHECK(most_after_twist(true) <= 1 + 1e-3);
    CHECK(most_after_twist(false) > 1.5);
}
