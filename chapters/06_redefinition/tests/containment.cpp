#include "chapters/06_redefinition/solver.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/simulation/rigid_body.hpp"

#include <cmath>
#include <map>

using namespace enduring;
using namespace enduring::small_worlds;

namespace {

struct Bookkeeping {
    long inside = 0, without_pair = 0, outside_with_pair = 0, twice = 0;
};

void check_bodies(const World& world, int a, int b, const Contacts& contacts, Bookkeeping& books)
{
    std::map<int, int> pairs;
    for (const Contact& c : contacts)
        if (c.kind == ContactKind::vertex_face && !c.resolved && c.body_a == a && c.body_b == b)
            ++pairs[c.feature_a];
    const Body &mine = *world.bodies[a], &other = *world.bodies[b];
    for (int v = 0; v < mine.surface().vertex_count(); ++v) {
        const bool inside = winding_number(other.surface().faces(), other.positions_t0(),
                                           mine.positions_t0()[v]) > 0.5;
        const int count = pairs.count(v) ? pairs[v] : 0;
        books.inside += inside;
        books.without_pair += inside && count == 0;
        books.outside_with_pair += !inside && count > 0;
        books.twice += count > 1;
    }
}

/// Cubes of 0.5 m and 20 kg, one on the other, each `aside` off the one below; on an analytic ground.
World tower(const Vec3& aside)
{
    World world;
    world.planes.push_back({"ground", Vec3::Zero(), Vec3::UnitY()});
    for (int i = 0; i < 3; ++i) {
        SurfaceMesh cube = box({0.5, 0.5, 0.5});
        for (Vec3& x : cube.vertices)
            x += Vec3(0, 0.25 + 0.5001 * i, 0) + (i % 2) * aside;
        MassProperties properties = mass_properties(cube, 160);
        // Axes a little askew, so that coordinates are rounded. Cubes along
        // their axes stay exact, and win nothing.
        properties.inertia += 1e-3 * properties.inertia(0, 0) * Vec3(1, 2, -3) * Vec3(1, 2, -3).transpose();
        world.bodies.push_back(std::make_unique<RigidBody>("cube " + std::to_string(i), cube, properties));
    }
    return world;
}

double energy(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->energy(world.gravity).kinetic + body->energy(world.gravity).gravitational;
    return sum;
}

}  // namespace

TEST_CASE("containment: a vertex has a pair with a body exactly while it is inside, by winding numbers")
{
    Scene scene = load_scene(scene_file("bunny_bowl"));
    Bookkeeping books;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        if (world.step < 45 || world.step % 5 != 0)
            return;
        check_bodies(world, 0, 1, contacts, books);
        check_bodies(world, 1, 0, contacts, books);
    });
    run(scene, chapter06_solver(scene.contact), {&watch}, {130, {}});
    CHECK(books.inside > 200);
    CHECK(books.without_pair == 0);
    CHECK(books.outside_with_pair == 0);
    CHECK(books.twice == 0);
}

namespace {

struct TowerMotion {
    double max_won = 0;   ///< largest energy above that at first [J]
    double sideways = 0;  ///< of the fastest cube at the end [m/s]
};

/// One second of the tower without friction. The springs' own energy is
/// not counted: what is won here is more still.
TowerMotion stand(const Vec3& aside)
{
    World world = tower(aside);
    Contacts contacts;
    const Solver solver = chapter06_solver({PenaltyMethod::continuous, 20000});
    const double at_first = energy(world);
    TowerMotion motion;
    for (int step = 0; step < 1000; ++step) {
        advance(world, contacts, solver, 0.001);
        motion.max_won = std::max(motion.max_won, energy(world) - at_first);
    }
    for (const auto& body : world.bodies) {
        const Vec3 speed = body->mean_velocity();
        motion.sideways = std::max(motion.sideways, std::hypot(speed.x(), speed.z()));
    }
    return motion;
}

}  // namespace

TEST_CASE("tower: cubes that stand a little beside each other win no energy and do not jump aside")
{
    const TowerMotion motion = stand({0.03, 0, 0.02});
    CHECK(motion.max_won < 1e-6);
    CHECK(motion.sideways < 0.15);
}

TEST_CASE(
    "tower: cubes that stand exactly edge on edge win a little energy, for their rims are in and out at once, but do not jump aside")
{
    const TowerMotion motion = stand(Vec3::Zero());
    CHECK(motion.max_won > 1e-3);  // the limit is real: when this fails, the page may say so
    CHECK(motion.max_won < 2);     // of 441 J
    CHECK(motion.sideways < 0.15);
}
