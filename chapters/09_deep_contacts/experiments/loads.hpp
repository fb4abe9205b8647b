#pragma once

#include "common/scenes/scene.hpp"

#include <vector>

namespace enduring::chapter09 {

/// Boxes on one another, on the plane y = 0, exactly edge on edge, from the ground up.
struct Pile {
    std::vector<double> masses;  ///< [kg]
    double side = 1;             ///< of each cube [m]
    int cells = 1;               ///< along each edge; each cell of a side is cut into two triangles
    double gap = 0;              ///< below each cube at first [m]
};

/// A scene, and where the middles of its bodies should come to rest.
struct Load {
    Scene scene;
    std::vector<Vec3> places;
};

/// Rigid cubes, with friction 0.5 and 0.4.
Load load_of(const Pile& pile, double dt);
/// A block of 100 kg and 0.2 m on four dice of 1 g and 1 cm, below its corners, with a gap below each body.
Load block_on_dice(int cells, double gap, double dt);

/// What a light body under a heavy one comes to.
struct LoadOutcome {
    double height_mm = 0;    ///< by which a body's middle is off its place at the end, the farthest
    double sunk_mm = 0;      ///< the same below its place, after any step
    double sideways_mm = 0;  ///< that a body has moved at the end, the farthest
    double speed = 0;        ///< of the fastest body at the end [m/s]
    double gained = 0;       ///< most that the bodies' energy rose above the first [J]
    int told_at = 0;  ///< step at which the watch on energy said that it came from nothing; 0 for never
    long newton_steps = 0, max_newton_steps = 0;  ///< of all problems; of one
    long solves = 0, unconverged = 0;

    /// Whether all bodies lie where they should, within a tenth of a millimetre, and still to 0.1 mm/s.
    bool rests() const { return height_mm < 0.1 && sideways_mm < 1 && speed < 1e-4 && told_at == 0; }
};

/// Runs a scene with the solver of chapter 8 or 9.
LoadOutcome watch(Load& load, int chapter, double duration);

}  // namespace enduring::chapter09
