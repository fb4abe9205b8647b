#include "chapters/08_contact_by_distance/experiments/forces_impacts.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace enduring::chapter08::force_rows {
namespace {

/// Without gravity, since a rod that leans begins to fall.
void add_rod(Row& speed, Row& spin, double leaning, double e, double dt, const MakeSolver& make)
{
    constexpr double length = 1, width = 0.05, v = 3;
    Scene scene = empty_scene(dt, 0);
    scene.world.gravity.setZero();
    scene.world.restitution.between = {e};
    add_ground(scene);
    const SurfaceMesh rod = turned(box({width, length, width}),
                                   Quaternion(Eigen::AngleAxisd(leaning, Vec3::UnitZ())));
    add_rigid(scene, "rod", moved(rod, Vec3(0, 0.5 * dt * v - lowest(rod).y(), 0)), 1, Vec3(0, -v, 0));
    Stepped run(std::move(scene), make);
    run.step();
    run.step();

    const MassProperties properties = mass_properties(rod, 1000);
    const double inertia = properties.inertia(2, 2) / properties.mass,
                 arm = leaning == 0 ? 0 : lowest(rod).x(),  // a rod that stands lands on four corners
        impulse = (1 + e) * v / (1 + arm * arm / inertia);
    const RigidMotion& after = run.motion(0);
    const std::string name = named("leaning", leaning) + named(", e", e) + named(", dt", dt);
    speed.add(name, 100 * std::abs(after.velocity().y() + v - impulse) / v);
    spin.add(name, 100 * std::abs(after.angular_velocity().z() - impulse * arm / inertia) * length / 2 / v);
}

}  // namespace

Rows rods_on_end(const MakeSolver& make, bool full)
{
    Row speed{"rod_speed", "rod that lands on its end, without friction",
              "speed of its middle, over that before", "J / m - v with J = (1 + e) v / (1 / m + a² / I)", 2},
        spin{"rod_spin", "the same", "its spin times half its length, over the speed before", "J a / I", 1};
    for (const double leaning : full ? std::vector{0.0, 0.1, 0.5, 1.0, 1.4} : std::vector{0.0, 0.5})
        for (const double e : {0.0, 0.5})
            for (const double dt : full ? std::vector{0.004, 0.001} : std::vector{0.001})
                add_rod(speed, spin, leaning, e, dt, make);
    return {speed, spin};
}

namespace {

constexpr double radius = 0.1;  // [m]

/// A ball that flies along x, and two balls in touch that it strikes at once.
void add_three_balls(Row& row, int subdivisions, double e, double dt, const MakeSolver& make)
{
    constexpr double v = 3;
    Scene scene = empty_scene(dt, 0);
    scene.world.gravity.setZero();
    scene.world.restitution.between = {e};
    const SurfaceMesh ball = sphere(radius, subdivisions);
    const double apart = 1e-3 * radius, along = std::sqrt(3.0) * radius, across = radius + apart;
    add_rigid(scene, "striker", moved(ball, Vec3(-0.5 * dt * v, 0, 0)), 1, Vec3(v, 0, 0));
    for (const double side : {-1.0, 1.0})
        add_rigid(scene, side < 0 ? "left" : "right", moved(ball, Vec3(along, 0, side * across)), 1);
    Stepped run(std::move(scene), make);
    for (int step = 0; step < 4; ++step)
        run.step();
    const double cosine = along / std::hypot(along, across),
                 impulse = (1 + e) * v * cosine / (1 + 2 * cosine * cosine),
                 measured = run.motion(0).velocity().x();
    row.add("s " + std::to_string(subdivisions) + named(", e", e) + named(", dt", dt),
            100 * std::abs(measured - (v - 2 * impulse * cosine)) / v);
}

/// A ball with backspin that flies against a wall: friction takes the slip, or as much as Coulomb's law
/// allows.
void add_backspin(Row& row, double rim, double mu, double e, double dt, const MakeSolver& make)
{
    constexpr double v = 3;
    constexpr int turns = 6;
    std::mt19937 random(11);
    double up = 0;
    for (int turn = 0; turn < turns; ++turn) {
        Scene scene = empty_scene(dt, mu);
        scene.world.gravity.setZero();
        scene.world.restitution.between = {e};
        add_static(scene, "wall", moved(box({0.2, 2, 2}, {1, 4, 4}), Vec3(0.1, 0, 0)));
        SurfaceMesh ball = turned(sphere(radius, 5), random_turn(random));
        double front = 0;
        for (const Vec3& vertex : ball.vertices)
            front = std::max(front, vertex.x());
        ball = moved(ball, Vec3(-front - dt * v * (turn + 0.5) / turns, 0, 0));
        add_rigid(scene, "ball", ball, 1, Vec3(v, 0, 0), Vec3(0, 0, rim / radius));
        Stepped run(std::move(scene), make);
        for (int step = 0; step < 4; ++step)
            run.step();
        up += run.motion(1).velocity().y() / turns;
    }
    const double formula = std::min(mu * (1 + e) * v, 2.0 / 7 * rim);
    row.add(named("rim", rim) + named(", mu", mu) + named(", e", e) + named(", dt", dt),
            100 * std::abs(std::abs(up) - formula) / std::hypot(v, rim));
}

}  // namespace

Rows struck_balls(const MakeSolver& make, bool full)
{
    Row three{
        "three_balls", "ball that strikes two at once, without friction", "its speed, over that before",
        "v - 2 J cos a / m with J = (1 + e) m v cos a / (1 + 2 cos² a)",
        5},  // in a step of 1/60 s the ball passes a quarter of its size, and normals are those of its end
        wall{"backspin", "ball with backspin that flies against a wall", "speed along the wall",
             "min(μ (1 + e) v, 2/7 w R)", 1};
    for (const int subdivisions : full ? std::vector{3, 4, 5} : std::vector{4})
        for (const double e : {0.0, 0.5, 1.0})
            for (const double dt : full ? std::vector{1.0 / 60, 0.001} : std::vector{1.0 / 60})
                add_three_balls(three, subdivisions, e, dt, make);
    for (const double rim : full ? std::vector{1.0, 4.0, 10.0} : std::vector{4.0})
        for (const double mu : {0.1, 0.5})
            for (const double e : {0.0, 0.5})
                for (const double dt : full ? std::vector{0.004, 0.001} : std::vector{0.001})
                    add_backspin(wall, rim, mu, e, dt, make);
    return {three, wall};
}

}  // namespace enduring::chapter08::force_rows
