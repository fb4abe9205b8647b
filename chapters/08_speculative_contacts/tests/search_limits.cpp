#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_speculative_contacts/contact_search.hpp"
#include "chapters/08_speculative_contacts/sliding_normal.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

SurfaceMesh cube_at(const Vec3& centre, double size = 1)
{
    return placed(box(Vec3::Ones()), size, Quaternion::Identity(), centre);
}

void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "fixed", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

void add_rigid(World& world, const SurfaceMesh& mesh, const Vec3& velocity = Vec3::Zero())
{
    world.bodies.push_back(
        std::make_unique<RigidBody>("body", mesh, with_mass(mass_properties(mesh, 1000), 10), velocity));
}

void predict(World& world, double dt)
{
    for (const auto& body : world.bodies)
        body->predict(world.gravity, dt);
}

/// A pair of the lowest vertex of A with the first face of B that looks up.
Contact lowest_in_top(const World& world, int body_a, int body_b)
{
    const SurfaceMoment a = surface_at(*world.bodies[static_cast<std::size_t>(body_a)], 0),
                        b = surface_at(*world.bodies[static_cast<std::size_t>(body_b)], 0);
    Contact pair{ContactKind::vertex_face, body_a, body_b, 0, 0, {}, {1, -1, 0, 0}};
    while (b.face_normal(pair.feature_b).normalized().y() < 0.9)
        ++pair.feature_b;
    for (int vertex = 1; vertex < a.step.topology.vertex_count(); ++vertex)
        if (a.position(vertex).y() < a.position(pair.feature_a).y())
            pair.feature_a = vertex;
    const auto [p, q, r] = b.step.face(pair.feature_b);
    pair.vertices = {pair.feature_a, p, q, r};
    return pair;
}

bool has_kind(const Contacts& contacts, ContactKind kind)
{
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact& contact) { return contact.kind == kind; });
}

}  // namespace

TEST_CASE(
    "contact search: how deep a pair may be at the start is a part of the smaller body, whichever that is")
{
    for (const bool small_first : {true, false})
        for (const double parts : {0.9, 1.1}) {
            World world;
            world.gravity.setZero();
            const double small = 0.02;
            const auto add_small = [&] {
                const double height = 1 + small / 2 - parts * search_parts.inside * small;
                add_rigid(world, cube_at({0.1, height, 0.2}, small), Vec3(0, 30 * small, 0));  // comes out
            };
            if (small_first)
                add_small();
            add_static(world, box({2, 2, 2}));
            if (!small_first)
                add_small();
            predict(world, 0.01);
            CAPTURE(small_first);
            CAPTURE(parts);
            const int of_small = small_first ? 0 : 1;
            const Contact known = lowest_in_top(world, of_small, 1 - of_small);
            // The large body is deep in something else: this says nothing about the small one.
            world.planes.emplace_back();
            world.planes.back().point = Vec3(0, -0.95, 0);
            const Contact of_large{ContactKind::vertex_plane, 1 - of_small, 0, 0, -1,
                                   {0, -1, -1, -1},           {1, 0, 0, 0}};
            const Contacts found = ContactSearch().find(world, {known, of_large}, 0.01);
            const auto corners = std::count_if(found.begin(), found.end(), [](const Contact& contact) {
                return contact.kind == ContactKind::vertex_face;
            });
            CHECK(corners == (parts < 1 ? 4 : 0));
        }
}

