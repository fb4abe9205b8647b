#include "chapters/07_implicit_contact/restitution.hpp"

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_state.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/state_archive.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace enduring;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Balls of a kilogram in a line, each touching the next: how their pairs answer.
MatrixXd line_of_balls(int balls)
{
    MatrixXd pairs = MatrixXd::Zero(balls - 1, balls);
    for (int i = 0; i + 1 < balls; ++i) {
        pairs(i, i) = -1;
        pairs(i, i + 1) = 1;
    }
    return pairs;
}

/// A matrix at random whose rows are pairs and whose columns are coordinates of unit mass.
MatrixXd random_pairs(int pairs, int coordinates, std::mt19937& random)
{
    std::normal_distribution<double> number;
    return MatrixXd::NullaryExpr(pairs, coordinates, [&] { return number(random); });
}

/// A ball or two above the ground.
Scene falling(const std::string& restitution)
{
    return read_scene(R"({"name": "f", "dt": 0.01, "duration": 1, "planes": [{"name": "ground"}],
        "contact": {"friction": {"model": "mass_splitting"})" +
                          restitution + R"(}, "bodies": [
        {"name": "a", "type": "rigid", "shape": {"box": {"size": [0.2, 0.2, 0.2]}}, "mass": 1, "position": [0, 0.6, 0],
         "rotation": {"axis": [1, 2, 3], "angle_deg": 33}},
        {"name": "b", "type": "rigid", "shape": {"sphere": {"radius": 0.1, "subdivisions": 1}}, "mass": 1, "position": [0.7, 0.5, 0]}]})",
                      "", "f.json", {});
}

/// All numbers at the end of some steps.
std::vector<double> numbers_after(Scene scene, const Solver& solver, int steps)
{
    Contacts contacts;
    for (int step = 0; step < steps; ++step)
        advance(scene.world, contacts, solver, scene.dt);
    StateArchive archive;
    for (const auto& body : scene.world.bodies)
        body->visit_state(archive);
    for (Contact& contact : contacts)
        visit_state(archive, contact);
    return archive.numbers();
}

/// A cube of 10 kg on the corners of whose lower side the ground has pushed, behind the commit of this step.
struct PushedCube {
    static constexpr double dt = 0.01, pressed = 1e-4, impulse = 2.5;  ///< each corner's [s], [m], [N s]
    World world;
    Contacts contacts;

    explicit PushedCube(const Vec3& velocity)
    {
        world.planes.push_back({"ground"});
        world.restitution.between = {0.5};
        SurfaceMesh mesh = box(Vec3::Ones());
        for (Vec3& x : mesh.vertices)
            x.y() += 0.5 - pressed;
        world.bodies.push_back(
            std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1000), 10), velocity));
        world.bodies[0]->update_prediction(dt);
        for (int vertex = 0; vertex < 8; ++vertex) {
            if (mesh.vertices[static_cast<std::size_t>(vertex)].y() > 0.5)
                continue;
            Contact& corner = contacts.emplace_back();
            corner = {ContactKind::vertex_plane, 0, 0, vertex, -1, {vertex, -1, -1, -1}, {1, 0, 0, 0}};
            corner.state = ContactState::answered;
            corner.impulse = impulse * Vec3::UnitY();
            corner.friction = 0.2 * impulse * Vec3::UnitX();
            corner.spring.stiffness = impulse / (pressed * dt);
        }
    }
    Island pushed() { return pushed_part(world, find_islands(world, contacts).at(0), dt); }
};

}  // namespace

TEST_CASE("restitution: what was pressed when the step began bounces no more")
{
    // It comes with 1 m/s and is stopped in this step, or was stopped before.
    PushedCube open(Vec3(0, -0.02, 0)), closed(Vec3(0, -0.02, 0));
    for (Contact& corner : open.contacts)
        corner.began_open = true;
    const Island island = open.pushed();
    REQUIRE(island.contacts.size() == 4);
    for (const PushedPair& pair : impact_of(open.world, island, {}, PushedCube::dt).pairs)
        CHECK(pair.meets);
    CHECK(closed.pushed().contacts.empty());
    const Island all = find_islands(closed.world, closed.contacts).at(0);
    for (const PushedPair& pair : impact_of(closed.world, all, {}, PushedCube::dt).pairs)
        CHECK_FALSE(pair.meets);
}

TEST_CASE("restitution: an impact may give back what its impulses took, and no more")
{
    const Vec3 after(-0.3, -0.02, 0), before = after - 4 * PushedCube::impulse * Vec3(0.2, 1, 0) / 10;
    PushedCube cube(after);
    for (Contact& corner : cube.contacts)
        corner.began_open = true;
    const IslandImpact impact = impact_of(cube.world, cube.pushed(), {}, PushedCube::dt);
    // friction acts at the corners, half a metre below the centre, and turns the cube, which does not turn
    // behind the step
    const double torque = 4 * 0.2 * PushedCube::impulse * (0.5), inertia = 10 / 6.0;
    CHECK(impact.lost ==
          doctest::Approx(5 * (before.squaredNorm() - after.squaredNorm()) + torque * torque / inertia / 2));
}

