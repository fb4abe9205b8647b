#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <string>
#include <variant>
#include <vector>

namespace enduring::chapter02 {

/// A query whose answer follows from how it was made.
struct HardCase {
    std::string name;
    std::variant<VertexFaceStep, EdgeEdgeStep> step;
    std::optional<double> truth;  ///< first touch, nothing if there is none
};

/// One case of each kind of trouble, and an ordinary one to begin with.
std::vector<HardCase> hard_cases();

}  // namespace enduring::chapter02
