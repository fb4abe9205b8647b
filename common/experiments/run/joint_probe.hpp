#pragma once

#include "common/experiments/run/probes.hpp"

namespace enduring {

/// What each joint does on its body A over the step, and where it stands: time_s, joint, force and torque
/// (about the joint's point) in world axes, turn_rad, way_m, and whether it is broken.
class JointProbe final : public TableProbe {
public:
    JointProbe();
    void observe(const World& world, const Contacts& contacts, double dt) override;
};

}  // namespace enduring
