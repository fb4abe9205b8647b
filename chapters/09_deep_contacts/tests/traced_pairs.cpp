#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/05_categorisation/normal_span.hpp"
#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "still", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

void add_rigid(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(
        std::make_unique<RigidBody>("body", mesh, with_mass(mass_properties(mesh, 1000), 20)));
}

SurfaceMesh floor_mesh() { return moved(box({2, 1, 2}, {7, 3, 7}), {0, -0.5, 0}); }
SurfaceMesh block_mesh(double depth)
{
    return moved(box(Vec3::Constant(0.4), {2, 2, 2}), {0.013, 0.2 - depth, 0.021});
}

/// A block so deep in a floor, the one or the other first in the list.
World block_in_floor(double depth, bool floor_first = true)
{
    World world;
    if (floor_first)
        add_static(world, floor_mesh());
    add_rigid(world, block_mesh(depth));
    if (!floor_first)
        add_static(world, floor_mesh());
    return world;
}

/// A vertex of a body with a face of another one that looks that way, the lowest of them.
Contact pair_with_face(const World& world, int body_a, int vertex, int body_b, const Vec3& direction)
{
    const Body& b = *world.bodies[static_cast<std::size_t>(body_b)];
    const auto height = [&](int v) { return b.positions_t0()[static_cast<std::size_t>(v)].y(); };
    Contact lowest;
    double least = 1e9;
    for (int face = 0; face < static_cast<int>(b.surface().faces().size()); ++face) {
        const auto [f0, f1, f2] = b.surface().faces()[face];
        const double low = height(f0) + height(f1) + height(f2);
        if (surface_at(b, 0).face_normal(face).normalized().dot(direction) > 0.999 && low < least) {
            least = low;
            lowest = {ContactKind::vertex_face, body_a, body_b, vertex, face, {vertex, f0, f1, f2},
                      {1, -0.25, -0.25, -0.5}};
        }
    }
    REQUIRE(lowest.feature_b >= 0);
    return lowest;
}

/// A vertex of a body that lies (or does not lie) at a place that a test describes.
template <class Test>
int vertex_where(const Body& body, const Test& test)
{
    for (int v = 0; v < body.surface().vertex_count(); ++v)
        if (test(body.positions_t0()[static_cast<std::size_t>(v)]))
            return v;
    FAIL("no such vertex");
    return -1;
}

}  // namespace

TEST_CASE("inside pairs: a pair acts where the separation direction passes its face")
{
    for (const bool floor_first : {true, false}) {
        const World world = block_in_floor(0.13, floor_first);
        const int block = floor_first ? 1 : 0;
        InsidePairs inside;
        Contacts contacts;
        inside.trace(world);
        inside.append_pairs(world, contacts);
        int pairs = 0;
        for (const Contact& contact : contacts) {
            if (contact.kind != ContactKind::vertex_face)
                continue;
            const ContactGeometry geometry = contact_geometry(world, contact, 0);
            const double up = contact.body_a == block ? 1 : -1;
            CHECK(geometry.normal.y() == doctest::Approx(up));
            CHECK((geometry.q - geometry.p - up * std::abs(geometry.depth) * Vec3::UnitY()).norm() < 1e-9);
            CHECK(contact.category == ContactCategory::regular);
            ++pairs;
        }
        CHECK(pairs > 8);
    }
}

TEST_CASE("inside pairs: none between bodies that cannot move, nor where a surface is open")
{
    const auto pairs_of = [](const World& world) {
        InsidePairs inside;
        Contacts contacts;
        inside.trace(world);
        inside.append_pairs(world, contacts);
        return contacts.size();
    };
    World fixed;
    add_static(fixed, floor_mesh());
    add_static(fixed, block_mesh(0.13));
    CHECK(pairs_of(fixed) == 0);
    for (const bool sheet_first : {true, false}) {
        World world;
        const SurfaceMesh sheet = plane_grid(7, 7, {2, 2});
        if (sheet_first)
            add_static(world, sheet);
        add_rigid(world, block_mesh(0.13));
        if (!sheet_first)
            add_static(world, sheet);
        CAPTURE(sheet_first);
        CHECK(pairs_of(world) == 0);
    }
    CHECK(pairs_of(block_in_floor(0.13)) > 0);
}

TEST_CASE("inside pairs: bodies that moved since the last trace are traced where they are")
{
    World world = block_in_floor(0.13);
    InsidePairs inside;
    Contacts first, second;
    inside.trace(world);
    inside.append_pairs(world, first);
    world.bodies[1]->predict(Vec3(0, 0, 0), 1);
    for (int v = 0; v < world.bodies[1]->surface().vertex_count(); ++v)
        world.bodies[1]->apply_impulse(v, Vec3(0, 1, 0));
    world.bodies[1]->update_prediction(1);
    world.bodies[1]->commit(1);
    inside.trace(world);
    inside.append_pairs(world, second);
    CHECK(first.size() > 0);
    CHECK(second.empty());
}

