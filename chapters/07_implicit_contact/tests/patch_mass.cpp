#include "chapters/07_implicit_contact/patch_mass.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

constexpr double wanted = 1e-3;

/// Cubes of 1 m on one another on the ground, of these masses, each with
/// that many cells along its edges.
Scene cubes(const std::vector<double>& masses, int cells, double dt)
{
    Scene scene = scene_of({}, dt);
    for (std::size_t i = 0; i < masses.size(); ++i) {
        SurfaceMesh mesh = box(Vec3::Ones(), {cells, cells, cells});
        for (Vec3& x : mesh.vertices)
            x.y() += 0.5 + static_cast<double>(i);
        scene.world.bodies.push_back(std::make_unique<RigidBody>(
            "cube " + std::to_string(i + 1), mesh, with_mass(mass_properties(mesh, 1000), masses[i])));
    }
    return scene;
}

/// Pairs of the lower side of the first cube with the ground.
Contacts on_the_ground(const World& world)
{
    Contacts contacts;
    const auto positions = world.bodies[0]->positions_t0();
    for (int vertex = 0; vertex < static_cast<int>(positions.size()); ++vertex)
        if (std::abs(positions[static_cast<std::size_t>(vertex)].y()) < 1e-9) {
            Contact contact{ContactKind::vertex_plane, 0, 0, vertex, -1};
            contact.vertices[0] = vertex;
            contact.weights[0] = 1;
            contacts.push_back(contact);
        }
    return contacts;
}

}  // namespace

TEST_CASE("patch mass: the pairs of a cube share its mass, however many there are, and alike")
{
    for (const int cells : {1, 2, 4}) {
        Scene scene = cubes({30}, cells, 0.01);
        scene.world.bodies[0]->predict(scene.world.gravity, scene.dt);
        Contacts contacts = on_the_ground(scene.world);
        REQUIRE(static_cast<int>(contacts.size()) == (cells + 1) * (cells + 1));
        const StepProblem step = set_up(scene.world, contacts, {}, {}, {1, scene.dt}, true);
        for (const double mass : patch_masses(step))
            CHECK(mass == doctest::Approx(30.0 / static_cast<double>(contacts.size())));
    }
}

TEST_CASE("patch mass: a pair that is alone has the mass that it feels, which a turn makes smaller")
{
    Scene scene = cubes({30}, 1, 0.01);
    scene.world.bodies[0]->predict(scene.world.gravity, scene.dt);
    Contacts contacts = on_the_ground(scene.world);
    contacts.resize(1);
    const StepProblem step = set_up(scene.world, contacts, {}, {}, {1, scene.dt}, true);
    CHECK(patch_masses(step).at(0) == doctest::Approx(30.0 / 4).epsilon(1e-3));  // m, and r^2 / I = 3 / m
}

TEST_CASE("wanted depth: as a goal it is reached within a fifth, whatever the mass, the mesh and the step")
{
    for (const double mass : {1.0, 1000.0})
        for (const int cells : {1, 4})
            for (const double dt : {0.002, 0.02}) {
                CAPTURE(mass);
                CAPTURE(cells);
                CAPTURE(dt);
                Scene scene = cubes({mass}, cells, dt);
                const PileOutcome outcome = watch(scene, 1, nullptr,
                                                  {.wanted_depth = wanted, .is_goal = true});
                CHECK(outcome.deepest_mm == doctest::Approx(1000 * wanted).epsilon(0.2));
                CHECK(outcome.energy_gain_j <= 1e-9);
            }
}

TEST_CASE(
    "wanted depth: as a goal it is reached in a stack of three, too, whose lowest joint carries all of them")
{
    Scene scene = cubes({10, 10, 10}, 1, 0.01);
    const PileOutcome outcome = watch(scene, 3, nullptr, {.wanted_depth = wanted, .is_goal = true});
    CHECK(outcome.deepest_mm == doctest::Approx(1000 * wanted).epsilon(0.2));
}

TEST_CASE("pair memory: a stiffness falls with its load where the depth is a goal, slowly and without a jump")
{
    const StiffnessChoice goal{.of_its_mass = 1, .wanted_depth = wanted, .is_goal = true};
    Contact contact;
    adapt_stiffness(contact, 0, 1, goal, 0.01);
    contact.stiffness = 1e5;
    contact.load = 10;
    const double depth = -1e-4, force = -contact.stiffness * depth;
    adapt_stiffness(contact, depth, 1, goal, 0.01);
    CHECK(contact.stiffness == doctest::Approx(1e5 * std::exp(-0.01 / goal.forgets_in)));
    CHECK(contact.slack > 0);
    CHECK(-contact.stiffness * (depth - contact.slack / goal.keep) == doctest::Approx(force));
    for (int i = 0; i < 1000; ++i)
        adapt_stiffness(contact, 1e-6, 1, goal, 0.01);
    CHECK(contact.stiffness == doctest::Approx(1e4));  // load / depth; its mass asks for as much
}
