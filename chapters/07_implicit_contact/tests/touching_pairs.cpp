#include "chapters/07_implicit_contact/touching_pairs.hpp"
#include "chapters/06_redefinition/experiments/laid_block.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// A cube of 0.8 m whose lower side is at a height, on a fixed one of 1 m
/// whose upper side is at 1, shifted along it.
World cube_on_cube(double height, double shift = 0)
{
    World world;
    SurfaceMesh below = box(Vec3::Ones()), above = box(Vec3::Constant(0.8));
    for (Vec3& x : below.vertices)
        x.y() = x.y() < 0 ? 0 : 1;
    for (Vec3& x : above.vertices) {
        x.y() = x.y() < 0 ? height : height + 0.8;
        x.x() += shift;
    }
    world.bodies.push_back(std::make_unique<StaticBody>(
        "below", SurfaceTopology(static_cast<int>(below.vertices.size()), below.faces), below.vertices));
    world.bodies.push_back(
        std::make_unique<RigidBody>("above", above, with_mass(mass_properties(above, 1000), 10)));
    return world;
}

/// The pairs that touch if the upper cube moves like this in the first step.
Contacts touching(World& world, const Vec3& way)
{
    world.bodies[1]->predict(way / 1e-4, 0.01);
    Contacts contacts;
    append_touching_pairs(world, contacts);
    return contacts;
}

std::set<int> corners_of(const Contacts& contacts)
{
    std::set<int> corners;
    for (const Contact& contact : contacts)
        if (contact.kind == ContactKind::vertex_face && contact.body_a == 1)
            corners.insert(contact.feature_a);
    return corners;
}

}  // namespace

TEST_CASE("touching pairs: corners on a face, or a rounding off it, touch if they sink, and else they do not")
{
    const double rounding = 1.1e-16;
    for (const double height : {1 - 4 * rounding, 1 - rounding, 1.0, 1 + 2 * rounding}) {
        CAPTURE(height - 1);
        World sinking = cube_on_cube(height), rising = cube_on_cube(height), sliding = cube_on_cube(height);
        const Contacts contacts = touching(sinking, Vec3(0, -1e-3, 0));
        CHECK(corners_of(contacts).size() == 4);
        for (const Contact& contact : contacts) {
            CHECK(contact.start == 0);
            CHECK(contact.endures());
        }
        CHECK(corners_of(touching(rising, Vec3(0, 1e-3, 0))).empty());
        CHECK(corners_of(touching(sliding, Vec3(1e-3, 0, 0))).empty());
    }
    for (const double height : {1 - 1e-12, 1 + 1e-12}) {
        World world = cube_on_cube(height);
        CHECK(corners_of(touching(world, Vec3(0, -1e-3, 0))).empty());
    }
}

TEST_CASE("touching pairs: where a corner hangs over, edges that cross touch, pushed out of the lower body")
{
    World world = cube_on_cube(1 - 1.1e-16, 0.4);
    const Contacts contacts = touching(world, Vec3(0, -1e-3, 0));
    CHECK(corners_of(contacts).size() == 2);
    int edges = 0;
    for (const Contact& contact : contacts)
        if (contact.kind == ContactKind::edge_edge) {
            ++edges;
            const auto [a0, a1] = world.bodies[0]->surface().edges()[contact.feature_a];
            const auto [b0, b1] = world.bodies[1]->surface().edges()[contact.feature_b];
            const auto &lower = world.bodies[0]->positions_t0(), &upper = world.bodies[1]->positions_t0();
            const Vec3 normal = contact.orientation * (lower[a1] - lower[a0]).cross(upper[b1] - upper[b0]);
            CHECK(normal.y() < 0);  // from the upper cube, B, to the lower one
        }
    CHECK(edges >= 2);
}

TEST_CASE("touching pairs: a cube laid one rounding inside another one lies there, and one that hangs over")
{
    for (const double shift : {0.0, 0.3}) {
        World world = cube_on_cube(1 - 1.1e-16, shift);
        SolveStatistics solves;
        const Solver solver = counting_solver(solves)({});
        Contacts contacts;
        for (int step = 0; step < 50; ++step)
            advance(world, contacts, solver, 0.01);
        CHECK(std::abs(world.bodies[1]->centre().y() - 1.4) < 1e-4);
    }
}

TEST_CASE("flat triangles: a block that is laid exactly on them gains no energy, wherever rounding puts it")
{
    for (const double slope : {10.0, 30.0})
        for (const double turned : {0.0, 0.6}) {
            SolveStatistics solves;
            CAPTURE(slope);
            CAPTURE(turned);
            const auto laid = chapter06::lay({0, slope, turned}, counting_solver(solves));
            CHECK(laid.energy_gained < 1e-3);
            CHECK(laid.corners_missed == 0);
        }
}

TEST_CASE("pair memory: a slack fades no faster than at a part of the natural speed, so it is no motor")
{
    Contact deep;
    adapt_stiffness(deep, -0.2, 1, {}, 0.01);
    REQUIRE(deep.slack == -0.2);
    adapt_stiffness(deep, -0.2, 1, {}, 0.01);
    CHECK(deep.slack == doctest::Approx(-0.2 + 0.25 * 0.01).epsilon(1e-4));
    double before = deep.slack;
    adapt_stiffness(deep, before, 1, {}, 0.002);  // at rest where its spring is slack
    CHECK(deep.slack == doctest::Approx(before + 0.25 * 0.002).epsilon(1e-4));
    before = deep.slack;
    const NaturalUnits of_a_hundredth{0.01, 0.313};
    adapt_stiffness(deep, before, 1, StiffnessChoice{}.of_pair(of_a_hundredth), 0.01);
    CHECK(deep.slack == doctest::Approx(before + 0.025 * 0.01).epsilon(1e-4));
}