TEST_CASE(
    "contact search: what lies outside beyond a sharp edge, and so behind a face, is not inside that face, unless a pair is as deep")
{
    // A wedge of 45 degrees along z with its edge in the origin: below y = 0, above the plane x = -y.
    SurfaceMesh wedge;
    wedge.vertices = {{0, 0, -1}, {0, 0, 1}, {1, 0, -1}, {1, 0, 1}, {1, -1, -1}, {1, -1, 1}};
    wedge.faces = {{0, 1, 3}, {0, 3, 2}, {0, 4, 5}, {0, 5, 1}, {2, 3, 5}, {2, 5, 4}, {0, 2, 4}, {1, 5, 3}};
    SurfaceMesh spike = placed(tetrahedron(1), 1,
                               Quaternion::FromTwoVectors(tetrahedron(1).vertices[0], Vec3(1, -1, 0)));
    const Vec3 tip = Vec3(0.018, -0.02, 0) -
                     spike.vertices[0];  // 20 mm below the top, 1.4 mm before the slope
    World world;
    const Quaternion tilt(
        Eigen::AngleAxisd(-0.7, Vec3::UnitZ()));  // so that the box around the top holds the tip
    add_static(world, placed(wedge, 1, tilt));
    add_rigid(world, placed(placed(spike, 1, Quaternion::Identity(), tip), 1, tilt));
    predict(world, 1e-3);
    const auto meets_top = [&](const Contacts& known) {
        const Contacts found = ContactSearch().find(world, known, 1e-3);
        return std::any_of(found.begin(), found.end(), [](const Contact& contact) {
            return contact.kind == ContactKind::vertex_face && contact.body_a == 1 && contact.feature_b < 2;
        });
    };
    CHECK(!meets_top({}));
    Contact as_deep{ContactKind::vertex_face, 1, 0, 1, 0, {0, 0, 1, 3}, {1, -1, 0, 0}};  // of another vertex
    CHECK(meets_top({as_deep}));
}

TEST_CASE(
    "contact search: of two faces that a vertex passes, the one that it passes first counts, known or not")
{
    const double size = 2000;  // here a hair of a length is not a hair of a step
    World world;
    world.gravity.setZero();
    SurfaceMesh layers = placed(plane_grid(1, 1, {2, 2}), size);
    const int corners = static_cast<int>(layers.vertices.size()),
              faces = static_cast<int>(layers.faces.size());
    for (int v = 0; v < corners; ++v)
        layers.vertices.push_back(layers.vertices[static_cast<std::size_t>(v)] - 0.002 * Vec3::UnitY());
    for (int face = 0; face < faces; ++face) {
        Face below = layers.faces[static_cast<std::size_t>(face)];
        for (int& vertex : below)
            vertex += corners;
        layers.faces.push_back(below);
    }
    add_static(world, layers);
    const double dt = 0.01, above = 0.5;
    SurfaceMesh spike = placed(tetrahedron(1), size);
    const Quaternion turn = Quaternion::FromTwoVectors(
        spike.vertices[0] - (spike.vertices[1] + spike.vertices[2] + spike.vertices[3]) / 3, -Vec3::UnitY());
    spike = placed(spike, 1, turn);
    const Vec3 by = Vec3(0.1 * size, above, 0.15 * size) - spike.vertices[0];
    add_rigid(world, placed(spike, 1, Quaternion::Identity(), by), Vec3(0, -1 / dt, 0));
    predict(world, dt);
    const auto chosen = [&](const Contacts& known) {
        std::vector<double> heights;
        for (const Contact& contact : ContactSearch().find(world, known, dt))
            if (contact.kind == ContactKind::vertex_face && contact.body_a == 1 && contact.feature_a == 0)
                heights.push_back(contact_geometry(world, contact, 0).q.y());
        return heights;
    };
    const std::vector<double> upper = chosen({});
    REQUIRE(upper.size() == 1);
    CHECK(upper[0] == doctest::Approx(0).epsilon(1e-6));
    for (int face = faces; face < 2 * faces; ++face)
        CHECK(chosen({pair_of(1, 0, 0, face, world.bodies[0]->surface())}) == upper);
}

TEST_CASE(
    "contact search: on a side that turns a pair has the sliding normal, unless that would leave it deep")
{
    for (const double turn :
         {0.005, 0.008, 0.012, 0.1}) {  // by 6 micrometres to 2.5 mm; up to 24 are allowed
        const double dt = 0.004, size = 0.2 * turn;
        World world;
        world.gravity = Vec3(0, -9.81, 0);
        world.bodies.push_back(std::make_unique<DrivenBody>(
            "drum", box({2, 1, 1}), Vec3::Zero(), GivenMotion::steady(Vec3::Zero(), Vec3(0, 0, turn / dt))));
        // as fast down as the drum's top sinks below it, and a little more
        add_rigid(world, cube_at({0, 0.5 + 0.5 * size + 1e-7, 0}, size),
                  Vec3(0, -0.35 * turn * turn / dt, 0));
        predict(world, dt);
        int bent = 0;
        for (const Contact& contact : ContactSearch().find(world, {}, dt)) {
            if (contact.kind != ContactKind::vertex_face || contact.body_a != 1)
                continue;
            const Vec3 expected = sliding_normal(contact_geometry(world, contact, 0).normal,
                                                 contact_geometry(world, contact, 1).normal,
                                                 motion_without_gravity(world, contact, dt));
            bent += !expected.isZero(0);
            CHECK((contact.sliding_normal - (turn < 0.01 ? expected : Vec3(0, 0, 0))).norm() < 1e-12);
        }
        CHECK(bent > 0);
    }
}

