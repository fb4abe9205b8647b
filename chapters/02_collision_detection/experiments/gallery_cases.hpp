#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <string>
#include <variant>
#include <vector>

namespace enduring::chapter02 {

/// One elementary case: two features over one step, and when to look at them.
struct GalleryCase {
    std::string name;  ///< of its picture: gallery_NAME.png
    std::variant<VertexFaceStep, EdgeEdgeStep> step;
    double closest;  ///< when they are nearest, for a pair that never touches
};

/// A vertex through a face, two edges through each other, a near miss, and a touch that grazes.
std::vector<GalleryCase> gallery_cases();

/// The points of a case at one time: v f0 f1 f2, or ea0 ea1 eb0 eb1.
std::vector<Vec3> points_at(const GalleryCase& one, double tau);

}  // namespace enduring::chapter02
