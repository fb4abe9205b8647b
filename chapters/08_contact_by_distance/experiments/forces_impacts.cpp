#include "chapters/08_contact_by_distance/experiments/forces_impacts.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace enduring::chapter08::force_rows {
namespace {

constexpr double fall = 9.81;  // [m/s^2]

Quaternion tilt(double angle, const Vec3& axis)
{
    return Quaternion(Eigen::AngleAxisd(angle, axis.normalized()));
}

struct Thrown {
    std::string name;
    SurfaceMesh mesh;
    double mass;
    Vec3 velocity = Vec3::Zero();
};

struct Meeting {
    std::string name;
    std::vector<Thrown> bodies;
    bool gravity = true;
};

/// Few bodies that meet askew, so that chaos does not part the two orders within some steps of their meeting.
std::vector<Meeting> meetings()
{
    const SurfaceMesh slab = box({1, 0.2, 1}), cube = box({0.3, 0.3, 0.3}, {2, 2, 2});
    return {
        {"cube on a slab",
         {{"slab", moved(slab, Vec3(0, 0.1, 0)), 20},
          {"cube", moved(turned(cube, tilt(0.4, Vec3(1, 0.3, 2))), Vec3(0.1, 0.5, 0)), 3, Vec3(1, -2, 0)}}},
        {"ball on a cube",
         {{"cube", moved(box({0.4, 0.4, 0.4}), Vec3(0, 0.2, 0)), 5},
          {"ball", moved(sphere(0.1, 2), Vec3(0.05, 0.53, 0.02)), 1, Vec3(0.5, -2, 0)}}},
        {"two cubes in flight",
         {{"left", turned(cube, tilt(0.5, Vec3(1, 1, 0))), 1, Vec3(2, 0, 0)},
          {"right", moved(turned(cube, tilt(-0.7, Vec3(0, 1, 1))), Vec3(0.5, 0.05, 0.03)), 4,
           Vec3(-1, 0, 0)}},
         false},
    };
}

Scene scene_of_meeting(const Meeting& meeting, double dt, double restitution, bool swapped)
{
    Scene scene = empty_scene(dt, 0.5);
    scene.world.restitution.between = {restitution};
    if (meeting.gravity)
        add_ground(scene);
    else
        scene.world.gravity.setZero();
    std::vector<Thrown> bodies = meeting.bodies;
    if (swapped)
        std::reverse(bodies.begin(), bodies.end());
    for (const Thrown& body : bodies)
        add_rigid(scene, body.name, body.mesh, body.mass, body.velocity);
    return scene;
}

}  // namespace

Rows either_order(const MakeSolver& make, bool full)
{
    Row row{"order", "bodies on bodies, listed in one order and in the other", "their forces, in each step",
            "equal", 1e-3};
    for (const Meeting& meeting : meetings())
        for (const double dt : full ? std::vector{1.0 / 60, 0.005, 0.001} : std::vector{1.0 / 60}) {
            Stepped one(scene_of_meeting(meeting, dt, 0, false), make),
                other(scene_of_meeting(meeting, dt, 0, true), make);
            double largest = 0, off = 0;
            int worst = 0;
            for (int step = 1, met = 0; met < 20 && one.world().time < 1; ++step) {
                one.step();
                other.step();
                const Vec3 force = one.between(1, 0);
                met += met > 0 || !force.isZero(0);
                largest = std::max(largest, force.norm());
                const double difference = (force - other.between(0, 1)).norm();
                if (difference > off) {
                    off = difference;
                    worst = step;
                }
            }
            const std::string name = meeting.name + named(", dt", dt);
            row.add(worst > 0 ? name + ", step " + std::to_string(worst) : name,
                    largest > 0 ? 100 * off / largest : INFINITY);
        }
    return {row};
}

