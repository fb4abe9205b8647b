#include "../edge_edge_dismissal.hpp"
#include "../redefinition_solver.hpp"
#include "../resolution.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/run.hpp"
#include "common/simulation/step_record.hpp"
#include "common/simulation/worked_step.hpp"
#include "small_worlds.hpp"

#include <cmath>

using namespace enduring;

namespace {

/// Chapter 6's passes without the edge pairs that redefinitions bring: the page's worked step knows vertices and faces alone.
Solver without_edge_pairs(double stiffness)
{
    Solver solver = chapter06_solver({PenaltyMethod::continuous, stiffness});
    solver.enduring.back().run = [](World& world, Contacts& contacts, double) {
        Redefinitions redefinitions;
        redefine_enduring_vertices(world, contacts, redefinitions);
        drop_resolved(contacts);
    };
    return solver;
}

void check_equal(const std::vector<Vec3>& found, const std::vector<Vec3>& expected)
{
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        CHECK((found[i] - expected[i]).norm() < 1e-14);
    }
}

}  // namespace

TEST_CASE("worked step: redefinition, detection and impulses of this chapter give the page's numbers")
{
    WorkedStep by_hand = worked_step(), by_chapter = worked_step();
    const StageRecord expected =
        record_step(by_hand.world, by_hand.contacts, worked_step_solver(by_hand.stiffness), by_hand.dt).back();
    const StageRecord found =
        record_step(by_chapter.world, by_chapter.contacts, without_edge_pairs(by_chapter.stiffness), by_chapter.dt).back();
    for (std::size_t body = 0; body < 2; ++body) {
        check_equal(found.bodies[body].velocities, expected.bodies[body].velocities);
        check_equal(found.bodies[body].positions_t0, expected.bodies[body].positions_t0);
    }
    REQUIRE(found.contacts.size() == expected.contacts.size());
    for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
        CAPTURE(i);
        CHECK(found.contacts[i].vertices == expected.contacts[i].vertices);
        for (std::size_t j = 0; j < 4; ++j)
            CHECK(found.contacts[i].weights[j] == doctest::Approx(expected.contacts[i].weights[j]).epsilon(1e-14));
        CHECK(found.contacts[i].start == doctest::Approx(expected.contacts[i].start).epsilon(1e-6));
        CHECK((found.contacts[i].impulse - expected.contacts[i].impulse).norm() < 1e-14);
    }
}

TEST_CASE("worked step: with vertex 2 come the two edges that lie over the diagonal, at depths worked out by hand")
{
    WorkedStep step = worked_step();
    follow_enduring_pairs(step.world, step.contacts);
    Contacts edges;
    for (const Contact& contact : step.contacts)
        if (contact.kind == ContactKind::edge_edge)
            edges.push_back(contact);
    REQUIRE(edges.size() == 2);
    // From (0.5, 0.1, 0.5) and from (0.5, -0.1, 1) to (1.5, -0.2, 1.5): over x + z = 2 at y = -1/20 and y = -2/15. Their
    // cross products with the diagonal are (0.6, 4, 0.6) and (0.2, 3, 0.2), and the depth is n_y y / |n|.
    const double expected[] = {-0.05 * 4 / std::sqrt(16.72), -2.0 / 15 * 3 / std::sqrt(9.08)};
    for (std::size_t i = 0; i < 2; ++i) {
        const ContactGeometry geometry = contact_geometry(step.world, edges[i], 0);
        CHECK(geometry.depth == doctest::Approx(expected[i]));
        CHECK(geometry.normal.y() > 0.9);
        CHECK_FALSE(edges[i].held);
    }
}

namespace {

enum class BodyKind { rigid, linear, quadratic };

std::unique_ptr<Body> block(const std::string& name, BodyKind kind, const Vec3& place, const Vec3& velocity)
{
    if (kind == BodyKind::rigid) {
        SurfaceMesh mesh = box({1, 0.9, 1.1}, {3, 3, 3});
        for (Vec3& x : mesh.vertices)
            x += place;
        return std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 10), velocity, Vec3(0.3, 0.2, -0.5));
    }
    DeformableSettings settings;
    settings.material.density = 10;
    settings.material.young = 1e4;
    settings.material.poisson = 0.3;
    settings.position = place;
    settings.velocity = velocity;
    settings.angular_velocity = {0.3, 0.2, -0.5};
    const TetrahedralMesh mesh = bar({1, 0.9, 1.1}, {2, 1, 2});
    if (kind == BodyKind::quadratic)
        return std::make_unique<DeformableBody>(name, with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>(name, mesh, settings);
}

Vec3 momentum(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->linear_momentum();
    return sum;
}

}  // namespace

TEST_CASE("momentum: sliding, redefined pairs of every two kinds of bodies keep it to rounding")
{
    using enum BodyKind;
    for (const std::pair<BodyKind, BodyKind>& kinds :
         {std::pair{rigid, rigid}, {rigid, linear}, {linear, rigid}, {linear, quadratic}, {quadratic, rigid}}) {
        CAPTURE(static_cast<int>(kinds.first));
        CAPTURE(static_cast<int>(kinds.second));
        World world;
        world.gravity.setZero();
        world.bodies.push_back(block("above", kinds.first, {-0.3, 0.93, 0.21}, {2, -1, 0.4}));
        world.bodies.push_back(block("below", kinds.second, {0, 0, 0}, {0, 0.2, 0}));
        const Vec3 before = momentum(world);
        Contacts contacts;
        const Solver solver = chapter06_solver({PenaltyMethod::continuous, 300});
        std::size_t most = 0;
        for (int step = 0; step < 60; ++step) {
            advance(world, contacts, solver, 0.005);
            most = std::max(most, contacts.size());
            CHECK((momentum(world) - before).norm() < 1e-11 * before.norm());
        }
        CHECK(most > 3);
    }
}

TEST_CASE("solver: the same scene gives the same bytes")
{
    std::array<std::vector<double>, 2> seen;
    for (std::vector<double>& numbers : seen) {
        Scene scene = load_scene(scene_file("hooked"));
        const RunResult result = run(scene, chapter06_solver(scene.contact), {}, {80, {}});
        for (const auto& body : scene.world.bodies)
            for (const Vec3& x : body->positions_t0())
                numbers.insert(numbers.end(), {x.x(), x.y(), x.z()});
        for (const Contact& c : result.contacts)
            numbers.insert(numbers.end(), {static_cast<double>(c.feature_a), static_cast<double>(c.feature_b), c.weights[1], c.impulse.y()});
    }
    CHECK(seen[0] == seen[1]);
}
