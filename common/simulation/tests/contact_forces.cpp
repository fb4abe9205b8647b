#include "common/simulation/contact_forces.hpp"

#include "common/simulation/driven_body.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace enduring;

namespace {

/// Three masses of 1 kg at rest that the plane below carries, each by a pair.
struct CarriedSheet {
    World world;
    Contacts contacts;
    double weight = 3 * 9.81;

    CarriedSheet()
    {
        world.bodies.push_back(triangle("sheet"));
        world.planes.push_back({"ground"});
        for (const int v : {0, 1, 2})
            contacts.push_back({ContactKind::vertex_plane, 0, 0, v, -1, {v, -1, -1, -1}, {1, 0, 0, 0}});
    }
};

/// Gives each pair a third of the weight over the part of the step that runs; the first `bad` attempts end in
/// trouble.
Solver carrying(double weight, int bad)
{
    Solver solver;
    solver.max_halvings = 4;
    auto left = std::make_shared<int>(bad);
    solver.append(StepStage::respond, "carry", [weight](World&, Contacts& contacts, double dt) {
        for (Contact& contact : contacts)
            contact.impulse = Vec3(0, weight / 3 * dt, 0);
    });
    solver.append(StepStage::finish, "trouble", [left](World& world, Contacts&, double) {
        if (world.attempt.may_be_halved && (*left)-- > 0)
            world.attempt.trouble = StepTrouble::too_deep;
    });
    return solver;
}

}  // namespace

TEST_CASE("contact forces: a weight that is carried is the weight, in however many parts the step was taken")
{
    for (const double dt : {0.001, 0.02})
        for (int bad = 0; bad <= 3; ++bad)
            for (const double began : {0.0, 7.3, 3000.0}) {
                CAPTURE(dt);
                CAPTURE(bad);
                CAPTURE(began);
                CarriedSheet scene;
                scene.world.time = began;
                advance(scene.world, scene.contacts, carrying(scene.weight, bad), dt);
                CHECK(scene.world.thrown_away == bad);
                const std::vector<Vec3> forces = body_forces(scene.world, scene.contacts, dt);
                CHECK(forces.at(0).y() == doctest::Approx(scene.weight).epsilon(1e-14));
            }
}

TEST_CASE("contact forces: they are those of the last part also if the first body moves as given")
{
    CarriedSheet scene;
    const SurfaceMesh tetrahedron{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()},
                                  {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    scene.world.bodies.insert(scene.world.bodies.begin(),
                              std::make_unique<DrivenBody>("drive", tetrahedron, Vec3::Zero(),
                                                           GivenMotion::steady(Vec3::UnitX(), Vec3::Zero())));
    for (Contact& contact : scene.contacts)
        contact.body_a = 1;
    advance(scene.world, scene.contacts, carrying(scene.weight, 2), 0.01);
    CHECK(scene.world.thrown_away == 2);
    CHECK(body_forces(scene.world, scene.contacts, 0.01).at(1).y() ==
          doctest::Approx(scene.weight).epsilon(1e-14));
}

TEST_CASE(
    "contact forces: a step that was taken as a whole is divided by dt to the last bit, also before any step")
{
    CarriedSheet scene;
    CHECK(last_part(scene.world, 0.01) == 0.01);
    for (int step = 0; step < 100; ++step) {
        advance(scene.world, scene.contacts, carrying(scene.weight, 0), 0.01);
        CHECK(last_part(scene.world, 0.01) == 0.01);
    }
    CHECK(last_part({}, 0.01) == 0.01);
}

TEST_CASE("contact forces: what a pair gives one body it takes from the other, by the pair's weights")
{
    World world;
    world.bodies.push_back(triangle("upper", 0.25));
    world.bodies.push_back(triangle("lower"));
    Contact pair{ContactKind::vertex_face, 0, 1, 1, 0, {1, 0, 1, 2}, {1, -0.5, -0.25, -0.25}};
    pair.impulse = {0, 4, 0};
    pair.friction = {1, 0, 0};
    const auto forces = vertex_forces(world, {pair}, 0.5);
    CHECK(forces[0][1] == Vec3(2, 8, 0));
    CHECK(forces[1][0] == Vec3(-1, -4, 0));
    CHECK(forces[1][2] == Vec3(-0.5, -2, 0));
    const std::vector<Vec3> sums = body_forces(world, {pair}, 0.5);
    CHECK(sums[0] == Vec3(2, 8, 0));
    CHECK(sums[1] == Vec3(-2, -8, 0));
}