TEST_CASE("reflections: a line of balls hands its momentum on, ball by ball")
{
    for (const int balls : {2, 3, 5, 20}) {
        const MatrixXd pairs = line_of_balls(balls);
        VectorXd velocities = VectorXd::Zero(balls);
        velocities[0] = 1;
        velocities += pairs.transpose() * reflecting_impulses(pairs * pairs.transpose(), pairs * velocities);
        VectorXd expected = VectorXd::Zero(balls);
        expected[balls - 1] = 1;
        CAPTURE(balls);
        CHECK((velocities - expected).norm() < 1e-6);
    }
}

TEST_CASE("reflections: two balls that hit three send two on")
{
    const MatrixXd pairs = line_of_balls(5);
    VectorXd velocities(5), expected(5);
    velocities << 1, 1, 0, 0, 0;
    expected << 0, 0, 0, 1, 1;
    velocities += pairs.transpose() * reflecting_impulses(pairs * pairs.transpose(), pairs * velocities);
    CHECK((velocities - expected).norm() < 1e-6);
}

TEST_CASE("reflections: random impacts keep the kinetic energy, end without approach, and never pull")
{
    std::mt19937 random(5);
    for (int run = 0; run < 200; ++run) {
        const MatrixXd pairs = random_pairs(1 + run % 6, 6, random);
        const VectorXd before = random_pairs(6, 1, random);
        const VectorXd impulses = reflecting_impulses(pairs * pairs.transpose(), pairs * before);
        const VectorXd after = before + pairs.transpose() * impulses;
        CAPTURE(run);
        CHECK(std::abs(after.squaredNorm() / before.squaredNorm() - 1) < 1e-10);
        CHECK((pairs * after).minCoeff() > -1e-6 * before.norm());
        CHECK(impulses.minCoeff() >= 0);
    }
}

TEST_CASE(
    "reflections: the impact without restitution leaves nobody approaching, and who got an impulse stays")
{
    std::mt19937 random(6);
    for (int run = 0; run < 200; ++run) {
        const MatrixXd pairs = random_pairs(1 + run % 5, 6, random);
        const VectorXd before = pairs * VectorXd(random_pairs(6, 1, random));
        const MatrixXd response = pairs * pairs.transpose();
        const VectorXd impulses = stopping_impulses(response, before);
        const VectorXd after = before + response * impulses;
        CAPTURE(run);
        CHECK(impulses.minCoeff() >= 0);
        CHECK(after.minCoeff() > -1e-6);
        CHECK(std::abs(after.dot(impulses)) < 1e-6);
    }
}

TEST_CASE("reflections: the allowed part of some impulses brings exactly the energy that is allowed")
{
    for (const double slope : {-3.0, -0.5, 0.0, 2.0})
        for (const double curvature : {0.5, 4.0, 30.0})
            for (const double allowed : {0.01, 0.4, 2.0}) {
                const double part = allowed_part(slope, curvature, allowed);
                const double brought = part * slope + part * part * curvature / 2;
                CHECK(part > 0);
                CHECK(brought <= allowed + 1e-12);
                if (part < 1)
                    CHECK(brought == doctest::Approx(allowed));
            }
    CHECK(allowed_part(1, 1, -1) == 0);
    CHECK(allowed_part(-2, 1, -1) == 1);
}

TEST_CASE("restitution: the velocity at touch is that of a fall, wherever in the step the ground lies")
{
    constexpr double g = 9.81, dt = 0.01;
    for (const double height : {0.2, 0.2037, 0.2083, 0.5, 1.0}) {
        double y = height, v = 0;
        while (y + dt * (v - g * dt) > 0) {
            v -= g * dt;
            y += dt * v;
        }
        const PairImpact impact{.gap_t0 = y, .free_speed = v - g * dt, .acceleration = -g, .dt = dt};
        // at rest at first: the velocity belongs to the start of the run, not to the middle of a step
        const double fall = std::sqrt(2 * g * height + g * g * dt * dt / 4);
        CHECK(touching_speed(impact) == doctest::Approx(-fall).epsilon(1e-12));
        // and what leaves with it comes to this height again: half a step of weight before the first step
        const double leaves = speed_after(impact, fall);
        CHECK(leaves == doctest::Approx(fall + g * dt / 2));
    }
    CHECK(touching_speed({.gap_t0 = 0.1, .free_speed = 1, .acceleration = -g, .dt = dt}) == 0);
}

