#include "common/experiments/run/joint_probe.hpp"

namespace enduring {

JointProbe::JointProbe()
    : TableProbe({"time_s", "joint", "fx_n", "fy_n", "fz_n", "tx_n_m", "ty_n_m", "tz_n_m", "turn_rad",
                  "way_m", "broken"})
{}

void JointProbe::observe(const World& world, const Contacts&, double)
{
    for (const Joint& joint : world.joints)
        table_.add({world.time, joint.name, joint.force.x(), joint.force.y(), joint.force.z(),
                    joint.torque.x(), joint.torque.y(), joint.torque.z(), turn_of(world, joint),
                    way_of(world, joint), static_cast<long>(joint.broken)});
}

}  // namespace enduring
