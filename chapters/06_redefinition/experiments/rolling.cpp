#include "chapters/06_redefinition/experiments/rolling.hpp"

#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/experiments/levers.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter06 {
namespace {

constexpr double g = 9.81, pi = std::numbers::pi;

/// It starts a hair above the ground: a pair begins with a crossing.
SurfaceMesh placed_shape(const Roll& roll)
{
    SurfaceMesh mesh = roll.sides == 0 ? sphere(Roll::radius, roll.subdivisions)
                                       : prism(roll.sides, Roll::radius, 0.2);
    const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
    const double lowest = std::min_element(mesh.vertices.begin(), mesh.vertices.end(), lower)->y();
    for (Vec3& x : mesh.vertices)
        x.y() += 1e-6 - lowest;
    return mesh;
}

/// The ground stays level; the weight leans instead.
World world_of(const Roll& roll)
{
    World world;
    const double slope = roll.slope_deg * pi / 180;
    world.gravity = g * Vec3(std::sin(slope), -std::cos(slope), 0);
    if (roll.on_triangles) {
        SurfaceMesh ground = plane_grid(12, 2, {60, 10});
        for (Vec3& x : ground.vertices)
            x += Vec3(0.13, 0, 0.11);
        world.bodies.push_back(std::make_unique<StaticBody>(
            "ground", SurfaceTopology(static_cast<int>(ground.vertices.size()), ground.faces),
            ground.vertices));
    } else {
        world.planes.push_back({"ground"});
    }
    const SurfaceMesh mesh = placed_shape(roll);
    world.bodies.push_back(std::make_unique<RigidBody>(
        "ball", mesh, with_mass(mass_properties(mesh, 1000), roll.mass), Vec3(roll.speed, 0, 0),
        Vec3(0, 0, -(roll.speed + roll.spin) / Roll::radius)));
    return world;
}

/// The part of a step after which a constant force acts as one
/// impulse: CPF's in its middle, DPF's at its end.
double late_by(PenaltyMethod method) { return method == PenaltyMethod::continuous ? 0.5 : 1; }

double inertia(const Roll& roll)
{
    return with_mass(mass_properties(placed_shape(roll), 1000), roll.mass).inertia(2, 2);
}

//! [brake]
/// Torque [N m] of the weight's share along the normal, with a lever that is too
/// long by what the surface goes until the force acts.
double braking_torque(const Roll& roll, double surface_speed)
{
    const double normal_force = roll.mass * g * std::cos(roll.slope_deg * pi / 180);
    return normal_force * late_by(roll.method) * roll.dt * surface_speed;
}
//! [brake]

}  // namespace

SurfaceMesh prism(int sides, double radius, double half_length)
{
    SurfaceMesh mesh;
    for (const double z : {-half_length, half_length})
        for (int i = 0; i < sides; ++i)
            mesh.vertices.emplace_back(radius * std::cos(2 * pi * i / sides),
                                       radius * std::sin(2 * pi * i / sides), z);
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0, -half_length}, {0, 0, half_length}});
    for (int i = 0; i < sides; ++i) {
        const int next = (i + 1) % sides;
        mesh.faces.insert(mesh.faces.end(), {{i, next, sides + next},
                                             {i, sides + next, sides + i},
                                             {next, i, 2 * sides},
                                             {sides + i, sides + next, 2 * sides + 1}});
    }
    return mesh;
}

RollOutcome roll(const Roll& roll, const MakeSolver& make_solver)
{
    World world = world_of(roll);
    const auto& body = dynamic_cast<const RigidBody&>(*world.bodies.back());
    ContactParameters parameters{roll.method, roll.stiffness, NoFriction{}};
    if (roll.mu_s > 0)
        parameters.friction = MassSplitting{
            .mu_s = roll.mu_s, .mu_d = 0.8 * roll.mu_s, .spring = roll.stiffness};
    const Solver solver = make_solver(parameters);
    Contacts contacts;

    const auto speed = [&] { return body.motion().velocity().x(); };
    const auto around = [&] { return -Roll::radius * body.motion().angular_velocity().z(); };
    const int steps = static_cast<int>(std::lround(roll.duration / roll.dt)), from = steps * 2 / 5;
    double first_speed = 0, first_around = 0, way = 0;
    for (int step = 0; step < steps; ++step) {
        if (step == from) {
            first_speed = speed();
            first_around = around();
        }
        advance(world, contacts, solver, roll.dt);
        way += step < from ? 0 : around() * roll.dt;
    }
    const double time = (steps - from) * roll.dt, r = Roll::radius;
    RollOutcome outcome;
    outcome.acceleration = (speed() - first_speed) / time;
    outcome.spin_change = (around() - first_around) / time;
    outcome.surface_speed = way / time;
    const double rolling_inertia = inertia(roll) + roll.mass * r * r;
    outcome.exact = roll.mass * r * r * g * std::sin(roll.slope_deg * pi / 180) / rolling_inertia;
    outcome.brake = braking_torque(roll, outcome.surface_speed) * r /
                    (roll.mu_s > 0 ? rolling_inertia : inertia(roll));
    return outcome;
}

