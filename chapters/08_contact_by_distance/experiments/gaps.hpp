#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::chapter08 {

/// Two combs of five teeth, 0.1 m wide, that stand in each other with so much play on each side of a tooth.
struct Combs {
    double play;                   ///< [m]
    double dt;                     ///< [s]
    bool lower_held = false;       ///< else both fall
    double rise = 0.002;           ///< of the upper one over the touch of tips and valleys [m]
    Vec3 velocity = Vec3::Zero();  ///< of the upper one [m/s]
};
Scene scene_of(const Combs& combs);

/// A plate over another one, both leaning, so far apart along their common normal [m].
Scene plates_apart(double gap, double dt);

/// What pairs have done.
struct GapRun {
    double pushed =
        0;  ///< sum of all impulses, over the weight of the upper body for the time of the run [1]
    double off_fall = 0;  ///< of the upper body from what a free body does, over its size [1]
    double aside = 0;     ///< speed of the upper body across its way at the end [m/s]
    long newton_steps = 0;
};
GapRun run_gap(Scene scene, int steps);

}  // namespace enduring::chapter08
