#include "chapters/09_deep_contacts/experiments/crossed_beams.hpp"

#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter09 {
namespace {

constexpr double mass = 10, upper_rests_at = 1.5 * beam_size;

std::unique_ptr<Body> beam(const std::string& name, double turn_deg, const Vec3& centre)
{
    SurfaceMesh mesh = box({3, beam_size, beam_size});
    const Eigen::AngleAxisd turn(turn_deg * std::numbers::pi / 180, Vec3::UnitY());
    for (Vec3& x : mesh.vertices)
        x = turn * x + centre;
    return std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass));
}

/// How the upper beam comes out; of several runs the worst of each.
struct Outcome {
    double below_mm = -1e9;  ///< the place of rest, at the end
    double above_mm = -1e9;  ///< the place of rest, in any step
    double fastest = 0;      ///< [m/s]
    double excess_j = -1e9;  ///< energy of both, over that at first and what it takes to lift the beam
    long left_inside = 0;    ///< 1 if it ends more than 1 mm below its place of rest
    long solves = 0, unconverged = 0;

    void worsen(const Outcome& other)
    {
        below_mm = std::max(below_mm, other.below_mm);
        above_mm = std::max(above_mm, other.above_mm);
        fastest = std::max(fastest, other.fastest);
        excess_j = std::max(excess_j, other.excess_j);
        left_inside += other.left_inside;
        solves += other.solves;
        unconverged += other.unconverged;
    }
};

Outcome separate(Scene& scene, double depth, double duration, Probe* film = nullptr)
{
    Outcome outcome;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        ++outcome.solves;
        outcome.unconverged += !record.converged;
    };
    const Solver solver = chapter09_solver(scene.contact, settings);
    World& world = scene.world;
    const Body& upper = *world.bodies[1];
    const double lifted = mass * world.gravity.norm() * depth, at_most = total_energy(world).total() + lifted;
    Contacts contacts;
    for (int step = 0; step <= std::lround(duration / scene.dt); ++step) {
        if (film)
            film->observe(world, contacts, scene.dt);
        advance(world, contacts, solver, scene.dt);
        outcome.above_mm = std::max(outcome.above_mm, 1000 * (upper.centre().y() - upper_rests_at));
        outcome.fastest = std::max(outcome.fastest, upper.mean_velocity().norm());
        outcome.excess_j = std::max(outcome.excess_j, total_energy(world).total() - at_most);
    }
    outcome.below_mm = 1000 * (upper_rests_at - upper.centre().y());
    outcome.left_inside = outcome.below_mm > 1;
    return outcome;
}

}  // namespace

Scene crossed_beams(double depth, double turn_deg, double aside, double dt)
{
    Scene scene;
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.4};
    scene.world.planes.push_back({"ground"});
    scene.world.bodies.push_back(beam("lower beam", 0, {0, 0.5 * beam_size, 0}));
    scene.world.bodies.push_back(beam("upper beam", turn_deg, {aside, upper_rests_at - depth, 0.3 * aside}));
    scene.camera = {{2.6, 1.9, 4.2}, {0, 0.35, 0}, 34};
    return scene;
}

/// Beams that begin in each other and have only edges there.
void crossed_beams(const RunOptions& options, Report& report)
{
    GrowingTable table(
        report, "crossed_beams",
        {"depth_mm", "turn_deg", "aside_m", "dt_s", "above_mm", "below_mm", "fastest_m_per_s", "excess_j"});
    Outcome worst;
    for (const double dt : {0.005, 0.01, 1.0 / 60})
        for (const double depth : {0.001, 0.02, 0.05, 0.15, 0.24})
            for (const double turn_deg : {90.0, 70.0, 33.0})
                for (const double aside : {0.0, 0.3}) {
                    if (options.quick && (dt != 0.01 || aside > 0))
                        continue;
                    Scene scene = crossed_beams(depth, turn_deg, aside, dt);
                    const Outcome outcome = separate(scene, depth, 3);
                    table.add({1000 * depth, turn_deg, aside, dt, outcome.above_mm, outcome.below_mm,
                               outcome.fastest, outcome.excess_j});
                    worst.worsen(outcome);
                }
    Scene shown = crossed_beams(0.15, 70, 0, 0.01);
    StripProbe film(
        shown, {0, 0.25, 1}, [](auto&&...) {}, 320, 240);
    separate(shown, 0.15, 1.1, &film);
    write_png(film.all(3), report.file("crossed_beams.png"));
    report.table("crossed_beams", table);
    report.fact("crossed_beams", "runs", static_cast<double>(table.rows().size()));
    report.fact("crossed_beams", "left_inside", static_cast<double>(worst.left_inside));
    report.fact("crossed_beams", "above_mm", worst.above_mm, 2);
    report.fact("crossed_beams", "below_mm", worst.below_mm, 2);
    report.fact("crossed_beams", "fastest", worst.fastest);
    report.fact("crossed_beams", "excess_j", worst.excess_j, 2);
    report.fact("crossed_beams", "solves", static_cast<double>(worst.solves));
    report.fact("crossed_beams", "unconverged", static_cast<double>(worst.unconverged));
}

}  // namespace enduring::chapter09
