#pragma once

#include "common/scenes/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::motivating {

/// By which factors a scene differs from another one that moves alike.
struct SceneScale {
    double length = 1;
    double density = 1;  ///< it has no part in how things move
};

/// The same scene in other units: lengths times s, times by the root of s, masses by s^3 and the density.
/// Gravity and friction stay. Whatever is computed from it has to be the same in these units: a body falls
/// over its own size as it does in the scene as it was.
///
/// A power of four has an exact root, so the scene is the same to the last bit.
/// @param scene  the text of a scene file
std::string scaled(const std::string& scene, const SceneScale& scale);

/// Scenes of bodies of about a metre that show what a scale could change, as in scene files.
struct ScaleTrial {
    std::string name, scene;
    int steps;  ///< over which it is compared; what tumbles doubles a difference in each impact
};
/// What falls, stands, slides, rolls, bends, and flies without weight.
const std::vector<ScaleTrial>& scale_trials();
/// What begins inside a plane or another body.
const std::vector<ScaleTrial>& inside_scale_trials();

/// How far two runs of one scene differ: the largest distance of a vertex from the same in the other run,
/// which has another scale, in units of the first [m].
double difference(const World& world, const World& scaled, const SceneScale& scale);

/// The largest difference() of a trial from the same in four other scales, a thousandth to a hundred times as
/// large and of other densities [m].
/// @param make_solver  of a scene's contact parameters
double difference_over_scales(const ScaleTrial& trial,
                              const std::function<Solver(const ContactParameters&)>& make_solver);

}  // namespace enduring::motivating
