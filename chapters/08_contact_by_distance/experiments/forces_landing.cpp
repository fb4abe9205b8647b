#include "chapters/08_contact_by_distance/experiments/forces_landing.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace enduring::chapter08::force_rows {
namespace {

constexpr double ball_radius = 0.1, gravity = 9.81;  // [m], [m/s^2]
constexpr int sides = 192;                           // of a cylinder or a torus

SurfaceMesh cylinder(double first_angle)
{
    std::vector<std::array<double, 2>> outline;
    outline.reserve(sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = first_angle + 2 * std::numbers::pi * i / sides;
        outline.push_back({ball_radius * std::cos(angle), ball_radius * std::sin(angle)});
    }
    return chapter07::prism(outline, 0.2);
}

/// About the axis z.
SurfaceMesh torus(double first_angle)
{
    constexpr int across = 12;
    constexpr double tube = 0.3 * ball_radius;
    SurfaceMesh mesh;
    for (int i = 0; i < sides; ++i)
        for (int j = 0; j < across; ++j) {
            const double around = first_angle + 2 * std::numbers::pi * i / sides,
                         inside = 2 * std::numbers::pi * j / across,
                         radius = ball_radius - tube * (1 - std::cos(inside));
            mesh.vertices.push_back(
                {radius * std::cos(around), radius * std::sin(around), tube * std::sin(inside)});
            const auto vertex = [](int a, int b) { return (a % sides) * across + b % across; };
            mesh.faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            mesh.faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return mesh;
}

SurfaceMesh round_mesh(const Landing& landing, const Quaternion& turn)
{
    switch (landing.shape) {
        case Round::cylinder: return cylinder(Eigen::AngleAxisd(turn).angle());
        case Round::torus: return torus(Eigen::AngleAxisd(turn).angle());
        default: return turned(sphere(ball_radius, landing.subdivisions), turn);
    }
}

/// Cells of half a metre; the body lands at x = 0.
void add_landing_ground(Scene& scene, Ground ground)
{
    if (ground == Ground::plane || ground == Ground::slab)
        add_ground(scene);
    if (ground == Ground::slab)
        add_rigid(scene, "slab", moved(box({8, 0.2, 2}), Vec3(2, 0.1, 0)), 1000);
    else if (ground == Ground::box)
        add_static(scene, "floor", moved(box({8, 0.2, 2}), Vec3(2, -0.1, 0)));
    else if (ground != Ground::plane) {
        const Vec3 shift = ground == Ground::over_an_edge ? Vec3(0.25, 0, 0)
                           : ground == Ground::beside     ? Vec3(0.07, 0, 0.13)
                                                          : Vec3(0, 0, 0);
        add_static(scene, "floor", moved(box({8, 0.2, 2}, {16, 1, 4}), Vec3(2, -0.1, 0) + shift));
    }
}

/// One ball that comes down within its first step; the speed with which it rolls, or what it has after two
/// seconds.
double rolls_with(const Landing& landing, const Quaternion& turn, double phase, const MakeSolver& make)
{
    Scene scene = empty_scene(landing.dt, landing.mu);
    scene.world.restitution.between = {landing.restitution};
    add_landing_ground(scene, landing.ground);
    SurfaceMesh mesh = round_mesh(landing, turn);
    const double down = std::sqrt(2 * gravity * landing.drop),
                 floor = landing.ground == Ground::slab ? 0.2 : 0;
    mesh = moved(mesh, Vec3(-phase * landing.dt * landing.slides,
                            floor - lowest(mesh).y() + phase * landing.dt * down, 0));
    add_rigid(scene, "ball", mesh, 1, Vec3(landing.slides, -down, 0), Vec3(0, 0, landing.rim / ball_radius));
    const std::size_t ball = scene.world.bodies.size() - 1;
    Stepped run(std::move(scene), make);
    for (int rolled = 0; rolled < 3 && run.world().time < 2;) {
        run.step();
        const RigidMotion& motion = run.motion(ball);
        const double slip = motion.velocity().x() +
                            ball_radius * std::sin(motion.angular_velocity().z() * landing.dt) / landing.dt;
        if (rolled > 0 || std::abs(slip) < 0.01 * (std::abs(landing.slides) + std::abs(landing.rim)))
            ++rolled;
    }
    return run.body(ball).mean_velocity().x();
}

}  // namespace

std::string name_of(Ground ground)
{
    switch (ground) {
        case Ground::plane: return "plane";
        case Ground::box: return "box";
        case Ground::over_a_vertex: return "vertex of a floor";
        case Ground::over_an_edge: return "edge of a floor";
        case Ground::beside: return "cell of a floor";
        default: return "free slab";
    }
}

std::string name_of(const Landing& landing)
{
    const std::string shape = landing.shape == Round::cylinder ? "cylinder"
                              : landing.shape == Round::torus  ? "torus"
                                                               : named("ball s", landing.subdivisions),
                      spin = landing.rim == 0
                                 ? ""
                                 : named(", slides", landing.slides) + named(", rim", landing.rim);
    return shape + " on a " + name_of(landing.ground) + named(", drop", landing.drop) +
           named(" m, mu", landing.mu) + named(", e", landing.restitution) +
           named(", 1/Δt", std::round(1 / landing.dt)) + spin;
}

//! [rolling_speed]
double rolling_speed(double v0, double inertia_ratio, double radius, double dt)
{
    double v = v0 / (1 + inertia_ratio);
    for (int i = 0; i < 50;
         ++i) {  // the sine is near its angle, so each round leaves a small part of the error
        const double spin = std::asin(std::min(1.0, v * dt / radius)) / dt;
        v += (v0 - v - inertia_ratio * radius * spin) / (1 + inertia_ratio);
    }
    return v;
}
//! [rolling_speed]

Landed land(const Landing& landing, const MakeSolver& make)
{
    const MassProperties properties = mass_properties(round_mesh(landing, Quaternion::Identity()), 1);
    const double ratio = properties.inertia(2, 2) / (properties.mass * ball_radius * ball_radius);
    Landed landed;
    landed.formula = rolling_speed(landing.slides - ratio * landing.rim, ratio, ball_radius, landing.dt);
    std::mt19937 random(7);
    for (int turn = 0; turn < landing.turns; ++turn) {
        const Quaternion by = random_turn(random);
        const double speed = rolls_with(landing, by, (turn + 0.5) / landing.turns, make);
        landed.mean += speed / landing.turns;
        landed.worst = std::max(landed.worst, std::abs(speed / landed.formula - 1));
    }
    return landed;
}

Rows landings(const MakeSolver& make, bool full)
{
    const std::string formula = "v / (1 + I / (m R²)), and the step's sine";
    Row plane{"landing", "ball, cylinder or torus that lands while it slides, on a plane",
              "speed with which it rolls", formula, 1},
        bodies{"landing_on_bodies", "the same on a box, a mesh of cells, a heavy free slab",
               "speed with which it rolls", formula, 1},
        bounce{"landing_bounce", "the same with a rebound, e = 0.5", "speed with which it rolls", formula, 1},
        spin{"landing_spin", "ball that spins and drops straight, or slides with backspin",
             "speed with which it rolls, over that with which surfaces meet",
             "(v - w R I / (m R²)) / (1 + I / (m R²)), and the step's sine", 2};
    const auto add = [&](Row& row, const Landing& landing) {
        row.add(name_of(landing), 100 * std::abs(land(landing, make).error()));
    };
    const auto add_spin = [&](const Landing& landing) {
        const Landed landed = land(landing, make);
        spin.add(name_of(landing), 100 * std::abs(landed.mean - landed.formula) /
                                       (std::abs(landing.slides) + std::abs(landing.rim)));
    };
    const std::vector<double> steps = full ? std::vector{1.0 / 30, 1.0 / 60, 1.0 / 120, 1.0 / 240, 1.0 / 960}
                                           : std::vector{1.0 / 60, 1.0 / 240};
    for (const double dt : steps)
        for (const double drop : full ? std::vector{0.01, 0.1, 0.3, 1.25} : std::vector{0.3})
            add(plane, {.drop = drop, .dt = dt});
    for (const double mu : full ? std::vector{0.1, 0.2, 1.0} : std::vector{0.1})
        for (const double dt : full ? std::vector{1.0 / 60, 1.0 / 240} : std::vector{1.0 / 60})
            add(plane, {.mu = mu, .dt = dt});
    for (const int subdivisions : full ? std::vector{3, 4, 6} : std::vector<int>{})
        add(plane, {.subdivisions = subdivisions});
    for (const Round shape : {Round::cylinder, Round::torus})
        for (const double dt : full ? steps : std::vector{1.0 / 60})
            add(plane, {.shape = shape, .dt = dt});
    for (const Ground ground :
         {Ground::box, Ground::over_a_vertex, Ground::over_an_edge, Ground::beside, Ground::slab})
        for (const double dt : full ? std::vector{1.0 / 60, 1.0 / 240} : std::vector{1.0 / 60})
            for (const double drop : full ? std::vector{0.1, 1.25} : std::vector{1.25})
                add(bodies, {.ground = ground, .subdivisions = full ? 5 : 4, .drop = drop, .dt = dt});
    for (const double dt : full ? steps : std::vector{1.0 / 60})
        for (const double drop : full ? std::vector{0.1, 0.3, 1.25} : std::vector{0.3})
            add(bounce, {.drop = drop, .restitution = 0.5, .dt = dt});
    for (const double slides : {0.0, 2.0})
        for (const double rim : full ? std::vector{-4.0, -2.0, 2.0, 12.0} : std::vector{-4.0, 12.0})
            for (const double e : {0.0, 0.5})
                for (const double dt : full ? std::vector{1.0 / 60, 1.0 / 240} : std::vector{1.0 / 240})
                    add_spin({.subdivisions = full ? 5 : 4,
                              .slides = slides,
                              .rim = rim,
                              .restitution = e,
                              .dt = dt});
    return {plane, bodies, bounce, spin};
}

}  // namespace enduring::chapter08::force_rows
