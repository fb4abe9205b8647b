#include "common/geometry/quadratic.hpp"
#include "common/geometry/shapes.hpp"
#include "common/simulation/deformable_body.hpp"

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

/// A bar of 12 elements, with either basis.
std::unique_ptr<DeformableBody> soft_bar(bool quadratic, const DeformableSettings& settings = soft())
{
    const TetrahedralMesh mesh = bar({1, 0.5, 0.5}, {2, 1, 1});
    if (quadratic)
        return std::make_unique<DeformableBody>("bar", with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>("bar", mesh, settings);
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
            const Vec3 lever = body->positions_t0()[static_cast<std::size_t>(vertex)] - Vec3(1, 2, 3);
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

TEST_CASE("deformable body: an impulse gives exactly its momentum and moves its vertex by the inverse mass there")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic);
        const Vec3 impulse(0.5, -1, 2), about(0.3, 0, -2);
        for (const int vertex : {0, 5, body->surface().vertex_count() - 1}) {
            CAPTURE(vertex);
            const Vec3 velocity = body->velocity(vertex), linear = body->linear_momentum(), angular = body->angular_momentum(about);
            const std::vector<Vec3> before(body->positions_t1().begin(), body->positions_t1().end());
            const Vec3 point = body->positions_t0()[static_cast<std::size_t>(vertex)];
            body->apply_impulse(vertex, impulse);
            CHECK((body->linear_momentum() - linear - impulse).norm() < 1e-12);
            CHECK((body->angular_momentum(about) - angular - (point - about).cross(impulse)).norm() < 1e-12);
            CHECK((body->velocity(vertex) - velocity - body->inverse_mass(vertex) * impulse).norm() < 1e-12);
            CHECK(std::equal(before.begin(), before.end(), body->positions_t1().begin()));
        }
    }
}

TEST_CASE("deformable body: an impulse does the same work on the nodes as on its vertex")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(quadratic, soft({0, -1, 0}, {1, 0, 2}));
        const Vec3 impulse(0.5, -1, 2);
        for (const int vertex : {1, body->surface().vertex_count() - 1}) {
            const double before = body->energy(Vec3::Zero()).kinetic;
            const Vec3 v0 = body->velocity(vertex);
            body->apply_impulse(vertex, impulse);
            const double work = impulse.dot(v0 + body->velocity(vertex)) / 2;
            CHECK(body->energy(Vec3::Zero()).kinetic - before == doctest::Approx(work).epsilon(1e-10));
        }
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
    const Vec3 start = body->positions_t0()[static_cast<std::size_t>(pinned)];
    CHECK(body->inverse_mass(pinned).isZero());
    for (int n = 0; n < 3; ++n) {
        body->predict({0, -9.81, 0}, 0.02);
        body->apply_impulse(pinned, {1, 2, 3});
        body->commit(0.02);
    }
    CHECK(body->positions_t0()[static_cast<std::size_t>(pinned)] == start);
    CHECK(body->energy(Vec3::Zero()).kinetic > 0);
}
