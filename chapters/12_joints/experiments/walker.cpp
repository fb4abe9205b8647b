#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/walking.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {
namespace walker_parts {

/// Kinetic and potential energy [J]. Velocities are half a step behind positions: this is what a step of a
/// fall keeps.
double kept_energy(const World& world, double dt)
{
    double sum = total_energy(world).total();
    for (const auto& body : world.bodies)
        sum += dt / 2 * world.gravity.dot(body->linear_momentum());
    return sum;
}

double force_of_ground(const World& world, const Contacts& contacts, double dt)
{
    double sum = 0;
    for (const Contact& contact : contacts)
        sum += pair_force(contact, last_part(world, dt)).total().y();
    return sum;
}

/// Hips, chest, and the two legs in colours of their own.
void paint(Scene& scene)
{
    for (std::size_t i = 0; i < scene.world.bodies.size(); ++i)
        scene.looks[scene.world.bodies[i]->name()].color = i < 2   ? palette::slate
                                                           : i < 7 ? palette::terracotta
                                                                   : palette::blue;
}

/// From the side, and a little from above and in front; it goes along.
SceneCamera camera_beside(double x) { return {{x + 1.0, 1.0, 2.2}, {x + 0.05, 0.5, 0}, 32}; }

}  // namespace walker_parts
}  // namespace

/// A machine of 12 bodies walks by a plan of its turns: it stays up, and its joints hold.
void walker(const RunOptions& options, Report& report)
{
    using namespace walker_parts;
    const double duration = options.quick ? 6 : 30, dt = 0.01;
    const Gait gait;
    Walker walker(gait, dt);
    Scene& scene = walker.machine.scene;
    const World& world = scene.world;
    paint(scene);
    scene.camera = camera_beside(0);
    ClipProbe film(scene, report.file("walker.webp"), options.quick ? 4 : 20, 480, 400, {.until = 10});
    Table course({"time_s", "way_m", "plan_m", "side_m", "driven_j", "lost_j"});
    const Vec3 start = walker.hips().centre();
    const double first = kept_energy(world, dt);
    double own = first, gained = 0, lowest = start.y(), pushed = 0;
    walker.walk(duration, [&] {
        const Vec3 way = walker.hips().centre() - start, plan = gait.hips(world.time);
        const double now = kept_energy(world, dt) - world.driven;
        gained = std::max(gained, now - own);
        own = now;
        lowest = std::min(lowest, walker.hips().centre().y());
        if (world.step == 155)  // it stands on both feet, with bent knees
            pushed = force_of_ground(world, walker.contacts(), dt);
        if (world.step % 10 == 0)
            course.add({world.time, way.x(), plan.x(), way.z(), world.driven, first - own});
        scene.camera = camera_beside(plan.x());
        film.observe(world, walker.contacts(), dt);
    });
    film.finish();
    const double way = walker.hips().centre().x() - start.x(), weight = walker.mass() * world.gravity.norm();
    report.table("walker", course);
    report.fact("walker", "seconds", duration);
    report.fact("walker", "way_m", way, 3);
    report.fact("walker", "ahead_percent", 100 * (way / gait.hips(world.time).x() - 1), 2);
    report.fact("walker", "aside_m", std::abs(walker.hips().centre().z() - gait.hips(world.time).z()), 2);
    report.fact("walker", "lowest_m", lowest, 3);
    report.fact("walker", "joint_error_m", walker.joint_error(), 2);
    report.fact("walker", "off_plan_deg", 180 / std::numbers::pi * walker.off_plan(), 2);
    report.fact("walker", "ground_force_off", std::abs(pushed / weight - 1), 2);
    report.fact("walker", "braked_j", -world.driven, 3);
    report.fact("walker", "lost_j", first - own, 3);
    report.fact("walker", "gained_in_a_step_j", gained, 2);
    report.fact("walker", "halved", static_cast<double>(world.thrown_away));
    report.fact("walker", "ended_badly", static_cast<double>(world.ended_badly));
}

}  // namespace enduring::chapter12
