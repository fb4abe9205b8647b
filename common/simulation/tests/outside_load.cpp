#include "common/simulation/outside_load.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace enduring;

namespace {

constexpr double mass = 3;

std::unique_ptr<RigidBody> brick(const Vec3& velocity = Vec3::Zero(), const Vec3& spin = Vec3::Zero())
{
    const SurfaceMesh mesh = box({0.5, 0.3, 0.2});
    return std::make_unique<RigidBody>("brick", mesh, with_mass(mass_properties(mesh, 1), mass), velocity,
                                       spin);
}

World weightless(std::unique_ptr<Body> body)
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(std::move(body));
    return world;
}

Solver halving()
{
    Solver solver;
    solver.max_halvings = 5;
    return solver;
}

}  // namespace

TEST_CASE(
    "outside load: a vector over time is linear between its rows, zero outside, and its integral has no step")
{
    const TimedVector pulse({{1, Vec3(0, 2, 0)}, {2, Vec3(4, 2, 0)}, {2.5, Vec3(4, 0, 0)}});
    CHECK((pulse.integral(0, 9) - Vec3(4, 2.5, 0)).norm() < 1e-14);
    CHECK(pulse.integral(-1, 1).isZero(0));
    CHECK(pulse.integral(2.5, 7).isZero(0));
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < 100; ++i)
        sum += pulse.integral(0.03 * i, 0.03 * (i + 1));
    CHECK((sum - pulse.integral(0, 3)).norm() < 1e-13);
    CHECK((TimedVector(Vec3(1, 2, 3)).integral(4, 4.5) - Vec3(0.5, 1, 1.5)).norm() < 1e-14);
    CHECK_THROWS_AS(TimedVector({{1, Vec3::Zero()}, {0.5, Vec3::Zero()}}), std::invalid_argument);
}

TEST_CASE("outside load: a force gives a body of any kind F t / m, whatever the step, and its work is booked")
{
    const TimedVector force({{0, Vec3(6, 0, 0)}, {1, Vec3(6, 0, 3)}});
    for (const double dt : {0.01, 0.004, 0.05})
        for (const bool soft : {false, true}) {
            CAPTURE(dt);
            CAPTURE(soft);
            std::unique_ptr<Body> body;
            if (soft) {
                DeformableSettings settings;
                settings.material = {1e5, 0.3, mass};
                auto made = std::make_unique<DeformableBody>("soft", bar(Vec3::Ones(), {2, 1, 1}), settings);
                made->add_force(force);
                body = std::move(made);
            } else {
                auto made = brick();
                made->add_load({force});
                body = std::move(made);
            }
            World world = weightless(std::move(body));
            Contacts contacts;
            for (int step = 0; step < std::lround(1 / dt); ++step)
                advance(world, contacts, halving(), dt);
            CHECK((world.bodies[0]->mean_velocity() - Vec3(6, 0, 1.5) / mass).norm() < 1e-9);
            CHECK(world.thrown_away == 0);
            const double kinetic = total_energy(world).total();
            CHECK(world.driven >= kinetic);
            CHECK(world.driven == doctest::Approx(kinetic).epsilon(2 * dt));
        }
}

TEST_CASE(
    "outside load: a force at a point turns the body by its lever, in the world's axes or in the body's")
{
    constexpr double dt = 1e-3;
    for (const bool along : {false, true}) {
        CAPTURE(along);
        auto body = brick(Vec3::Zero(), Vec3(0, 0, 2));
        const double inertia = mass / 12 * (0.5 * 0.5 + 0.3 * 0.3);
        body->add_load(
            {TimedVector(Vec3(0, 1, 0)), TimedVector(Vec3(0, 0, 0.01)), Vec3(0.25, 0.1, 0), along});
        World world = weightless(std::move(body));
        Contacts contacts;
        Vec3 velocity = Vec3::Zero();
        double spin = 2, angle = 0;
        for (int step = 0; step < 500; ++step) {
            advance(world, contacts, halving(), dt);
            const Vec3 lever = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Vec3(0.25, 0.1, 0),
                       force = along ? Eigen::AngleAxisd(angle, Vec3::UnitZ()) * Vec3(0, 1, 0)
                                     : Vec3(0, 1, 0);
            velocity += dt / mass * force;
            spin += dt / inertia * (0.01 + lever.cross(force).z());
            angle += dt * spin;
        }
        const RigidMotion& motion = dynamic_cast<const RigidBody&>(*world.bodies[0]).motion();
        CHECK((motion.velocity() - velocity).norm() < 1e-10);
        CHECK(motion.angular_velocity().z() == doctest::Approx(spin).epsilon(1e-9));
        CHECK(world.thrown_away == 0);
    }
}

