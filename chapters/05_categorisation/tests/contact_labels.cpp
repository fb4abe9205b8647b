#include "chapters/05_categorisation/category.hpp"
#include "chapters/05_categorisation/experiments/cube_in_floor.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter05;

namespace {

constexpr ContactCategory regular = ContactCategory::regular, hooked = ContactCategory::hooked,
                          unknown = ContactCategory::unknown;

}  // namespace

TEST_CASE(
    "errata: (6.3) as printed, with \"and\", calls a cube's upright edge against a floor's edge regular")
{
    const World world = cube_in_floor();
    // The cube slides along +x; its front meets a floor edge across its way, which pushes it back.
    const Contact curb = edge_pair(world, Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX());
    REQUIRE(curb.feature_a >= 0);
    REQUIRE(curb.feature_b >= 0);
    const Body& cube = *world.bodies[cube_body];
    const auto [a, b] = cube.surface().edges()[curb.feature_a];
    const bool front = cube.positions_t0()[a].x() > 0.2;
    const Contact met = front ? curb : edge_pair(world, Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX());
    CHECK(categorise(world, met, 0, EdgeRule::both) == regular);
    CHECK(categorise(world, met, 0, EdgeRule::either) == hooked);
}

TEST_CASE(
    "labels: a cube's lower edge on a floor's edge is regular upwards and hooked downwards, by both rules")
{
    const World world = cube_in_floor();
    for (const EdgeRule rule : {EdgeRule::both, EdgeRule::either}) {
        CHECK(categorise(world, edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), Vec3::UnitY()), 0, rule) ==
              regular);
        CHECK(categorise(world, edge_pair(world, Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitY()), 0, rule) ==
              hooked);
    }
}

TEST_CASE("labels: exchanging the two bodies of an edge pair changes no label")
{
    const World world = cube_in_floor();
    for (const EdgeRule rule : {EdgeRule::both, EdgeRule::either})
        for (const Vec3& edge : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())})
            for (const double sign : {1.0, -1.0}) {
                const Vec3 out = sign * (edge.x() > 0 ? Vec3::UnitY() : Vec3::UnitX());
                const Contact pair = edge_pair(world, edge, Vec3::UnitZ(), out);
                Contact exchanged = pair;
                std::swap(exchanged.body_a, exchanged.body_b);
                std::swap(exchanged.feature_a, exchanged.feature_b);
                // b x a = -(a x b), and the normal from the new B to the new A
                // is the old one reversed: the same sign.
                CAPTURE(sign);
                CHECK(categorise(world, exchanged, 0, rule) == categorise(world, pair, 0, rule));
            }
}

TEST_CASE(
    "labels: parallel edges and a face without area have no normal and stay unknown, also in rotated axes")
{
    const World world = cube_in_floor();
    const int along = lowest_edge_along(*world.bodies[cube_body], Vec3::UnitX());
    const int beside = lowest_edge_along(*world.bodies[floor_body], Vec3::UnitX());
    CHECK(categorise(world, {ContactKind::edge_edge, cube_body, floor_body, along, beside}, 0) == unknown);

    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    World degenerate;
    const SurfaceMesh line{{turn * Vec3(0, 0, 0), turn * Vec3(0.1, 0.3, 0.7), turn * Vec3(0.3, 0.9, 2.1)},
                           {{0, 1, 2}}};
    degenerate.bodies.push_back(still(line, Vec3::Zero()));
    degenerate.bodies.push_back(still(box({1, 1, 1}), Vec3::Zero()));
    CHECK(categorise_vertex_face(degenerate, 1, 0, 0, 0, 0) == unknown);
}

TEST_CASE("labels: edges and faces thinner than a ten-thousandth still have a normal, so a label")
{
    World world;
    // An edge along x of a triangle that looks down lies over an edge
    // of one that looks down, too, and then up.
    world.bodies.push_back(still({{{-1, 0, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, 2, 1}}}, Vec3::Zero()));
    world.bodies.push_back(still({{{-1, 0, -1e-4}, {1, 0, 1e-4}, {0, 0, 1}}, {{0, 1, 2}}}, Vec3::Zero()));
    const auto edge = [&](int body) {
        const auto edges = world.bodies[body]->surface().edges();
        return static_cast<int>(std::find(edges.begin(), edges.end(), Edge{0, 1}) - edges.begin());
    };
    Contact pair{ContactKind::edge_edge, 0, 1, edge(0), edge(1)};
    pair.orientation = -1;  // (2, 0, 0) x (2, 0, 2e-4) points down
    CHECK(categorise(world, pair, 0) == hooked);
    world.bodies[1] = still({{{-1, 0, -1e-4}, {1, 0, 1e-4}, {0, 0, -1}}, {{0, 1, 2}}}, Vec3::Zero());
    CHECK(categorise(world, pair, 0) == regular);

    world.bodies[1] = still({{{0, 0, 0}, {1, 0, 1e-4}, {1, 0, -1e-4}}, {{0, 1, 2}}}, Vec3::Zero());
    CHECK(categorise_vertex_face(world, 0, 0, 1, 0, 0) == regular);
}

TEST_CASE("labels: a vertex on a plane is always regular")
{
    World world = cube_in_floor();
    world.planes.push_back({"plane", Vec3::Zero(), Vec3(1, 0, 0)});
    for (int vertex = 0; vertex < 8; ++vertex)
        CHECK(categorise(world, {ContactKind::vertex_plane, cube_body, 0, vertex, -1}, 0) == regular);
}

TEST_CASE("labels: a label is taken when the pair begins to push, and a new pair's stays until the next step")
{
    World world;
    world.bodies.push_back(still(plane_grid(4, 4, {4, 4}), Vec3::Zero()));
    const SurfaceMesh mesh = box({1, 1, 1});
    // Turns by 80 degrees about z in one step of 1 s: the face below becomes one that looks to the side.
    const Vec3 spin(0, 0, 80 * std::numbers::pi / 180);
    world.bodies.push_back(std::make_unique<RigidBody>(
        "cube", mesh, with_mass(mass_properties(mesh, 1.0), 1.0), Vec3::Zero(), spin));
    world.bodies[cube_body]->predict(Vec3::Zero(), 1.0);
    int below = -1;
    for (int face = 0; face < 12; ++face)
        if (surface_at(*world.bodies[cube_body], 0).face_normal(face).normalized().y() < -0.99)
            below = face;
    const int middle_of_floor = 12;

    Contact pair{ContactKind::vertex_face, floor_body, cube_body, middle_of_floor, below};
    Contacts contacts{pair, pair};
    contacts[0].start = 0;
    contacts[1].start = 1;
    label_contacts(world, contacts);
    CHECK(contacts[0].category == regular);
    CHECK(contacts[1].category == hooked);

    Contacts found{pair};
    found[0].start = 1;
    label_new_contacts(world, found);
    CHECK(found[0].category == hooked);

    contacts[1].start = 0;
    label_new_contacts(world, contacts);
    CHECK(contacts[1].category == hooked);
    label_contacts(world, contacts);
    CHECK(contacts[1].category == regular);
}