namespace {

/// Of one scene, until it has met: the worst step's momentum that forces do not tell, over the largest change
/// of a step.
void add_momentum(Row& row, const std::string& name, Scene scene, const MakeSolver& make, double duration)
{
    const double dt = scene.dt;
    Stepped run(std::move(scene), make);
    const std::size_t bodies = run.world().bodies.size();
    double largest = 0, off = 0;
    long worst = 0;
    for (long step = 1; step <= std::lround(duration / dt); ++step) {
        std::vector<Vec3> before;
        before.reserve(bodies);
        for (std::size_t i = 0; i < bodies; ++i)
            before.push_back(run.body(i).linear_momentum());
        run.step();
        if (run.parts() > 1)  // pairs tell the last part alone
            continue;
        const std::vector<Vec3> forces = run.on_bodies();
        for (std::size_t i = 0; i < bodies; ++i) {
            const Vec3 change = run.body(i).linear_momentum() - before[i],
                       given = dt * (forces[i] + run.body(i).mass() * run.world().gravity);
            largest = std::max(largest, change.norm());
            if ((change - given).norm() > off) {
                off = (change - given).norm();
                worst = step;
            }
        }
    }
    row.add(worst > 0 ? name + ", step " + std::to_string(worst) : name,
            largest > 0 ? 100 * off / largest : INFINITY);
}

}  // namespace

Rows momentum_of_impacts(const MakeSolver& make, bool full)
{
    Row row{"momentum", "boxes and balls that land, bounce and come to rest", "forces times Δt, in each step",
            "change of momentum", 1e-6};
    for (const Meeting& meeting : meetings())
        for (const double e : {0.0, 0.5})
            for (const double dt : full ? std::vector{1.0 / 60, 0.005, 0.001} : std::vector{1.0 / 60, 0.005})
                add_momentum(row, meeting.name + named(", e", e) + named(", dt", dt),
                             scene_of_meeting(meeting, dt, e, false), make, 0.5);
    return {row};
}

namespace {

constexpr double drop_speed = 2.2, drop_mass = 0.26;  // [m/s], [kg]

struct Drop {
    double impulse = 0, largest = 0, formula = 0;  ///< [N s]
    double rim_speed = 0;                          ///< spin times radius [m/s]
};

/// @param gap_in_steps  under the ball at the start, in steps of its speed
Drop drop_straight(double radius, double mu, double restitution, double gap_in_steps, const MakeSolver& make)
{
    constexpr double dt = 1.0 / 960;
    Scene scene = empty_scene(dt, mu);
    add_ground(scene);
    scene.world.restitution.between = {restitution};
    const double gap = drop_speed * dt * gap_in_steps;
    add_rigid(scene, "ball", moved(sphere(radius, 3), Vec3(0, radius + gap, 0)), drop_mass,
              Vec3(0, -drop_speed, 0));
    Stepped run(std::move(scene), make);
    Drop drop;
    drop.formula = (1 + restitution) * drop_mass * std::sqrt(drop_speed * drop_speed + 2 * fall * gap);
    for (int step = 0; step < 5; ++step) {
        run.step();
        const double given = dt * run.on_bodies()[0].y();
        drop.impulse += given > 0 ? given - dt * run.weight(0) : 0;
        drop.largest = std::max(drop.largest, given);
        const double spin = run.motion(0).angular_velocity().norm();
        drop.rim_speed = std::max(drop.rim_speed, spin * radius);
    }
    return drop;
}

}  // namespace

Rows straight_drops(const MakeSolver& make, bool full)
{
    Row spin{"drop_spin", "ball that drops straight", "spin times radius, over the speed", "0", 1e-4},
        sum{"drop_force", "the same", "forces times Δt, of all steps of the impact", "(1 + e) m v", 1},
        largest{"drop_largest", "the same", "largest force times Δt, in excess of (1 + e) m v", "0", 1};
    const int phases = full ? 20 : 4;
    for (const double radius : {0.05, 0.15})
        for (const double mu : {0.0, 0.5})
            for (const double e : {0.0, 0.5, 1.0})
                for (int phase = 0; phase < phases; ++phase) {
                    const double gap_in_steps = (phase + 0.5) / phases;
                    const Drop drop = drop_straight(radius, mu, e, gap_in_steps, make);
                    const std::string name = named("R", radius) + named(", mu", mu) + named(", e", e) +
                                             ", phase " + std::to_string(phase);
                    spin.add(name, 100 * drop.rim_speed / drop_speed);
                    sum.add(name, 100 * std::abs(drop.impulse / drop.formula - 1));
                    largest.add(name, 100 * std::max(0.0, drop.largest / drop.formula - 1));
                }
    return {spin, sum, largest};
}

}  // namespace enduring::chapter08::force_rows