TEST_CASE(
    "contact search: what slides into a valley has the sliding normal between the two sides, without what it falls")
{
    const double dt = 0.004;
    World world;
    world.gravity = Vec3(0, -9.81, 0);
    add_static(world, hinge(0.1));
    add_rigid(world, cube_at({0.03, 0.01 + 1e-7, 0.5}, 0.02), Vec3(-0.03, -5e-4, 0) / dt);
    predict(world, dt);
    int bent = 0;
    for (const Contact& contact : ContactSearch().find(world, {}, dt)) {
        const Vec3 normal = contact_geometry(world, contact, 0).normal;
        if (contact.kind != ContactKind::vertex_face || contact.body_a != 1 || normal.x() == 0)
            continue;
        const Vec3 expected = sliding_normal(Vec3::UnitY(), normal, Vec3(-0.03, -5e-4, 0));
        CHECK((contact.sliding_normal - expected).norm() < 1e-9);
        CHECK(expected.x() < -1e-3);  // before the level side
        ++bent;
    }
    CHECK(bent > 0);
}

TEST_CASE("contact search: edges that have a pair keep it a hair past an end")
{
    const SurfaceMesh roof{{{0, 0, -0.5}, {0, 0, 0.5}, {1, -1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
    const Quaternion over(Eigen::AngleAxisd(std::numbers::pi, Vec3(1, 0, 1).normalized()));
    World world;
    world.gravity.setZero();
    add_static(world, roof);
    const double past = 0.5 * search_parts.hysteresis;
    world.bodies.push_back(std::make_unique<RigidBody>("keel", placed(roof, 1, over, {0, -1e-3, 0.5 + past}),
                                                       MassProperties{1, Vec3::Zero(), Mat3::Identity()}));
    predict(world, 0.01);
    const auto edge_of = [&](std::size_t body) {
        for (const int edge : world.bodies[body]->surface().edges_around_vertex(0))
            if (const auto [p, q] = world.bodies[body]->surface().edges()[static_cast<std::size_t>(edge)];
                p + q == 1)
                return edge;
        return -1;
    };
    const auto pairs = [&](const Contacts& known) {
        return has_kind(ContactSearch().find(world, known, 0.01), ContactKind::edge_edge);
    };
    CHECK_FALSE(pairs({}));
    Contact known{ContactKind::edge_edge, 0, 1, edge_of(0), edge_of(1), {0, 1, 0, 1}, {0.5, 0.5, -0.5, -0.5}};
    if (contact_geometry(world, known, 0).depth > 0)
        known.orientation = -1;
    CHECK(pairs({known}));
}

TEST_CASE("contact search: a vertex has moved in whatever direction, and whichever it is")
{
    const double dt = 0.004;
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        World world;
        add_static(world, box(Vec3::Ones()));
        add_rigid(world, cube_at({0, 4, 0}));
        predict(world, dt);
        ContactSearch search;
        search.find(world, {}, dt);
        Body& cube = *world.bodies[1];
        for (int v = 0; v < 8; ++v)
            cube.apply_impulse(v, 2 * search_margin(world, dt) / dt * cube.mass() / 8 * axis);
        cube.update_prediction(dt);
        CAPTURE(axis.transpose());
        CHECK(search.has_moved(world));
    }
    World world;  // about the line from its centre to vertex 0, which stays
    add_rigid(world, cube_at({0, 4, 0}));
    predict(world, dt);
    ContactSearch search;
    search.find(world, {}, dt);
    Body& cube = *world.bodies[0];
    const Vec3 axis = (cube.positions_t0()[0] - cube.centre()).normalized();
    for (int v = 0; v < 8; ++v)
        cube.apply_impulse(
            v, 0.5 * axis.cross(cube.positions_t0()[static_cast<std::size_t>(v)] - cube.centre()));
    const Vec3 before = cube.positions_t1()[0];
    cube.update_prediction(dt);
    REQUIRE((cube.positions_t1()[0] - before).norm() < search_margin(world, dt));
    CHECK(search.has_moved(world));
}

TEST_CASE(
    "sliding normal: what rises steeply does not come along the surface, and below two faces the nearer counts")
{
    for (const double bend : {0.1, 0.4})
        CHECK(
            sliding_normal({0, 1, 0}, {-std::sin(bend), std::cos(bend), 0}, {std::cos(1.0), std::sin(1.0), 0})
                .isZero(0));
    const MovingSurface ridge(hinge(-0.3)), vertex(particle({0.006, -0.02, 0.5}));
    Ground ground;
    for (const int face : {0, 1})
        ground.look_at(vertex.step(), 0, ridge.step(), face);
    CHECK((ground.normal - Vec3::UnitY()).norm() < 1e-12);
}

namespace {

/// What the second search finds where a cube of 0.3 m above the ground, which has no pair at first, is pushed down.
/// @param ends_at  height of its lowest corner at the end of the step [m]
Contacts pairs_of_pushed_cube(World& world, const Quaternion& tilt, double ends_at, double dt)
{
    const double size = 0.3, gap = 0.05;
    world.planes.push_back({"ground"});
    add_rigid(world, placed(box(Vec3::Ones()), size, tilt, {0, size / 2 + gap, 0}));
    predict(world, dt);
    ContactSearch search;
    Contacts contacts;
    renew_pairs(search, world, dt, contacts);
    REQUIRE(contacts.empty());
    Body& cube = *world.bodies[0];
    double lowest = gap;
    for (const Vec3& corner : cube.positions_t1())
        lowest = std::min(lowest, corner.y());
    for (int v = 0; v < 8; ++v)
        cube.apply_impulse(v, Vec3(0, ends_at - lowest, 0) / dt * cube.mass() / 8);
    cube.update_prediction(dt);
    append_pairs_brought_inside(search, world, dt, contacts);
    return contacts;
}

}  // namespace

TEST_CASE("solver of chapter 8: the second search adds only what came deeper than the wanted depth")
{
    for (const double parts : {0.5, 2.0}) {
        World world;
        world.gravity.setZero();
        const double depth = parts * scale_parts.wanted_depth * 0.3;
        CAPTURE(parts);
        CHECK(pairs_of_pushed_cube(world, Quaternion::Identity(), -depth, 0.004).empty() == (parts < 1));
    }
}

TEST_CASE(
    "solver of chapter 8: where the second search finds a corner inside, those that are near come with it")
{
    for (const double dt : {0.004, 0.02}) {
        World world;
        const double margin = 1.5 * world.gravity.norm() * dt * dt;
        const Quaternion tilt(Eigen::AngleAxisd(0.4 * margin / 0.3, Vec3::UnitZ()));
        // two corners a tenth of the margin deep, two others as high as three tenths
        const Contacts contacts = pairs_of_pushed_cube(world, tilt, -0.1 * margin, dt);
        CAPTURE(dt);
        CHECK(contacts.size() == 4);
        CHECK(std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
                  return contact_geometry(world, contact, 1).depth < 0;
              }) == 2);
    }
}

