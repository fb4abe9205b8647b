#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter12 {

/// What statics tells of common/scenes/crane.json, from the numbers of its file.
namespace crane_statics {

constexpr double gravity = 9.81, load = 20, hook = 1, trolley = 8, jib = 15, slab = 2;  // [m/s^2, kg]
/// Of the slab: without Poisson's ratio it is pressed as a row of springs [N/m].
constexpr double young = 3000, side = 0.6, height = 0.2, stiffness = young * side * side / height;
/// How far the slab sinks under its own weight, and under the load on top [m].
constexpr double own_sag = slab * gravity / (2 * stiffness), sag = load * gravity / stiffness;
/// How far the load has to come down until it touches the slab [m].
constexpr double way_down = 0.9 - 0.15 - (height - own_sag);
/// Of the weld, about the mast: the jib's middle is at 0.6 m, the load at the end of its way at 1.2 m [N m].
constexpr double moment = gravity * (jib * 0.6 + (trolley + hook + load) * 1.2);

}  // namespace crane_statics

/// What the crane's parts carry at one moment.
struct CraneForces {
    double rope = 0;    ///< [N]
    double slab = 0;    ///< that the slab pushes on the load, upwards [N]
    double ground = 0;  ///< that the ground pushes on the slab [N]
    double moment = 0;  ///< of the weld, about the mast [N m]
    double top = 0;     ///< height of the slab's top, in the mean [m]
};
CraneForces crane_forces(const World& world, const Contacts& contacts, double dt);

/// The outcome of a run: what hangs still behind the trolley's way, and what lies at the end.
struct CraneRun {
    CraneForces hanging, end;
    double swing = 0;  ///< largest angle of the rope while it hangs behind the way [rad]
    double most = 0;   ///< and on the way
    double error = 0;  ///< of what joints lock [m, rad]
    long bad = 0;
};

/// @param lowered  how far the hook comes down [m]
CraneRun run_crane(double lowered, double duration, const std::vector<Probe*>& probes = {});

}  // namespace enduring::chapter12
