#include "chapters/04_friction/experiments/turning.hpp"

#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter04 {
namespace {

Scene level_scene(double dt)
{
    const nlohmann::json change{
        {"dt", dt},
        {"contact",
         {{"stiffness", 2000}, {"friction", {{"model", "mass_splitting"}, {"mu_s", 0.15}, {"mu_d", 0.1}}}}},
        {"planes", {{{"name", "floor"}}}},
        {"/bodies/block",
         {{"mass", 2},
          {"shape", {{"box", {{"size", {0.2, 0.02, 0.2}}}}}},
          {"position", {0, 0.01 - 2 * 9.81 / 8000, 0}},
          {"rotation", nullptr},
          {"velocity", {1, 0, 0}}}}};
    return load_scene(scene_file("block_on_slope"), change.dump());
}

/// Between friction and the opposite of the slip [degrees], the largest over the pairs. Slip is measured over
/// the step, by where the vertex was and is.
double largest_angle(const World& world, const Contacts& contacts, const std::vector<Vec3>& before)
{
    double largest = 0;
    for (const Contact& contact : contacts) {
        const auto v = static_cast<std::size_t>(contact.vertices[0]);
        const Vec3 way = world.bodies.front()->positions_t0()[v] - before[v];
        const Vec3 slip = way - way.y() * Vec3::UnitY();
        if (contact.spring.slip > 0 && slip.norm() > 0 && contact.friction.norm() > 0)
            largest = std::max(largest,
                               std::atan2(contact.friction.cross(slip).norm(), -contact.friction.dot(slip)));
    }
    return largest * 180 / std::numbers::pi;
}

}  // namespace

TurnRecord drive_in_circles(const Turn& turn)
{
    Scene scene = level_scene(turn.dt);
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    TurnRecord record;
    while (scene.world.time < turn.seconds) {
        const double angle = 2 * std::numbers::pi * scene.world.time / turn.period;
        scene.world.gravity = {turn.sideways * std::cos(angle), -9.81, turn.sideways * std::sin(angle)};
        const auto positions = scene.world.bodies.front()->positions_t0();
        const std::vector<Vec3> before(positions.begin(), positions.end());
        advance(scene.world, contacts, solver, turn.dt);
        const double error = largest_angle(scene.world, contacts, before);
        record.worst_angle_deg = std::max(record.worst_angle_deg, error);
        const Vec3 v = scene.world.bodies.front()->mean_velocity();
        const Vec3 x = scene.world.bodies.front()->positions_t0()[0];
        Vec3 force = Vec3::Zero();
        for (const Contact& contact : contacts)
            force += contact.friction / turn.dt;
        record.table.add({scene.world.time, x.x(), x.z(), v.x(), v.z(), force.x(), force.z(), error});
    }
    return record;
}

/// Slip in a turning direction: friction has to turn with it.
void turning(const RunOptions&, Report& report)
{
    Table summary({"dt_s", "worst_angle_deg"});
    for (const double dt : {0.01, 0.005, 0.002}) {
        Turn turn;
        turn.dt = dt;
        const TurnRecord record = drive_in_circles(turn);
        summary.add({dt, record.worst_angle_deg});
        if (dt == 0.01) {
            report.table("turning", record.table);
            report.fact("turning", "worst_angle_deg", record.worst_angle_deg, 2);
        }
    }
    report.table("turning_summary", summary);
    report.page_table("turning_summary", summary, 2);
    report.plot("chapters/04_friction/plots/turning.gp");
}

}  // namespace enduring::chapter04
