#include "exercises/11_exact_contact/4_adapter_units.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <Eigen/Geometry>
#include <cmath>

using namespace enduring;

namespace {

constexpr EngineUnits cgs{0.01, 0.001, 1};  // centimetres, grams, seconds

/// A brick of 20 by 10 by 5 cm that tumbles.
OurBox brick()
{
    return {{0.2, 0.1, 0.05},      2,   {0.0021, 0.0071, 0.0083}, {0.3, -2, 0.1}, {4, -1, 3},
            {0.5, 0.1, -0.7, 0.5}, 0.36};
}

/// Units of any size: of an ant, of a ship, of the tick of a clock.
EngineUnits random_units(RandomInputs& random)
{
    const double length = std::exp(random.normal()), mass = std::exp(random.normal()),
                 time = std::exp(random.normal());
    return {length, mass, time};
}

std::string told(const EngineUnits& units)
{
    return std::to_string(units.length) + " m, " + std::to_string(units.mass) + " kg, " +
           std::to_string(units.time) + " s";
}

/// A step of an engine that knows numbers, and no units: the box falls, its lowest point is at `arm`, and the
/// floor stops this point, without friction.
struct Landed {
    Vec3 velocity, angular_velocity, impulse;
};
Landed land(const TheirBox& box, const WorldSettings& world, const Vec3& arm)
{
    const Vec3 falling = box.velocity + world.dt * world.gravity, up = Vec3::UnitY();
    const Vec3 lever = arm.cross(up), turned = lever.cwiseQuotient(box.inertia);
    const double coming = -up.dot(falling + box.angular_velocity.cross(arm));
    const double impulse = coming / (1 / box.mass + lever.dot(turned));
    return {falling + impulse / box.mass * up, box.angular_velocity + impulse * turned, impulse * up};
}

}  // namespace

TEST_CASE("box: a brick in centimetres, grams and seconds")
{
    given("20 x 10 x 5 cm, 2 kg, 0.0021 kg m^2 about x, (0.3, -2, 0.1) m/s, (4, -1, 3) rad/s");
    const TheirBox box = box_for(cgs, brick());
    expect("half size", box.half_size, Vec3(10, 5, 2.5), 1e-12, "cm");
    expect("mass", box.mass, 2000, 1e-9, "g");
    expect("inertia", box.inertia, Vec3(21000, 71000, 83000), 1e-7, "g cm^2");
    expect("velocity", box.velocity, Vec3(30, -200, 10), 1e-11, "cm/s");
    expect("angular velocity", box.angular_velocity, Vec3(4, -1, 3), 1e-13, "rad/s");
}

TEST_CASE("box: its energy is the same, whatever the units")
{
    RandomInputs random(1);
    for (int i = 0; i < 100; ++i) {
        const EngineUnits units = random_units(random);
        given("units ", told(units));
        const OurBox ours = brick();
        const TheirBox box = box_for(units, ours);
        const double joules = units.mass * std::pow(units.length / units.time, 2);
        expect("energy of the motion, back in J", joules * 0.5 * box.mass * box.velocity.squaredNorm(),
               0.5 * ours.mass * ours.velocity.squaredNorm(), 1e-11, "J");
        expect("energy of the turn, back in J",
               joules * 0.5 * box.angular_velocity.cwiseAbs2().dot(box.inertia),
               0.5 * ours.angular_velocity.cwiseAbs2().dot(ours.inertia), 1e-11, "J");
    }
}

TEST_CASE("box: its corners are where they were")
{
    RandomInputs random(2);
    for (int i = 0; i < 100; ++i) {
        const EngineUnits units = random_units(random);
        given("units ", told(units), ", orientation (w, x, y, z) = (0.5, 0.1, -0.7, 0.5)");
        const OurBox ours = brick();
        const TheirBox box = box_for(units, ours);
        const auto [w, x, y, z] = ours.orientation;
        const auto [their_x, their_y, their_z, their_w] = box.orientation;
        const Vec3 corner = Eigen::Quaterniond(w, x, y, z) * Vec3(ours.size / 2);
        const Vec3 theirs = Eigen::Quaterniond(their_w, their_x, their_y, their_z) * box.half_size;
        expect("a corner, back in m", Vec3(units.length * theirs), corner, 1e-12, "m");
    }
}

TEST_CASE("friction: two boxes that slide on each other have our coefficient")
{
    for (const double mu : {0.0, 0.09, 0.36, 1.0, 1.44}) {
        OurBox ours = brick();
        ours.mu = mu;
        const TheirBox box = box_for(cgs, ours);
        given("mu ", mu);
        expect("product of two", box.friction * box.friction, mu, 1e-13, "");
    }
}

TEST_CASE("settings: gravity, step and slop in other units")
{
    const WorldSettings ours{{0, -9.81, 0}, 0.01, 1e-4};
    given("gravity (0, -9.81, 0) m/s^2, dt 0.01 s, slop 0.1 mm, in centimetres and seconds");
    const WorldSettings cm = settings_for(cgs, ours);
    expect("gravity", cm.gravity, Vec3(0, -981, 0), 1e-10, "cm/s^2");
    expect("dt", cm.dt, 0.01, 1e-16, "s");
    expect("slop", cm.slop, 0.01, 1e-15, "cm");
    given("the same in metres and milliseconds");
    const WorldSettings ms = settings_for({1, 1, 0.001}, ours);
    expect("gravity", ms.gravity, Vec3(0, -9.81e-6, 0), 1e-18, "m/ms^2");
    expect("dt", ms.dt, 10, 1e-13, "ms");
    expect("slop", ms.slop, 1e-4, 1e-18, "m");
    say("gravity in centimetres and milliseconds: ", settings_for({0.01, 1, 0.001}, ours).gravity.y());
}

TEST_CASE("impulse: what the engine tells, in N s")
{
    given("(0, 300000, -1000) g cm/s");
    expect("impulse", impulse_from(cgs, Vec3(0, 300000, -1000)), Vec3(0, 3, -0.01), 1e-14, "N s");
}

TEST_CASE("landing: the engine computes the same, whatever its units")
{
    RandomInputs random(3);
    const WorldSettings ours{{0, -9.81, 0}, 0.02, 1e-4};
    const OurBox box = brick();
    const Vec3 arm(0.08, -0.06, 0.02);
    const Vec3 falling = box.velocity + ours.dt * ours.gravity;
    const Vec3 lever = arm.cross(Vec3::UnitY());
    const double coming = -(falling + box.angular_velocity.cross(arm)).y();
    const double impulse = coming / (1 / box.mass + lever.cwiseAbs2().dot(box.inertia.cwiseInverse()));
    for (int i = 0; i < 100; ++i) {
        const EngineUnits units = random_units(random);
        given("units ", told(units));
        const Landed landed = land(box_for(units, box), settings_for(units, ours), arm / units.length);
        expect("velocity, back in m/s", Vec3(units.length / units.time * landed.velocity),
               Vec3(falling + impulse / box.mass * Vec3::UnitY()), 1e-11, "m/s");
        expect("angular velocity, back in rad/s", Vec3(landed.angular_velocity / units.time),
               Vec3(box.angular_velocity + impulse * lever.cwiseQuotient(box.inertia)), 1e-10, "rad/s");
        expect("impulse", impulse_from(units, landed.impulse), Vec3(0, impulse, 0), 1e-11, "N s");
    }
}