namespace {

std::string name_of(PenaltyMethod method) { return method == PenaltyMethod::continuous ? "CPF" : "DPF"; }

/// A ball down the slope, over steps, methods and grounds.
void roll_down(bool quick, Report& report)
{
    Table table({"ground", "method", "dt_s", "acceleration", "by_formula", "exact"});
    double worst = 0, slowest = 1, farthest = 0;
    for (const bool on_triangles : {false, true})
        for (const PenaltyMethod method : {PenaltyMethod::continuous, PenaltyMethod::discrete})
            for (const double dt : {0.005, 0.0025, 0.001}) {
                if (quick && dt != 0.005)
                    continue;
                const RollOutcome outcome = roll({.method = method,
                                                  .dt = dt,
                                                  .on_triangles = on_triangles,
                                                  .duration = quick ? 0.6 : 1.5});
                table.add({on_triangles ? "triangles" : "plane", name_of(method), dt, outcome.acceleration,
                           outcome.exact - outcome.brake, outcome.exact});
                const double lost = 1 - outcome.acceleration / outcome.exact;
                worst = std::max(worst, lost);
                slowest = std::min(slowest, lost);
                farthest = std::max(
                    farthest, std::abs(outcome.acceleration - outcome.exact + outcome.brake) / outcome.exact);
            }
    report.table("rolling", table);
    report.page_table("rolling", table, 4);
    report.fact("rolling", "max_lost_percent", 100 * worst, 2);
    report.fact("rolling", "least_lost_percent", 100 * slowest, 2);
    report.fact("rolling", "farthest_from_formula_percent", 100 * farthest, 2);
}

/// No slope, no friction: a ball that turns on its spot.
void spin_on_the_spot(bool quick, Report& report)
{
    Table table({"method", "dt_s", "spin_lost", "by_formula"});
    for (const PenaltyMethod method : {PenaltyMethod::continuous, PenaltyMethod::discrete})
        for (const double dt : {0.005, 0.0025, 0.001}) {
            if (quick && dt != 0.005)
                continue;
            const RollOutcome outcome = roll({.method = method,
                                              .dt = dt,
                                              .slope_deg = 0,
                                              .mu_s = 0,
                                              .spin = 1,
                                              .duration = quick ? 0.4 : 1});
            table.add({name_of(method), dt, -outcome.spin_change, outcome.brake});
        }
    report.table("rolling_spin", table);
    report.page_table("rolling_spin", table, 3);
}

/// What presses the ball in deeper: more mass on the same springs. With the
/// smallest step, where the lever matters least.
void roll_deep(bool quick, Report& report)
{
    Table table({"mass_kg", "stiffness_n_per_m", "weight_over_k_mm", "acceleration", "by_formula", "exact"});
    for (const auto& [mass, stiffness] :
         {std::pair{20.0, 20000.0}, {20.0, 2000.0}, {100.0, 2000.0}, {500.0, 2000.0}}) {
        if (quick && stiffness == 2000 && mass < 500)
            continue;
        const RollOutcome outcome = roll({.dt = quick ? 0.0025 : 0.001,
                                          .mass = mass,
                                          .stiffness = stiffness,
                                          .duration = quick ? 0.6 : 1.5});
        table.add({mass, stiffness, 1000 * mass * g / stiffness, outcome.acceleration,
                   outcome.exact - outcome.brake, outcome.exact});
        if (mass == 500)
            report.fact("rolling", "deepest_lost_percent", 100 * (1 - outcome.acceleration / outcome.exact),
                        2);
    }
    report.table("rolling_depth", table);
    report.page_table("rolling_depth", table, 4);
}

/// Flat sides: a prism falls from edge to edge.
void roll_prisms(bool quick, Report& report)
{
    Table table({"sides", "dt_s", "acceleration", "by_formula", "exact"});
    for (const int sides : {8, 16, 32})
        for (const double dt : {0.005, 0.001}) {
            if (quick && dt != 0.005)
                continue;
            const RollOutcome outcome = roll({.dt = dt, .sides = sides, .speed = 1, .duration = 1.5});
            table.add({static_cast<long>(sides), dt, outcome.acceleration, outcome.exact - outcome.brake,
                       outcome.exact});
        }
    report.table("rolling_prisms", table);
    report.page_table("rolling_prisms", table, 3);
}

/// Why the lever stays: what it costs two free blocks, and what a later one would.
void slide_free(Report& report)
{
    Table table({"dt_s", "at_start", "in_middle", "at_end"});
    for (const double dt : {0.004, 0.002, 0.001}) {
        const LeverCost cost = cost_of_levers({dt, 1});
        table.add({dt, cost.measured.norm(), cost.in_middle.norm(), cost.at_end.norm()});
    }
    report.table("rolling_levers", table);
    report.page_table("rolling_levers", table, 2);
}

}  // namespace

/// What rolls is braked.
void rolling(const RunOptions& options, Report& report)
{
    roll_down(options.quick, report);
    spin_on_the_spot(options.quick, report);
    roll_deep(options.quick, report);
    roll_prisms(options.quick, report);
    slide_free(report);
}

}  // namespace enduring::chapter06