TEST_CASE("restitution: without coefficients a run has the bytes of one without the pass")
{
    Solver without = chapter07_solver(falling("").contact);
    without.remove("restitution");
    const std::vector<double> expected = numbers_after(falling(""), without, 60);
    CHECK(numbers_after(falling(""), chapter07_solver(falling("").contact), 60) == expected);
    CHECK(numbers_after(falling(R"(, "restitution": 0)"), chapter07_solver(falling("").contact), 60) ==
          expected);
    CHECK(numbers_after(falling(R"(, "restitution": 0.5)"), chapter07_solver(falling("").contact), 60) !=
          expected);
}

TEST_CASE("restitution: on pairs that are found by crossings a ball keeps e^2 of its height, too")
{
    for (const double e : {0.5, 1.0}) {
        Scene scene = falling(R"(, "restitution": )" + std::to_string(e));
        const Solver solver = chapter07_solver(scene.contact);
        Contacts contacts;
        double highest = 0;
        for (int step = 0; step < 100; ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            const Body& ball = *scene.world.bodies[1];
            if (ball.mean_velocity().y() > 0)
                highest = std::max(highest, ball.centre().y() - 0.1);
            else if (highest > 0)
                break;
        }
        CHECK(highest == doctest::Approx(0.4 * e * e).epsilon(0.02));
    }
}

namespace {

/// A ball of 2 rad/s that comes down with 1 m/s, above the ground by a step's path and a gap [m].
struct SpinningBall {
    static constexpr double dt = 0.01;
    World world;
    Contacts contacts;

    SpinningBall(double restitution, double gap, int subdivisions)
    {
        world.planes.push_back({"ground"});
        world.restitution.between = {restitution};
        world.gravity = Vec3::Zero();
        SurfaceMesh mesh = sphere(0.1, subdivisions);
        double lowest = 0;
        for (const Vec3& x : mesh.vertices)
            lowest = std::min(lowest, x.y());
        for (Vec3& x : mesh.vertices)
            x.y() += dt + gap - lowest;
        world.bodies.push_back(std::make_unique<RigidBody>("ball", mesh, mass_properties(mesh, 1000),
                                                           -Vec3::UnitY(), Vec3(0, 0, 2)));
    }
    double kinetic() const { return world.bodies[0]->energy(world.gravity).kinetic; }
    double up() const { return world.bodies[0]->mean_velocity().y(); }
    void advance_steps(const Solver& solver, int steps)
    {
        for (int step = 0; step < steps; ++step)
            advance(world, contacts, solver, dt);
    }
};

}  // namespace

TEST_CASE("restitution: a ball that spins bounces at the end of a step as it does within one")
{
    for (const int subdivisions : {2, 3})
        for (const double gap : {-1e-12, 0.0, 1e-12, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3}) {
            CAPTURE(gap);
            SpinningBall ball(0.8, gap, subdivisions);
            ball.advance_steps(chapter07_solver({}), 3);
            CHECK(ball.up() == doctest::Approx(0.8).epsilon(0.05));
        }
}

TEST_CASE("restitution: what an impact took of a ball that spins is what the ball has lost")
{
    SpinningBall ball(1, 1e-3, 2);
    Solver solver = chapter07_solver({});
    solver.remove("restitution");
    ball.advance_steps(solver, 1);
    const double before = ball.kinetic();
    ball.advance_steps(solver, 1);
    const Island island = find_islands(ball.world, ball.contacts).at(0);
    const IslandImpact impact = impact_of(ball.world, pushed_part(ball.world, island, SpinningBall::dt), {},
                                          SpinningBall::dt);
    CHECK(impact.lost > 0.1 * before);
    CHECK(impact.lost == doctest::Approx(before - ball.kinetic()).epsilon(1e-9));
}

TEST_CASE(
    "restitution: a pair that carried a load when the step began was not open, nor was one that was inside")
{
    PushedCube cube(Vec3(0, -0.02, 0));
    cube.contacts[1].spring.load = 1;
    remember_pairs(cube.world, cube.contacts, PushedCube::dt);  // the cube is inside by what it is pressed
    for (const Contact& corner : cube.contacts)
        CHECK_FALSE(corner.began_open);
    for (const double height : {0.0, 0.1}) {
        World& world = cube.world;
        SurfaceMesh mesh = box(Vec3::Ones());
        for (Vec3& x : mesh.vertices)
            x.y() += 0.5 + height;
        world.bodies[0] = std::make_unique<RigidBody>("cube", mesh,
                                                      with_mass(mass_properties(mesh, 1000), 10));
        for (Contact& corner : cube.contacts)
            corner.spring.load = 0;
        cube.contacts[1].spring.load = 1;
        remember_pairs(world, cube.contacts, PushedCube::dt);
        for (std::size_t corner = 0; corner < 4; ++corner)
            CHECK(cube.contacts[corner].began_open == (corner != 1));
    }
}
