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

/// The pair with its bodies named the other way round.
Contact exchanged(Contact pair)
{
    std::swap(pair.body_a, pair.body_b);
    std::swap(pair.feature_a, pair.feature_b);
    return pair;
}

/// A body at rest, by default a floor, and a cube of 1 m, both round the origin, which turns by 80 degrees
/// about z in its step.
World turning_cube(const SurfaceMesh& other = plane_grid(4, 4, {4, 4}))
{
    World world;
    world.bodies.push_back(still(other, Vec3::Zero()));
    const SurfaceMesh mesh = box({1, 1, 1});
    world.bodies.push_back(std::make_unique<RigidBody>(
        "cube", mesh, with_mass(mass_properties(mesh, 1.0), 1.0), Vec3::Zero(), Vec3(0, 0, 80 * degree)));
    world.bodies[cube_body]->predict(Vec3::Zero(), 1.0);
    return world;
}

/// The edge of a body whose middle is nearest to a point.
int edge_at(const Body& body, const Vec3& point)
{
    int found = -1;
    double nearest = 1e9;
    for (int edge = 0; edge < static_cast<int>(body.surface().edges().size()); ++edge) {
        const auto [a, b] = body.surface().edges()[edge];
        const double distance = (0.5 * (body.positions_t0()[a] + body.positions_t0()[b]) - point).norm();
        if (distance < nearest) {
            nearest = distance;
            found = edge;
        }
    }
    return found;
}

/// The cube's edge (A) and the other body's edge with these middles, which push up at the start.
Contact pushed_up(const World& world, const Vec3& middle_a, const Vec3& middle_b)
{
    const Body &cube = *world.bodies[cube_body], &other = *world.bodies[floor_body];
    const auto along = [](const Body& body, int edge) {
        const auto [a, b] = body.surface().edges()[edge];
        return Vec3(body.positions_t0()[b] - body.positions_t0()[a]);
    };
    Contact pair{ContactKind::edge_edge, cube_body, floor_body, edge_at(cube, middle_a),
                 edge_at(other, middle_b)};
    pair.orientation = along(cube, pair.feature_a).cross(along(other, pair.feature_b)).y() > 0 ? 1 : -1;
    return pair;
}

/// The vertex of a body that lies farthest in a direction.
int farthest(const Body& body, const Vec3& direction)
{
    int found = 0;
    for (int vertex = 1; vertex < static_cast<int>(body.positions_t0().size()); ++vertex)
        if (body.positions_t0()[vertex].dot(direction) > body.positions_t0()[found].dot(direction))
            found = vertex;
    return found;
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
    for (const Contact& pair : {curb(world), exchanged(curb(world))}) {
        expect_that("by \"or\" it is hooked, whichever body is A",
                    categorise(world, pair, 0, EdgeRule::either) == hooked);
        expect_that("by \"and\" it is regular, whichever body is A",
                    categorise(world, pair, 0, EdgeRule::both) == regular);
    }
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
        expect_that("the label is the same",
                    categorise(world, pair, 0) == categorise(world, exchanged(pair), 0));
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

TEST_CASE("no normal: parallel edges are parallel in any direction, in spite of rounding")
{
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    SurfaceMesh mesh = box({1, 0.7, 1.3});
    for (Vec3& x : mesh.vertices)
        x = turn * x;
    World world;
    world.bodies.push_back(still(mesh, Vec3::Zero()));
    world.bodies.push_back(still(mesh, Vec3(0.1, 0.2, 0.3)));
    for (int edge = 0; edge < static_cast<int>(world.bodies[0]->surface().edges().size()); ++edge) {
        given("edge ", edge, " of a turned box against the same edge of its copy");
        expect_that("the category is unknown",
                    categorise(world, {ContactKind::edge_edge, 0, 1, edge, edge}, 0) == unknown);
    }
}

TEST_CASE("size: a cube in a floor has the same labels from micrometres to kilometres")
{
    for (const double size : {1e-6, 1e-3, 1e3}) {
        World world;
        world.bodies.push_back(still(plane_grid(4 * size, 4 * size, {4, 4}), Vec3::Zero()));
        world.bodies.push_back(still(box({size, size, size}), size * Vec3(0.2, 0.49, 0.3)));
        given("a cube of ", size, " m that stands in a floor");
        for (const double sign : {1.0, -1.0})
            expect_that(
                sign > 0 ? "its lower edge pushed up is regular" : "its lower edge pushed down is hooked",
                categorise(world, edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), sign * Vec3::UnitY()), 0) ==
                    (sign > 0 ? regular : hooked));
        expect_that(
            "a lower corner on a floor's face is regular",
            categorise_vertex_face(world, cube_body, farthest(*world.bodies[cube_body], Vec3(1, -2, 1)),
                                   floor_body, 0, 0) == regular);
        expect_that(
            "an upper corner on a floor's face is hooked",
            categorise_vertex_face(world, cube_body, farthest(*world.bodies[cube_body], Vec3(1, 2, 1)),
                                   floor_body, 0, 0) == hooked);
    }
}

