#include "chapters/12_joints/experiments/crane_scene.hpp"

#include "chapters/12_joints/experiments/machine.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/contact_forces.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter12 {
namespace {

constexpr int slab_number = 0, load_number = 5;
constexpr std::size_t weld_number = 0, rope_number = 3;

double rope_angle(const World& world)
{
    const JointPose pose = committed_pose(world, world.joints[rope_number]);
    const Vec3 along = pose.point_b - pose.point_a;
    return std::atan2(std::hypot(along.x(), along.z()), along.y());
}

}  // namespace

CraneForces crane_forces(const World& world, const Contacts& contacts, double dt)
{
    CraneForces of;
    const double part = last_part(world, dt);
    for (const Contact& contact : contacts) {
        const double up = pair_force(contact, part).total().y();
        if (contact.on_plane())
            of.ground += contact.body_a == slab_number ? up : 0;
        else if (std::minmax(contact.body_a, contact.body_b) == std::minmax(slab_number, load_number))
            of.slab += contact.body_a == load_number ? up : -up;
    }
    of.rope = world.joints[rope_number].force.norm();
    of.moment = std::abs(world.joints[weld_number].torque.z());
    double height = 0, count = 0;
    for (const Vec3& vertex : world.bodies[slab_number]->positions_t0())
        if (vertex.y() > crane_statics::height / 2 + 0.02) {  // the nodes of its top
            height += vertex.y();
            ++count;
        }
    of.top = height / count;
    return of;
}

CraneRun run_crane(double lowered, double duration, const std::vector<Probe*>& probes)
{
    Scene scene = load_scene(scene_file("crane"), R"({"/joints/hoist/motor/to": )" + shortest(lowered) + "}");
    const Solver solver = chapter12_solver(scene.contact);
    Contacts contacts;
    CraneRun of;
    for (long step = std::lround(duration / scene.dt); step > 0; --step) {
        advance(scene.world, contacts, solver, scene.dt);
        for (Probe* probe : probes)
            probe->observe(scene.world, contacts, scene.dt);
        for (const Joint& joint : scene.world.joints)
            of.error = std::max(of.error, error_of(scene.world, joint));
        const double time = scene.world.time;
        if (time < 1.6)
            of.most = std::max(of.most, rope_angle(scene.world));
        else if (time > 1.75 && time < 2.6) {  // the trolley stands, and nothing is touched
            of.swing = std::max(of.swing, rope_angle(scene.world));
            of.hanging = crane_forces(scene.world, contacts, scene.dt);
        }
    }
    of.end = crane_forces(scene.world, contacts, scene.dt);
    of.bad = scene.world.ended_badly;
    return of;
}

}  // namespace enduring::chapter12