TEST_CASE("outside load: what it takes from a body that it brakes is booked, too")
{
    auto body = brick(Vec3(5, 0, 0));
    body->add_load({TimedVector(Vec3(-12, 0, 0))});
    World world = weightless(std::move(body));
    Contacts contacts;
    const double before = total_energy(world).total();
    for (int step = 0; step < 100; ++step)
        advance(world, contacts, halving(), 0.01);
    CHECK(world.driven == doctest::Approx(total_energy(world).total() - before).epsilon(0.02));
    CHECK(world.driven < -30);
}

TEST_CASE("outside load: a step that is thrown away has booked nothing")
{
    auto body = brick();
    body->add_load({TimedVector(Vec3(6, 0, 0))});
    World world = weightless(std::move(body));
    Solver solver = halving();
    int tried = 0;
    solver.append(StepStage::finish, "trouble", [&](World& w, Contacts&, double) {
        if (++tried == 1)
            w.bodies[0]->apply_impulse(0, Vec3(100, 0, 0));
    });
    Contacts contacts;
    advance(world, contacts, solver, 0.01);
    CHECK(world.thrown_away == 1);
    CHECK(world.driven == doctest::Approx(6 * 0.005 * (0.01 + 0.02)));
}

TEST_CASE("gravity switched off: a body stays, and its height is no energy")
{
    World world;
    world.bodies.push_back(brick());
    DeformableSettings settings;
    settings.material = {1e5, 0.3, 100};
    settings.position = Vec3(0, 5, 0);
    world.bodies.push_back(std::make_unique<DeformableBody>("soft", bar(Vec3::Ones(), {2, 1, 1}), settings));
    for (const auto& body : world.bodies)
        body->switch_gravity_off();
    Contacts contacts;
    for (int step = 0; step < 20; ++step)
        advance(world, contacts, {}, 0.01);
    for (const auto& body : world.bodies) {
        CHECK(body->mean_velocity().norm() < 1e-9);
        CHECK(body->energy(world.gravity).gravitational == 0);
    }
}

TEST_CASE(
    "outside load: a vector that is turned is so at all times, also where it is the same at all of them")
{
    const Quaternion quarter(Eigen::AngleAxisd(std::acos(0.0), Vec3::UnitZ()));
    const TimedVector pulse({{1, Vec3(0, 2, 0)}, {2, Vec3(4, 2, 0)}});
    CHECK((pulse.turned(quarter).integral(1, 2) - Vec3(-2, 2, 0)).norm() < 1e-14);
    CHECK((TimedVector(Vec3(1, 2, 3)).turned(quarter).integral(0, 1) - Vec3(-2, 1, 3)).norm() < 1e-14);
    CHECK_THROWS_AS(TimedVector({{1, Vec3::Zero()}, {1, Vec3::Ones()}}), std::invalid_argument);
}

TEST_CASE(
    "outside load: a spring swings a body with the period 2 pi sqrt(m / k), and turns it where it is not at the centre")
{
    auto body = brick();
    OutsideLoad load;
    load.spring = AnchoredSpring{Vec3(0.3, 0, 0), 120, 0.2};
    body->add_load(load);
    World world = weightless(std::move(body));
    Contacts contacts;
    double first = -1, before = -0.1, farthest = 0;
    constexpr double dt = 1e-3;
    int passes = 0;
    while (world.time < 8 && passes < 7) {
        advance(world, contacts, halving(), dt);
        const double now = world.bodies[0]->centre().x() - 0.1;  // where the spring is as long as it rests
        if (before < 0 && now >= 0 && ++passes == 1)
            first = world.time - dt * now / (now - before);
        before = now;
        farthest = std::max(farthest, now);
    }
    CHECK(passes == 7);
    CHECK(farthest == doctest::Approx(0.1).epsilon(1e-3));  // no farther than it began on the other side
    CHECK(world.thrown_away == 0);
    CHECK((world.time - first) / 6 == doctest::Approx(2 * 3.14159265 * std::sqrt(mass / 120)).epsilon(1e-3));

    auto hung = brick();
    load.spring = AnchoredSpring{Vec3(0.25, 0.5, 0), 10, 0};
    load.point = Vec3(0.25, 0.1, 0);
    hung->add_load(load);
    World other = weightless(std::move(hung));
    advance(other, contacts, {}, dt);
    const RigidMotion& motion = dynamic_cast<const RigidBody&>(*other.bodies[0]).motion();
    CHECK((motion.velocity() - Vec3(0, 4 * dt / mass, 0)).norm() < 1e-15);
    CHECK(motion.angular_momentum(motion.centre()).z() == doctest::Approx(0.25 * 4 * dt));
}
