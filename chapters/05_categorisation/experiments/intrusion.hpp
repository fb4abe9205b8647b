#pragma once

#include "chapters/05_categorisation/experiments/hooked_pairs.hpp"
#include "common/experiments/render/picture.hpp"
#include "common/experiments/report/report.hpp"

#include <string>
#include <vector>

namespace enduring::chapter05 {

/// A convex body that moves, and the flat surface of a static one that should keep it out.
struct IntrusionScene {
    std::string name;
    std::string patch;           ///< a change to the scene `hooked`
    std::string body, obstacle;  ///< names
    Vec3 outwards;               ///< of the obstacle's surface, which passes through the origin; unit length
    double thickness;            ///< of the obstacle behind it [m]; infinite for a floor
};

/// A cube that slides, a ball that falls on soft contacts, a plate that runs edge on into a wall.
std::vector<IntrusionScene> intrusion_scenes();

/// How far the moving body got in.
struct Intrusion {
    double deepest = 0;     ///< of its foremost vertex, at any time [m]
    double deepest_at = 0;  ///< [s]
    /// most at one time: vertices of either body inside the other that are in no vertex-face pair
    long lost_vertices = 0;
    double last_speed = 0;  ///< of the body along x at the end [m/s]
    Table depths{{"hooked_pairs", "time_s", "depth_m"}};
};

/// Runs a scene under solver_that(treatment).
Intrusion intrude(const IntrusionScene& scene, HookedPairs treatment);

/// The scene at one moment of such a run, regular pairs in the thesis' colours, hooked ones in orange.
Picture picture_of_intrusion(const IntrusionScene& scene, HookedPairs treatment, double time);

}  // namespace enduring::chapter05
