#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_contact_by_distance/begins_inside.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/inside_pairs.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/triangle_distance.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

using namespace enduring;

namespace {

std::unique_ptr<Body> still(const SurfaceMesh& mesh)
{
    return std::make_unique<StaticBody>(
        "still", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
}

/// A block of 20 kg and 0.4 m that begins so deep in a floor.
World block_in_floor(double depth, double leaning = 0)
{
    SurfaceMesh floor = box({2, 1, 2}, {7, 3, 7}), block = box(Vec3::Constant(0.4), {2, 2, 2});
    for (Vec3& x : floor.vertices)
        x.y() -= 0.5;
    const Mat3 turn = Eigen::AngleAxisd(leaning, Vec3(1, 0.2, 0.7).normalized()).toRotationMatrix();
    double lowest = 0;
    for (Vec3& x : block.vertices) {
        x = turn * x;
        lowest = std::min(lowest, x.y());
    }
    for (Vec3& x : block.vertices)
        x += Vec3(0.013, -lowest - depth, 0.021);
    World world;
    world.bodies.push_back(still(floor));
    world.bodies.push_back(
        std::make_unique<RigidBody>("block", block, with_mass(mass_properties(block, 1000), 20)));
    return world;
}

double lowest_of(const Body& body)
{
    double lowest = 1e9;
    for (const Vec3& x : body.positions_t0())
        lowest = std::min(lowest, x.y());
    return lowest;
}

bool is_in(const Body& body, const Vec3& x)
{
    return winding_number(body.surface().faces(), body.positions_t0(), x) > 0.5;
}

}  // namespace

TEST_CASE("inside pairs: each vertex inside gets one pair, none outside does, and a second look adds none")
{
    const World world = block_in_floor(0.13, 0.3);
    InsidePairs inside;
    Contacts contacts;
    inside.trace(world);
    inside.append_pairs(world, contacts);
    std::map<std::pair<int, int>, int> pairs;
    for (const Contact& contact : contacts)
        ++pairs[{contact.body_a, contact.feature_a}];
    long all = 0;
    for (const int body : {0, 1})
        for (int vertex = 0; vertex < world.bodies[body]->surface().vertex_count(); ++vertex) {
            const int expected = is_in(*world.bodies[1 - body], world.bodies[body]->positions_t0()[vertex]);
            CHECK(pairs[{body, vertex}] == expected);
            all += expected;
        }
    CHECK(all > 3);
    const std::size_t before = contacts.size();
    inside.trace(world);
    inside.append_pairs(world, contacts);
    CHECK(contacts.size() == before);
}

TEST_CASE("inside pairs: what was traced serves any list of pairs, until the next trace")
{
    const World world = block_in_floor(0.13, 0.3), apart = block_in_floor(-0.01, 0.3);
    InsidePairs inside;
    Contacts all, none;
    inside.append_pairs(world, all);
    CHECK(all.empty());  // nothing is traced yet
    inside.trace(world);
    inside.append_pairs(world, all);
    REQUIRE(all.size() > 3);
    Contacts some(all.begin() + 2, all.end());
    inside.append_pairs(world, some);
    std::set<PairKey> keys;
    for (const Contact& contact : some)
        keys.insert(key_of(contact));
    CHECK(some.size() == all.size());
    CHECK(keys.size() == all.size());

    const auto least_along = [&](const World& of) {
        double least = 1;
        for (const Contact& contact : all)
            least = std::min(least, inside.part_along_direction(of, contact));
        return least;
    };
    CHECK(least_along(world) < 1);
    inside.trace(apart);
    inside.append_pairs(apart, none);
    CHECK(none.empty());
    CHECK(least_along(apart) == 1);
}

TEST_CASE(
    "depenetration: a block that begins in a floor comes up slowly and rests, while with chapter 7 it falls")
{
    for (const double depth : {0.001, 0.05, 0.4})
        for (const double leaning : {0.0, 0.3}) {
            CAPTURE(depth);
            CAPTURE(leaning);
            World world = block_in_floor(depth, leaning);
            ContactParameters parameters;
            parameters.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.4};
            const Solver solver = chapter09_solver(parameters);
            Contacts contacts;
            double fastest = 0, highest = -1;
            for (int step = 0; step < 300; ++step) {
                advance(world, contacts, solver, 0.01);
                fastest = std::max(fastest, world.bodies[1]->mean_velocity().y());
                highest = std::max(highest, lowest_of(*world.bodies[1]));
            }
            CHECK(fastest < 0.4);
            CHECK(highest < 1e-4);
            CHECK(lowest_of(*world.bodies[1]) > -1e-4);
            CHECK(world.bodies[1]->mean_velocity().norm() < 1e-3);
        }
    World world = block_in_floor(0.001);
    Contacts contacts;
    const Solver solver = chapter07_solver({});
    for (int step = 0; step < 100; ++step)
        advance(world, contacts, solver, 0.01);
    CHECK(lowest_of(*world.bodies[1]) < -4);
}

TEST_CASE("depenetration: chapter 8 refuses what begins inside, and names both bodies")
{
    for (const double depth : {0.002, 0.02, 0.4}) {
        CAPTURE(depth);
        World world = block_in_floor(depth);
        Contacts contacts;
        CHECK_THROWS_WITH_AS(advance(world, contacts, chapter08_solver({}), 0.01),
                             doctest::Contains("begin inside each other"), InputError);
    }
}

