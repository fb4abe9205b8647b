#include "chapters/11_exact_contact/relaxation.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace enduring::chapter11 {

//! [rod_scene]
Scene rod_scene(double angle, double mu, double dt)
{
    Scene scene = chapter07::scene_of({}, dt, 0, mu, mu);
    SurfaceMesh mesh = box(Vec3(2, 0.002, 0.5));
    const Eigen::AngleAxisd lean(angle, Vec3::UnitZ());
    double lowest = 0;
    for (Vec3& vertex : mesh.vertices) {
        vertex = lean * vertex;
        lowest = std::min(lowest, vertex.y());
    }
    for (Vec3& vertex : mesh.vertices)
        vertex.y() -= lowest;
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("rod", mesh, with_mass(mass_properties(mesh, 1000), 1), Vec3(-1, 0, 0)));
    return scene;
}
//! [rod_scene]
namespace {

/// How a rod's end goes on that slides at 1 m/s.
std::string outcome_of(const FrictionProblem& rod, const ExactSolution& solution)
{
    if (!solution.solved())
        return "not solved";
    const Eigen::VectorXd velocity = contact_velocities(rod, solution.impulses);
    return std::abs(velocity[1]) < 1e-6 ? "stops at once" : velocity[0] > 1e-6 ? "leaves" : "slides on";
}

SlidingBlock after_steps(SlidingBlock block, double mu, double dt, FrictionRule rule)
{
    constexpr int steps = 5;
    for (int step = 0; step < steps; ++step)
        block = after_step(block, mu, dt, rule);
    return block;
}

void slide(Report& report)
{
    Table table({"mu", "speed_m_per_s", "dt_s", "thrown_up_m_per_s", "relaxed_lift_mm", "mu_v_dt_mm"});
    double coulomb = 0;
    for (const double mu : {0.2, 0.5, 1.0})
        for (const double speed : {1.0, 3.0})
            for (const double dt : {0.001, 0.01}) {
                const SlidingBlock on_ground{0, speed, 0},
                    thrown = after_step(on_ground, mu, dt, FrictionRule::relaxed),
                    floats = after_steps({mu * speed * dt, speed, 0}, mu, dt, FrictionRule::relaxed),
                    exact = after_steps(on_ground, mu, dt, FrictionRule::coulomb);
                const double formula = mu * floats.speed * dt;
                table.add({mu, speed, dt, thrown.rising, 1e3 * floats.gap, 1e3 * formula});
                coulomb = std::max(coulomb, std::abs(exact.gap));
            }
    report.table("relaxation", table);
    report.page_table("relaxation", table, 3);
    report.fact("relaxation", "coulomb_lift_m", coulomb, 2);
}

void rods(Report& report)
{
    Table table({"angle_deg", "critical_mu", "mu", "dt_ms", "impulse_over_mv", "natural_map", "outcome"});
    long solved = 0;
    for (const double degrees : {30.0, 63.435, 80.0})
        for (const double part : {0.5, 0.9, 1.1, 2.0})
            for (const double dt_ms : {1.0, 10.0}) {
                const double angle = degrees * std::numbers::pi / 180, critical = painleve_friction(angle);
                const FrictionProblem rod = sliding_rod(angle, part * critical, 1, 9.81e-3 * dt_ms);
                const ExactSolution solution = solve_exactly(rod);
                table.add({degrees, critical, part * critical, dt_ms, solution.impulses[0], solution.error,
                           outcome_of(rod, solution)});
                solved += solution.solved();
            }
    report.table("painleve", table);
    report.page_table("painleve", table, 3);
    report.fact("relaxation", "rods", static_cast<double>(table.rows().size()));
    report.fact("relaxation", "rods_solved", static_cast<double>(solved));
}

/// Velocity of the rod's lower end along the ground [m/s].
double slip_of(const Scene& scene)
{
    const RigidMotion& motion = dynamic_cast<const RigidBody&>(*scene.world.bodies[0]).motion();
    const auto vertices = scene.world.bodies[0]->positions_t0();
    const auto low = std::min_element(vertices.begin(), vertices.end(),
                                      [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
    return (motion.velocity() + motion.angular_velocity().cross(*low - scene.world.bodies[0]->centre())).x();
}

/// The rod over time under this chapter's solver: how fast its end slides after the first step and after 50
/// ms.
void rods_over_time(Report& report)
{
    Table table({"mu_over_critical", "dt_ms", "slip_after_a_step_m_per_s", "slip_after_50_ms_m_per_s",
                 "impulse_of_first_step_over_mv", "unsolved_steps"});
    const double angle = std::atan(2.0);
    for (const double part : {0.5, 0.9, 1.1, 2.0})
        for (const double dt_ms : {1.0, 5.0}) {
            Scene scene = rod_scene(angle, part * painleve_friction(angle), 1e-3 * dt_ms);
            long unsolved = 0;
            ImplicitSettings settings;
            settings.record = [&](const SolveRecord& record) { unsolved += !record.converged; };
            const Solver solver = chapter11_solver(scene.contact, settings,
                                                   {.record = [](const PassRecord&) {}});
            Contacts contacts;
            advance(scene.world, contacts, solver, scene.dt);
            const double first = slip_of(scene);
            double impulse = 0;
            for (const Contact& contact : contacts)
                impulse += contact.impulse.norm();
            while (scene.world.time < 0.05 - 1e-9)
                advance(scene.world, contacts, solver, scene.dt);
            if (part > 1 && dt_ms == 1)
                report.fact("relaxation", "scene_jam_impulse", impulse, 3);
            table.add({part, dt_ms, first, slip_of(scene), impulse, unsolved});
        }
    report.table("painleve_scene", table);
    report.page_table("painleve_scene", table, 3);
}

}  // namespace

/// What the convex relaxation of Coulomb's rule lifts, and what Coulomb's own rule does with Painleve's rod.
void relaxation(const RunOptions&, Report& report)
{
    slide(report);
    rods(report);
    rods_over_time(report);
}

}  // namespace enduring::chapter11
