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

/// A cup of 2 mm and 8 cm in another one.
Scene cups_apart(double gap, double dt);

/// A chain of five rings, stretched but for so much play between neighbours.
Scene links_apart(double play, double dt);

/// Six sheets of paper, 0.1 mm thick, over each other.
Scene paper_apart(double gap, double dt);

/// The same as open surfaces with two sides.
Scene sheets_apart(double gap, double dt);

/// Two gears in mesh.
/// @param play  taken from each tooth's thickness [m]
Scene gears_apart(double play, double dt);

constexpr double least_bolt_play = 1e-5, most_bolt_play = 1e-3;

/// A bolt in its nut.
/// @param play  from least_bolt_play to most_bolt_play: with less the facets of both cross, whose diagonals
///     differ, and with more nothing is left of the nut's ridge [m]
Scene bolt_apart(double play, double dt);

/// What pairs have done.
struct GapRun {
    double pushed = 0;  ///< sum of all impulses, over the weight of the last body for the time of the run [1]
    double off_fall = 0;  ///< of a body from what a free one does, over its size, the most [1]
    double aside = 0;     ///< change of a body's velocity across its fall, the most [m/s]
    long newton_steps = 0;
};
GapRun run_gap(Scene scene, int steps);

}  // namespace enduring::chapter08
