#pragma once

#include "chapters/05_categorisation/experiments/hooked_pairs.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace enduring::chapter05 {

/// Out of a static body at a point of its surface, unit length, as the
/// smooth shape has it that the triangles stand for.
using Outwards = std::function<Vec3(const Vec3& point)>;

/// A scene whose static bodies stand for planes and spheres, so that
/// every pair's normal has one right direction.
struct TruthScene {
    std::string name;
    std::string patch;                           ///< a change to the scene `hooked`
    std::map<std::string, Outwards> outwards{};  ///< of each static body
    HookedPairs treatment = HookedPairs::held;
};

/// A cube that slides straight, slides turned, meets a wall, slides
/// through a bowl; a ball; a tetrahedron on its tip.
std::vector<TruthScene> truth_scenes();

/// Labels against the truth: a pair is an artefact when its normal is
/// farther than 45 degrees from the right direction.
struct LabelCounts {
    long true_regular = 0, true_hooked = 0;          ///< of true pairs
    long artefact_regular = 0, artefact_hooked = 0;  ///< of artefacts
    long on_border = 0;                              ///< the normal leans by 45 degrees, to half of one
    long without_normal = 0;

    long true_pairs() const { return true_regular + true_hooked; }
    long artefacts() const { return artefact_regular + artefact_hooked; }
    LabelCounts& operator+=(const LabelCounts& other);
};

/// Runs a scene; every label counts once in each step, at the moment at which it was taken.
/// @param share  of the scene's duration, in (0, 1]
/// @param rule   for edge pairs
LabelCounts count_labels(const TruthScene& scene, double share = 1, EdgeRule rule = EdgeRule::either);

}  // namespace enduring::chapter05
