#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/experiments/corner.hpp"
#include "chapters/05_categorisation/experiments/cube_in_floor.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/rigid_body.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter05 {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr ContactCategory regular = ContactCategory::regular, hooked = ContactCategory::hooked,
                          unknown = ContactCategory::unknown;

/// The normal of a floor that leans towards a wedge that looks down.
Vec3 leaning(double degrees) { return {-std::sin(degrees * degree), std::cos(degrees * degree), 0}; }

/// The cube's front edge against a floor's edge across its way, pushed back.
Contact curb(const World& world)
{
    const Contact one = edge_pair(world, Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX());
    const auto [a, b] = world.bodies[cube_body]->surface().edges()[one.feature_a];
    const bool front = world.bodies[cube_body]->positions_t0()[a].x() > 0.2;
    return front ? one : edge_pair(world, Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX());
}

}  // namespace

TEST_CASE("vertex: a wedge is hooked beyond 45 degrees from its outermost face, on both sides")
{
    for (const double opening : {40.0, 90.0, 180.0})
        for (const double side : {-1.0, 1.0}) {
            const double last = (180 - opening) / 2 + 45, inside = side * (last - 1),
                         beyond = side * (last + 1);
            const Corner wedge = wedge_corner("wedge", opening * degree);
            given("wedge of ", opening, " degrees that looks down, on a floor that leans by ", inside,
                  " degrees");
            expect_that("one degree inside, the pair is regular",
                        !is_hooked_vertex(wedge.surface(), 0, leaning(inside)));
            given("wedge of ", opening, " degrees that looks down, on a floor that leans by ", beyond,
                  " degrees");
            expect_that("one degree beyond, the pair is hooked",
                        is_hooked_vertex(wedge.surface(), 0, leaning(beyond)));
        }
    const Corner sharp = wedge_corner("wedge", 40 * degree);
    const auto word = [&](double angle) {
        return is_hooked_vertex(sharp.surface(), 0, leaning(angle)) ? "hooked" : "regular";
    };
    say("a wedge of 40 degrees, leaning 114 degrees: ", word(114), "; 116 degrees: ", word(116));
}

TEST_CASE(
    "edges: a cube's lower edge on a floor's edge is regular upwards and hooked downwards, by both rules")
{
    const World world = cube_in_floor();
    for (const EdgeRule rule : {EdgeRule::both, EdgeRule::either}) {
        given("rule \"", rule == EdgeRule::both ? "and" : "or", "\"");
        expect_that("pushed up it is regular",
                    categorise(world, edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()), 0,
                               rule) == regular);
        expect_that("pushed down it is hooked",
                    categorise(world, edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()), 0,
                               rule) == hooked);
    }
}

TEST_CASE("edges: one surface that objects is enough for \"or\", not for \"and\"")
{
    const World world = cube_in_floor();
    given("a cube's upright front edge against a floor's edge across its way, pushed back");
    const ContactCategory by_or = categorise(world, curb(world), 0, EdgeRule::either),
                          by_and = categorise(world, curb(world), 0, EdgeRule::both);
    expect_that("by \"or\" it is hooked", by_or == hooked);
    expect_that("by \"and\" it is regular", by_and == regular);
    say("a cube's upright edge against a floor's edge: ", by_or == hooked ? "hooked" : "regular",
        " by \"or\", ", by_and == hooked ? "hooked" : "regular", " by \"and\"");
}

TEST_CASE("edges: it does not matter which body is called A")
{
    const World world = cube_in_floor();
    for (const double sign : {1.0, -1.0}) {
        given("a cube's lower edge against a floor's edge, pushed ", sign > 0 ? "up" : "down");
        const Contact pair = edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), sign * Vec3::UnitY());
        Contact exchanged = pair;
        std::swap(exchanged.body_a, exchanged.body_b);
        std::swap(exchanged.feature_a, exchanged.feature_b);
        expect_that("the label is the same", categorise(world, pair, 0) == categorise(world, exchanged, 0));
    }
}

TEST_CASE(
    "no normal: parallel edges and a face without area stay unknown, and a vertex on a plane is regular")
{
    World world = cube_in_floor();
    const int along = lowest_edge_along(*world.bodies[cube_body], Vec3::UnitX()),
              beside = lowest_edge_along(*world.bodies[floor_body], Vec3::UnitX());
    given("two edges along x");
    expect_that(
        "the category is unknown",
        categorise(world, {ContactKind::edge_edge, cube_body, floor_body, along, beside}, 0) == unknown);

    World degenerate;
    degenerate.bodies.push_back(still(
        SurfaceMesh{{Vec3(0, 0, 0), Vec3(0.1, 0.3, 0.7), Vec3(0.3, 0.9, 2.1)}, {{0, 1, 2}}}, Vec3::Zero()));
    degenerate.bodies.push_back(still(box({1, 1, 1}), Vec3::Zero()));
    given("a face whose three corners lie on a line");
    expect_that("the category is unknown", categorise_vertex_face(degenerate, 1, 0, 0, 0, 0) == unknown);

    world.planes.push_back({"plane", Vec3::Zero(), Vec3(1, 0, 0)});
    given("a vertex on a plane");
    expect_that("it is regular",
                categorise(world, {ContactKind::vertex_plane, cube_body, 0, 0, -1}, 0) == regular);
}

TEST_CASE("moment: a label is taken when the pair begins to push, and new labels leave the others alone")
{
    World world;
    world.bodies.push_back(still(plane_grid(4, 4, {4, 4}), Vec3::Zero()));
    const SurfaceMesh mesh = box({1, 1, 1});
    world.bodies.push_back(std::make_unique<RigidBody>(
        "cube", mesh, with_mass(mass_properties(mesh, 1.0), 1.0), Vec3::Zero(), Vec3(0, 0, 80 * degree)));
    world.bodies[cube_body]->predict(Vec3::Zero(), 1.0);
    int below = -1;
    for (int face = 0; face < 12; ++face)
        if (surface_at(*world.bodies[cube_body], 0).face_normal(face).normalized().y() < -0.99)
            below = face;

    given(
        "a face that looks down at the start of the step and to the side at its end; the floor's middle vertex against it");
    Contact pair{ContactKind::vertex_face, floor_body, cube_body, 12, below};
    Contacts contacts{pair, pair};
    contacts[1].start = 1;
    label_contacts(world, contacts);
    expect_that("a pair that pushes from the start is regular", contacts[0].category == regular);
    expect_that("one that pushes from the end only is hooked", contacts[1].category == hooked);
    contacts[1].start = 0;
    label_new_contacts(world, contacts);
    expect_that("a label that is there is kept", contacts[1].category == hooked);
    contacts[0].category = unknown;
    label_new_contacts(world, contacts);
    expect_that("one that is not there is written", contacts[0].category == regular);
}

}  // namespace enduring::chapter05