TEST_CASE(
    "inside pairs: a trace behind others finds what a first one finds, whether bodies have moved or not")
{
    World world = block_in_floor(0.13);
    InsidePairs inside;
    for (const double rise : {0.0, 0.0, -0.1, 0.0, 0.5}) {
        world.bodies[1]->predict(Vec3(0, rise, 0), 1);
        world.bodies[1]->commit(1);
        dynamic_cast<RigidBody&>(*world.bodies[1]).move_with(Vec3::Zero(), Vec3::Zero());
        InsidePairs fresh;
        Contacts behind_others, first;
        inside.trace(world);
        inside.append_pairs(world, behind_others);
        fresh.trace(world);
        fresh.append_pairs(world, first);
        CAPTURE(rise);
        CHECK((first.size() > 0) == (rise < 0.3));  // then it is out
        REQUIRE(behind_others.size() == first.size());
        for (std::size_t i = 0; i < first.size(); ++i) {
            CHECK(key_of(behind_others[i]) == key_of(first[i]));
            CHECK(behind_others[i].weights == first[i].weights);
        }
    }
}

TEST_CASE(
    "depenetration: what part of a separation direction lies along a pair is told by any of its vertices that is inside, of either body")
{
    for (const bool floor_first : {true, false}) {
        World world = block_in_floor(0.13, floor_first);
        const int block = floor_first ? 1 : 0, floor = 1 - block;
        for (int v = 0; v < 8; ++v)  // it turns in the step; what counts is how it begins
            world.bodies[static_cast<std::size_t>(block)]->apply_impulse(v,
                                                                         Vec3(0, v % 2 == 0 ? 300 : -300, 0));
        for (const auto& body : world.bodies)
            body->predict(Vec3::Zero(), 0.01);
        InsidePairs inside;
        Contacts contacts;
        inside.trace(world);
        inside.append_pairs(world, contacts);
        const Body &b = *world.bodies[static_cast<std::size_t>(block)],
                   &f = *world.bodies[static_cast<std::size_t>(floor)];
        const int deep = vertex_where(b, [](const Vec3&x) { return x.y() < -0.1; }),
                  high = vertex_where(b, [](const Vec3&x) { return x.y() > 0.1; }),
                  of_floor = vertex_where(f,
                                          [](const Vec3&x) {
                                              return x.y() == 0 && std::abs(x.x()) < 0.19 &&
                                                     std::abs(x.z()) < 0.19;
                                          }),
                  far = vertex_where(f,
                                     [](const Vec3&x) { return x.y() == 0 && x.x() < -0.9 && x.z() < -0.9; });
        const auto part = [&](int body_a, int vertex, int body_b, const Vec3& direction) {
            return inside.part_along_direction(world,
                                               pair_with_face(world, body_a, vertex, body_b, direction));
        };
        CAPTURE(floor_first);
        const Vec3 up = Vec3::UnitY();
        CHECK(part(block, deep, floor, up) == doctest::Approx(1));
        CHECK(part(block, deep, floor, -up) == 0);  // against the direction
        CHECK(part(block, deep, floor, Vec3::UnitX()) == doctest::Approx(0));
        CHECK(part(floor, of_floor, block, -up) == doctest::Approx(1));
        CHECK(part(floor, of_floor, block, Vec3::UnitX()) == doctest::Approx(0));
        CHECK(part(floor, of_floor, block, up) == 0);
        // A floor's vertex outside the overlap with a face that has corners inside it.
        CHECK(part(floor, far, block, -up) == doctest::Approx(1));
        CHECK(part(floor, far, block, up) == 1);  // no vertex of the pair is inside
        CHECK(part(block, high, floor, Vec3::UnitX()) == 1);
        CHECK(part(floor, far, block, Vec3::UnitX()) == doctest::Approx(0));
        const Contact plane{ContactKind::vertex_plane, block,       floor, deep, -1,
                            {deep, -1, -1, -1},        {1, 0, 0, 0}};
        World with_planes = block_in_floor(0.13, floor_first);
        with_planes.planes = {{"wall", Vec3(-9, 0, 0), Vec3::UnitX()},
                              {"wall", Vec3(-9, 0, 0), Vec3::UnitX()}};
        CHECK(inside.part_along_direction(with_planes, plane) == 1);
    }
}