TEST_CASE("vertex: the length of the normal does not matter, and a lone particle can be pushed anywhere")
{
    const Corner wedge = wedge_corner("wedge", 90 * degree);
    for (const double length : {1e-9, 1e6}) {
        given("a wedge of 90 degrees that looks down, normals of the length ", length);
        expect_that("on a level floor the pair is regular",
                    !is_hooked_vertex(wedge.surface(), 0, length * leaning(0)));
        expect_that("against a floor overhead it is hooked",
                    is_hooked_vertex(wedge.surface(), 0, length * leaning(180)));
    }
    const SurfaceTopology lone(1, {});
    const std::vector<Vec3> at{Vec3::Zero()};
    given("a vertex without faces");
    expect_that("the pair is regular", !is_hooked_vertex({{lone, at, at}, 0}, 0, Vec3::UnitY()));
}

TEST_CASE("moment: a surface that turns has at each moment another label, as A and as B")
{
    const World world = turning_cube();
    const Contact rolled = pushed_up(world, {0.5, -0.5, 0}, {0.5, 0, 0});
    given(
        "a cube that turns by 80 degrees in the step, its lower edge along the axis against a floor's edge, pushed up");
    for (const Contact& pair : {rolled, exchanged(rolled)}) {
        const std::string named = pair.body_a == cube_body ? "with the cube as A" : "with the cube as B";
        expect_that(named + ", at the start it is regular", categorise(world, pair, 0) == regular);
        expect_that(named + ", at the end it is hooked", categorise(world, pair, 1) == hooked);
    }
    // At the end the cube's sole looks along x, and so does the push: against the side of the step, whose top
    // was pushed before.
    const World step = turning_cube(box({1, 1, 1}));
    const Contact sole = pushed_up(step, {0, -0.5, 0.5}, {-0.5, 0.5, 0});
    given("the same cube, its lower edge across the axis against the upper edge of a resting cube");
    for (const Contact& pair : {sole, exchanged(sole)})
        for (const double tau : {0.0, 1.0}) {
            expect_that("at the start and at the end, as A and as B, it is regular",
                        categorise(step, pair, tau) == regular);
        }
    const int corner = farthest(*world.bodies[cube_body], Vec3(1, -2, 1));
    given("the same cube, its lower corner on a face of the floor");
    expect_that("at the start it is regular",
                categorise_vertex_face(world, cube_body, corner, floor_body, 0, 0) == regular);
    expect_that("at the end it is hooked",
                categorise_vertex_face(world, cube_body, corner, floor_body, 0, 1) == hooked);
}

TEST_CASE("labels: both ways of labelling use the rule that is asked for")
{
    const World world = cube_in_floor();
    for (const EdgeRule rule : {EdgeRule::both, EdgeRule::either}) {
        given("a cube's upright front edge against a floor's edge across its way, rule \"",
              rule == EdgeRule::both ? "and" : "or", "\"");
        Contacts all{curb(world)}, fresh{curb(world)};
        label_contacts(world, all, rule);
        label_new_contacts(world, fresh, rule);
        expect_that("label_contacts writes it", all[0].category == categorise(world, curb(world), 0, rule));
        expect_that("label_new_contacts writes it",
                    fresh[0].category == categorise(world, curb(world), 0, rule));
    }
}

TEST_CASE("moment: a label is taken when the pair begins to push, and new labels leave the others alone")
{
    const World world = turning_cube();
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
    contacts[0].start = 1;
    label_new_contacts(world, contacts);
    expect_that("a label \"regular\" is kept, too", contacts[0].category == regular);
    contacts[1].category = unknown;
    contacts[1].start = 1;
    label_new_contacts(world, contacts);
    expect_that("a new label is taken at the moment from which the pair pushes",
                contacts[1].category == hooked);
    contacts[1].start = 0;
    label_contacts(world, contacts);
    expect_that("label_contacts judges all anew, also those that have a label",
                contacts[0].category == hooked && contacts[1].category == regular);
}

}  // namespace enduring::chapter05