TEST_CASE("depenetration: what begins inside comes out, as far as its skin")
{
    for (const double depth : {0.002, 0.05}) {
        World world = block_in_floor(depth);
        Contacts contacts;
        const Solver solver = chapter09_solver({});
        for (int step = 0; step < 200; ++step)
            advance(world, contacts, solver, 0.01);
        CAPTURE(depth);
        CHECK(bodies_inside_each_other(world).empty());
        CHECK(std::abs(lowest_of(*world.bodies[1])) < 1e-5);
    }
}

TEST_CASE(
    "depenetration: a block that is laid exactly on triangles is not thrown off, as it was by chapter 6")
{
    double most[3] = {0, 0, 0};
    for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
        const Mat3 slope = Eigen::AngleAxisd(std::numbers::pi / 18, Vec3::UnitZ()).toRotationMatrix(),
                   turn = Eigen::AngleAxisd(turned, Vec3::UnitY()).toRotationMatrix();
        SurfaceMesh slab = box({4, 0.4, 4}, {8, 1, 8}), block = box({1, 0.25, 1});
        for (Vec3& x : slab.vertices)
            x = slope * (x - Vec3(0, 0.2, 0));
        for (Vec3& x : block.vertices)
            x = slope * (turn * x + Vec3::Constant(0.125));
        const ContactParameters parameters{PenaltyMethod::continuous, 12000};
        const Solver solvers[] = {chapter06_solver(parameters), chapter08_solver(parameters),
                                  chapter09_solver(parameters)};
        for (int i = 0; i < 3; ++i) {
            World world;
            world.bodies.push_back(still(slab));
            world.bodies.push_back(
                std::make_unique<RigidBody>("block", block, with_mass(mass_properties(block, 1000), 20)));
            const auto energy = [&] { return world.bodies[1]->energy(world.gravity).total(); };
            const double before = energy();
            Contacts contacts;
            for (int step = 0; step < 80; ++step) {
                advance(world, contacts, solvers[i], 0.01);
                most[i] = std::max(most[i], energy() - before);
            }
        }
    }
    CHECK(most[0] > 100);
    CHECK(most[1] < 1e-3);
    CHECK(most[2] < 1e-3);
}

TEST_CASE(
    "depenetration: a ball in a bowl's wall or a cushion, and a block in a plane, come out slowly and stay down")
{
    using namespace enduring::chapter09;
    for (const std::size_t place : {1U, 2U, 3U}) {
        const Surroundings& surroundings = all_surroundings()[place];
        CAPTURE(surroundings.name);
        Scene scene = scene_inside(surroundings, place == 1 ? "leaning block" : "ball", 0.15, 0.01);
        double fastest = 0, highest = -1;
        bool inside = true;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            inside = inside && deepest_inside(world) > 1e-3;
            fastest = std::max(fastest, inside ? world.bodies.back()->mean_velocity().norm() : 0);
            highest = std::max(highest, lowest_vertex(world));
        });
        run(scene, chapter09_solver(scene.contact), {&watch}, {.steps = 150});
        CHECK_FALSE(inside);
        CHECK(fastest > 0.9 * scale_parts.max_depenetration_velocity * std::sqrt(9.81 * 0.4));
        CHECK(fastest < 0.5);
        CHECK(highest < 0.01);
    }
}

TEST_CASE("depenetration: a scene says how fast")
{
    using namespace enduring::chapter09;
    for (const double speed : {0.1, 0.7}) {
        Scene scene = scene_inside(all_surroundings()[0], "block", 0.1, 0.01);
        scene.contact.max_depenetration_velocity = speed;
        double fastest = 0;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            fastest = std::max(fastest, world.bodies.back()->mean_velocity().y());
        });
        run(scene, chapter09_solver(scene.contact), {&watch}, {.steps = 60});
        CHECK(fastest == doctest::Approx(speed).epsilon(0.02));
    }
}

TEST_CASE("depenetration: half-way between two directions, to a rounding, a body takes one and does not wait")
{
    using namespace enduring::chapter09;
    for (const auto& ground : {std::pair(0, 1.0), std::pair(3, 0.8)})
        for (const double hair : {-1e-9, 0.0, 1e-9}) {
            const double thickness = ground.second;
            CAPTURE(thickness);
            CAPTURE(hair);
            const Surroundings& surroundings = all_surroundings()[ground.first];
            const double depth = (thickness + height_of(surroundings, "block")) / 2 + hair;
            Scene scene = scene_inside(surroundings, "block", depth, 0.01);
            scene.contact.max_depenetration_velocity = 0.35;  // so that it is out in time
            run(scene, chapter09_solver(scene.contact), {}, {.steps = 240});
            CHECK(deepest_inside(scene.world) < 1e-3);
        }
}

TEST_CASE(
    "depenetration: without gravity a body comes out by the same part of its size in a step of any length")
{
    for (const double dt : {0.001, 0.01, 0.03}) {
        World world = block_in_floor(0.1);
        world.gravity.setZero();
        Contacts contacts;
        const Solver solver = chapter09_solver({});
        double most = 0, last = lowest_of(*world.bodies[1]);
        for (int step = 0; step < 30; ++step) {
            advance(world, contacts, solver, dt);
            const double now = lowest_of(*world.bodies[1]);
            most = std::max(most, now - last);
            last = now;
        }
        CAPTURE(dt);
        const double part = scale_parts.max_depenetration_velocity / scale_parts.weightless_steps;
        CHECK(most / world.bodies[1]->size() / part == doctest::Approx(1).epsilon(0.01));
    }
}