TEST_CASE("depenetration: as fast as a scene says, however slow that is and however long a step")
{
    using namespace enduring::chapter09;
    for (const double speed : {0.01, 0.1})
        for (const double dt : {0.004, 0.01}) {
            Scene scene = scene_inside(all_surroundings()[0], "block", 0.1, dt);
            scene.contact.max_depenetration_velocity = speed;
            double fastest = 0;
            WatchProbe watch([&](const World& world, const Contacts&, double) {
                fastest = std::max(fastest, world.bodies.back()->mean_velocity().y());
            });
            run(scene, chapter09_solver(scene.contact), {&watch}, {.steps = 60});
            CAPTURE(speed);
            CAPTURE(dt);
            CHECK(fastest == doctest::Approx(speed).epsilon(0.03));
        }
}

TEST_CASE(
    "depenetration: between the jaws of a vice, from which nothing separates, loads do not grow for ever")
{
    World world;
    add_static(world, floor_mesh());
    for (const double side : {-1.0, 1.0})
        add_static(world, moved(box({0.5, 1, 1}, {2, 3, 3}), {side * (0.45 - 0.05), 0.52, 0}));
    add_rigid(world, moved(box(Vec3::Constant(0.4), {2, 2, 2}), {0, 0.2001, 0}));
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    const Solver solver = chapter09_solver({}, quiet);
    Contacts contacts;
    double most = 0;
    for (int step = 0; step < 60; ++step) {
        advance(world, contacts, solver, 0.01);
        for (const Contact& contact : contacts)
            most = std::max(most, contact.spring.load);
    }
    CHECK(most < 1e6);
    CHECK(most > 1e4);
}

TEST_CASE("depenetration: a small rest offset fades by a tenth in a step, once")
{
    World world = block_in_floor(1e-4);
    const Solver solver = chapter09_solver({});
    Contacts contacts;
    advance(world, contacts, solver, 0.01);
    const auto lowest = [&] {
        double low = 1;
        for (const Vec3& x : world.bodies[1]->positions_t0())
            low = std::min(low, x.y());
        return low;
    };
    const double before = lowest();
    for (int step = 0; step < 6; ++step)
        advance(world, contacts, solver, 0.01);
    CHECK(lowest() / before == doctest::Approx(std::pow(0.9, 6)).epsilon(0.05));
}

TEST_CASE(
    "crossing edges: it is where they begin the step that counts, and edges nearly along each other push none")
{
    for (const double turn : {0.03, 0.09, 0.3}) {
        SurfaceMesh above = box(Vec3::Ones());
        const Mat3 about = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
        for (Vec3& x : above.vertices)
            x = about * x + Vec3(0.01, 1 - 1e-3, 0.02);
        World world;
        world.bodies.push_back(
            std::make_unique<RigidBody>("above", above, mass_properties(above, 1000), Vec3(0, 90, 0)));
        add_static(world, box(Vec3::Ones()));
        for (const auto& body : world.bodies)
            body->predict(Vec3::Zero(), 0.01);  // it will have left
        InsidePairs inside;
        Contacts contacts;
        inside.trace(world);
        inside.append_pairs(world, contacts);
        int pairs = 0;
        for (const Contact& contact : contacts) {
            if (contact.kind != ContactKind::edge_edge)
                continue;
            const auto along = [&](std::size_t i) {
                return Vec3(contact_vertex(world, contact, static_cast<int>(i) + 1, 0) -
                            contact_vertex(world, contact, static_cast<int>(i), 0))
                    .normalized();
            };
            CHECK(along(0).cross(along(2)).norm() >= smallest_edge_sine);
            ++pairs;
        }
        CAPTURE(turn);
        CHECK(pairs > 0);
    }
}

TEST_CASE("inside pairs: what pokes through any face of a box gets its pairs with this face")
{
    const SurfaceMesh large = box(Vec3(1, 2, 3));
    for (int face = 0; face < static_cast<int>(large.faces.size()); ++face) {
        Vec3 middle = Vec3::Zero();
        for (const int corner : large.faces[static_cast<std::size_t>(face)])
            middle += large.vertices[static_cast<std::size_t>(corner)] / 3;
        World world;
        add_static(world, large);
        add_rigid(world, moved(box(Vec3::Constant(0.1)), middle + Vec3(1e-3, 2e-3, 3e-3)));
        InsidePairs inside;
        Contacts contacts;
        inside.trace(world);
        inside.append_pairs(world, contacts);
        const auto with_face = std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
            return contact.kind == ContactKind::vertex_face && contact.body_a == 1 &&
                   contact.feature_b == face;
        });
        CAPTURE(face);
        CHECK(with_face == 4);
    }
}
