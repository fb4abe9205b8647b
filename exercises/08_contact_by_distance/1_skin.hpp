#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// A pair of two bodies with skins.
struct SkinnedPair {
    double skin_a, skin_b;  ///< [m]
    double h;               ///< k dt^2 / m of its spring; the same in a shorter step
    double dt;              ///< length of the step [s]
};

/// Two contact surfaces that come towards each other.
struct ComingSurfaces {
    double distance;  ///< positive: they have not crossed [m]
    double speed;     ///< with which the distance shrinks [m/s]
};

/// Your prediction: two cubes of 1 m have skins of 0.5 mm, the step is 10 ms, and h is 1000. At most how fast
/// may one cube hit the other if the surfaces shall not cross [m/s]? Not judged; positive.
double predicted_speed();

/// By how much the spring is compressed when the surfaces are at a distance; never negative [m].
double compression_at(const SkinnedPair& pair, double distance);

/// The surfaces after one step without other forces. The pair exists if the surfaces are nearer than both
/// skins at the start, or if they would cross within the step. Its spring pushes with the compression at the
/// end of the step: k dt times this compression is the impulse.
ComingSurfaces after_pressed_step(const SkinnedPair& pair, const ComingSurfaces& start);

/// The largest speed with which surfaces do not cross in a step, whatever their distance at its start [m/s].
double fastest_held(const SkinnedPair& pair);

/// How often the step is halved before its parts hold a speed: not at all if the whole step does, and at most
/// `most` times.
int halvings_for(SkinnedPair pair, double speed, int most);

/// How a vertex moves so that the planes of its faces move inwards by the skin [m]: as well as it can (least
/// squares), and no farther than it has to. Directions whose singular value is below a tenth of the largest
/// one are left out.
/// @param normals  of the planes, each once, out of the body, unit length; at least one
Vec3 inset_of_vertex(const std::vector<Vec3>& normals, double skin);

}  // namespace enduring
