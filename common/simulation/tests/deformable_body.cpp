#include "common/simulation/deformable_body.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/source_directory.hpp"
#include "common/rigid/mass_properties.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace enduring;

namespace {

DeformableSettings soft(const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero())
{
    DeformableSettings settings;
    settings.material.young = 1e4;
    settings.material.density = 500;
    settings.rotation = Eigen::AngleAxisd(0.6, Vec3(1, 1, 0).normalized()).toRotationMatrix();
    settings.position = {1, 2, 3};
    settings.velocity = velocity;
    settings.angular_velocity = spin;
    return settings;
}

std::unique_ptr<DeformableBody> soft_body(const TetrahedralMesh& mesh, bool quadratic,
                                          const DeformableSettings& settings)
{
    if (quadratic)
        return std::make_unique<DeformableBody>("body", with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>("body", mesh, settings);
}

/// A bar of 12 elements, with either basis.
std::unique_ptr<DeformableBody> soft_bar(bool quadratic, const DeformableSettings& settings = soft())
{
    return soft_body(bar({1, 0.5, 0.5}, {2, 1, 1}), quadratic, settings);
}

}  // namespace

TEST_CASE("deformable body: it starts unstrained where it was placed, moving as one")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic, soft({0, -1, 0}, {1, 0, 2}));
        CHECK(body->mass() == doctest::Approx(125));
        CHECK(body->energy(Vec3::Zero()).elastic == doctest::Approx(0).epsilon(1e-12));
        CHECK((body->linear_momentum() - Vec3(0, -125, 0)).norm() < 1e-10);
        CHECK(body->energy({0, -10, 0}).gravitational == doctest::Approx(125 * 10 * 2));
        // The corner of the bar farthest along its own x, y and z, where the rotation puts it.
        const Vec3 corner = soft().rotation * Vec3(0.5, 0.25, 0.25) + soft().position;
        double nearest = 1;
        for (const Vec3& vertex : body->positions_t0())
            nearest = std::min(nearest, (vertex - corner).norm());
        CHECK(nearest < 1e-14);
        for (int vertex = 0; vertex < body->surface().vertex_count(); ++vertex) {
            const Vec3 lever = body->positions_t0()[vertex] - Vec3(1, 2, 3);
            CHECK((body->velocity(vertex) - Vec3(0, -1, 0) - Vec3(1, 0, 2).cross(lever)).norm() < 1e-12);
        }
    }
}

TEST_CASE("deformable body: free fall is symplectic Euler at every surface vertex")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic);
        const std::vector<Vec3> start(body->positions_t0().begin(), body->positions_t0().end());
        for (int n = 0; n < 10; ++n) {
            body->predict({0, -9.81, 0}, 0.02);
            body->commit(0.02);
        }
        for (std::size_t i = 0; i < start.size(); ++i)
            CHECK((body->positions_t0()[i] - start[i] - Vec3(0, -9.81 * 55 * 0.02 * 0.02, 0)).norm() < 1e-9);
    }
}

TEST_CASE(
    "deformable body: a lumped impulse gives exactly its linear momentum and moves its vertex by the inverse mass there")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic);
        const Vec3 impulse(0.5, -1, 2);
        for (const int vertex : {0, 5, body->surface().vertex_count() - 1}) {
            CAPTURE(vertex);
            const Vec3 velocity = body->velocity(vertex), linear = body->linear_momentum();
            const std::vector<Vec3> before(body->positions_t1().begin(), body->positions_t1().end());
            body->apply_impulse(vertex, impulse);
            CHECK((body->linear_momentum() - linear - impulse).norm() < 1e-12);
            CHECK((body->velocity(vertex) - velocity - body->inverse_mass(vertex) * impulse).norm() < 1e-12);
            CHECK(std::equal(before.begin(), before.end(), body->positions_t1().begin()));
        }
    }
}

namespace {

/// A bar whose rotations stay as they are, so that what is exact in one step can be seen exactly.
std::unique_ptr<DeformableBody> linear_bar(bool quadratic, ImpulseResponse response)
{
    DeformableSettings settings = soft({0, -1, 0}, {1, 0, 2});
    settings.impulse_response = response;
    settings.options = {.freeze_rotations = true, .solver_tolerance = 1e-13};
    return soft_bar(quadratic, settings);
}

}  // namespace

TEST_CASE(
    "deformable body: an implicit impulse gives exactly its linear and angular momentum, and its work at the vertex")
{
    const Vec3 impulse(0.5, -1, 2), about(0.3, 0, -2);
    for (const bool quadratic : {false, true})
        for (const int vertex : {0, 5, 7}) {
            CAPTURE(quadratic);
            CAPTURE(vertex);
            const auto body = linear_bar(quadratic, ImpulseResponse::implicit);
            body->predict(Vec3::Zero(), 0.01);
            const Vec3 velocity = body->velocity(vertex), linear = body->linear_momentum(),
                       angular = body->angular_momentum(about);
            const double before = body->energy(Vec3::Zero()).total();
            const Vec3 point = body->positions_t0()[vertex];
            body->apply_impulse(vertex, impulse);
            body->update_prediction(0.01);
            CHECK((body->linear_momentum() - linear - impulse).norm() < 1e-10);
            CHECK((body->angular_momentum(about) - angular - (point - about).cross(impulse)).norm() < 1e-8);
            const double work = impulse.dot(velocity + body->velocity(vertex)) / 2;
            body->commit(0.01);
            CHECK(body->energy(Vec3::Zero()).total() - before == doctest::Approx(work).epsilon(1e-8));
        }
}