TEST_CASE(
    "solver of chapter 8: its pairs are stiffer than chapter 7's by a factor, and as stiff as a scene's depth asks")
{
    for (const double dt : {0.004, 0.01}) {
        const double of_mass = 100 * search_parts.stiffer * 2.5 /
                               (dt * dt);  // a corner feels a quarter of 10 kg
        for (const double part : {0.0, 3.0}) {
            Scene scene = chapter07::scene_of({{10, Vec3(0, 0.5, 0)}}, dt);
            if (part > 0)
                scene.contact.wanted_depth = 2.5 * 9.81 / (part * of_mass);
            const Solver solver = chapter08_solver(scene.contact);
            Contacts contacts;
            for (int step = 0; step < 60; ++step)
                advance(scene.world, contacts, solver, dt);
            REQUIRE(contacts.size() == 4);
            CAPTURE(dt);
            CAPTURE(part);
            for (const Contact& contact : contacts)
                CHECK(contact.stiffness == doctest::Approx(std::max(1.0, part) * of_mass).epsilon(0.01));
        }
    }
}

TEST_CASE("solver of chapter 8: a pair that something else finds remembers as those of the search do")
{
    Scene scene = chapter07::scene_of({{10, Vec3(0, 0.9, 0)}}, 0.01);
    predict(scene.world, scene.dt);
    ContactSearch search;
    Contact other{ContactKind::vertex_plane, 0, 0, 7, -1, {7, -1, -1, -1}, {1, 0, 0, 0}};
    Contacts contacts{other};
    contacts[0].stiffness = 321;
    renew_pairs(search, scene.world, scene.dt, contacts, [&](Contacts& found) { found.push_back(other); });
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].stiffness == 321);
}