TEST_CASE(
    "deformable body: a lumped impulse turns the body and works on it by less than its lever and its way")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        DeformableSettings settings = soft();
        settings.impulse_response = ImpulseResponse::lumped;
        const auto body = soft_bar(quadratic, settings);
        const Vec3 impulse(0.5, -1, 2), lever = body->positions_t0()[0] - settings.position;
        body->apply_impulse(0, impulse);
        const Vec3 exact = lever.cross(impulse), angular = body->angular_momentum(settings.position);
        CHECK(angular.dot(exact) > 0);
        CHECK(angular.norm() < 0.95 * exact.norm());
        CHECK(body->energy(Vec3::Zero()).kinetic < 0.9 * 0.5 * impulse.dot(body->velocity(0)));
    }
}

TEST_CASE("deformable body: while it spins it has the momentum and the energy of the rigid body of its shape")
{
    const TetrahedralMesh shapes[] = {bar({3, 0.4, 0.4}, {8, 1, 1}), bar({3, 0.3, 0.8}, {12, 1, 3}),
                                      read_gmsh(source_directory() / "common/meshes/bunny_363.msh")};
    for (const TetrahedralMesh& shape : shapes)
        for (const bool quadratic : {false, true})
            for (int axis = 0; axis < 3; ++axis) {
                CAPTURE(shape.elements.size());
                CAPTURE(quadratic);
                CAPTURE(axis);
                const auto body = soft_body(shape, quadratic, soft({1, 2, -1}, Vec3::Unit(axis)));
                const MassProperties rigid = with_mass(mass_properties(surface_of(shape).mesh, 1),
                                                       body->mass());
                const Mat3 turn = soft().rotation, inertia = turn * rigid.inertia * turn.transpose();
                const Vec3 centre = turn * rigid.centre + soft().position,
                           angular = inertia * Vec3::Unit(axis);
                CHECK((body->angular_momentum(centre) - angular).norm() < 1e-10 * angular.norm());
                const double kinetic = 0.5 * body->mass() * 6 + 0.5 * angular[axis];
                CHECK(body->energy(Vec3::Zero()).kinetic == doctest::Approx(kinetic).epsilon(1e-10));
            }
}

TEST_CASE("deformable body: the predicted surface is the one that committing produces")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic, soft({0, -1, 0}, {3, 0, 2}));
        body->predict({0, -9.81, 0}, 0.02);
        body->apply_impulse(2, {3, 5, -1});
        body->update_prediction(0.02);
        const std::vector<Vec3> predicted(body->positions_t1().begin(), body->positions_t1().end());
        body->commit(0.02);
        for (std::size_t i = 0; i < predicted.size(); ++i) {
            CHECK((body->positions_t0()[i] - predicted[i]).norm() < 1e-13);
            CHECK(body->positions_t1()[i] == body->positions_t0()[i]);
        }
    }
}

TEST_CASE("deformable body: fixed nodes stay, whatever pushes them")
{
    DeformableSettings settings = soft();
    settings.fixed_nodes = {0};
    const auto body = soft_bar(false, settings);
    int pinned = -1;  // the surface vertex that is node 0
    for (int vertex = 0; vertex < body->surface().vertex_count(); ++vertex)
        if (body->embedding().nodes_of(vertex)[0].node == 0)
            pinned = vertex;
    REQUIRE(pinned >= 0);
    const Vec3 start = body->positions_t0()[pinned];
    CHECK(body->inverse_mass(pinned).isZero());
    for (int n = 0; n < 3; ++n) {
        body->predict({0, -9.81, 0}, 0.02);
        body->apply_impulse(pinned, {1, 2, 3});
        body->commit(0.02);
    }
    CHECK(body->positions_t0()[pinned] == start);
    CHECK(body->energy(Vec3::Zero()).kinetic > 0);
}

TEST_CASE("deformable body: fixed nodes take no impulse, at once or within the step, tried or applied")
{
    for (const ImpulseResponse response : {ImpulseResponse::lumped, ImpulseResponse::implicit})
        for (const bool quadratic : {false, true}) {
            CAPTURE(quadratic);
            CAPTURE(response == ImpulseResponse::implicit);
            DeformableSettings settings = soft();
            settings.impulse_response = response;
            settings.fixed_nodes = {0, 1, 2};
            const auto body = soft_bar(quadratic, settings);
            body->predict({0, -9.81, 0}, 0.02);
            for (int vertex = 0; vertex < body->surface().vertex_count(); ++vertex) {
                CAPTURE(vertex);
                const Vec3 impulse(1, 2, 3), before = body->velocity(vertex);
                const auto nodes = body->embedding().nodes_of(vertex);
                const bool pinned = std::all_of(nodes.begin(), nodes.end(),
                                                [](const NodeWeight& n) { return n.node < 3; });
                const std::unique_ptr<Trial> trial = body->begin_trial();
                trial->push(vertex, impulse);
                const Vec3 tried = trial->velocity(vertex), answer = body->inverse_mass(vertex) * impulse;
                body->apply_impulse(vertex, impulse);
                body->update_prediction(0.02);
                const Vec3 after = body->velocity(vertex);
                CHECK((after - before - answer).norm() <= 1e-5 * answer.norm());
                CHECK((tried - after).norm() <= 1e-5 * answer.norm());
                if (pinned)
                    CHECK(after.norm() + tried.norm() + body->inverse_mass(vertex).norm() == 0);
                else
                    CHECK(answer.norm() > 0);
                for (int node = 0; node < 3; ++node)
                    CHECK(body->elastic().velocities().col(node).norm() == 0);
            }
        }
}