TEST_CASE("solver of chapter 8: a run of it can be resumed") { CHECK(chapter08_solver({}).can_resume); }

namespace {

/// A cube in a floor: its right lower edge is in by a depth and has a pair, the left one is deeper and has none.
struct TiltedCube {
    static constexpr double dt = 0.004;
    World world;
    Contacts known;
    double depth = 0;

    /// @param ratio  of both depths
    /// @param leaves  whether what has a pair ends at the floor's height
    TiltedCube(double ratio, bool leaves)
    {
        add_static(world, placed(box({4, 1, 4}), 1, Quaternion::Identity(), {0, -0.5, 0}));
        depth = 5 * search_parts.fall * world.gravity.norm() * dt * dt;
        const Quaternion tilt(Eigen::AngleAxisd(std::asin((ratio - 1) * depth), Vec3::UnitZ()));
        const Vec3 right = tilt * Vec3(0.5, -0.5, 0);
        add_rigid(world, placed(box(Vec3::Ones()), 1, tilt, {0, -right.y() - depth, 0}),
                  Vec3(0, leaves ? depth / dt : 0, 0));
        predict(world, dt);
        Contact pair = lowest_in_top(world, 1, 0), above = pair;
        pair.feature_a = pair.vertices[0] = corner(Vec3(1, -1, 0));
        above.feature_a = above.vertices[0] = corner(Vec3(1, 1, 0));
        known = {pair, above};
    }
    /// The vertex of the cube that is furthest along a direction.
    int corner(const Vec3& direction) const
    {
        const auto corners = world.bodies[1]->positions_t0();
        return static_cast<int>(std::max_element(corners.begin(), corners.end(),
                                                 [&](const Vec3& one, const Vec3& other) {
                                                     return one.dot(direction) < other.dot(direction);
                                                 }) -
                                corners.begin());
    }
    bool left_has_pair()
    {
        const Contacts found = ContactSearch().find(world, known, dt);
        return std::any_of(found.begin(), found.end(), [&](const Contact& pair) {
            return pair.kind == ContactKind::vertex_face && pair.body_a == 1 &&
                   world.bodies[1]->positions_t0()[static_cast<std::size_t>(pair.feature_a)].y() <
                       -1.2 * depth;
        });
    }
};

}  // namespace

TEST_CASE(
    "contact search: up to twice as deep as the deepest pair of its body lies at the start a vertex gets one, too")
{
    for (const bool leaves : {false, true}) {
        CAPTURE(leaves);
        CHECK(TiltedCube(1.6, leaves).left_has_pair());
        CHECK_FALSE(TiltedCube(2.4, leaves).left_has_pair());
    }
}

TEST_CASE("contact search: the deepest pair of either body counts")
{
    TiltedCube below(1.0, false);
    const double depth = below.depth, dt = TiltedCube::dt;
    World& world = below.world;
    add_rigid(world, cube_at({0.1, 1.25 - 2.5 * depth, 0.1}, 0.5));
    predict(world, dt);
    const auto pairs = [&](const Contacts& known) {
        const Contacts found = ContactSearch().find(world, known, dt);
        return std::count_if(found.begin(), found.end(), [](const Contact& pair) {
            return pair.kind == ContactKind::vertex_face && pair.body_a == 2 && pair.body_b == 1;
        });
    };
    CHECK(pairs(below.known) == 4);
    CHECK(pairs({}) == 0);
}
