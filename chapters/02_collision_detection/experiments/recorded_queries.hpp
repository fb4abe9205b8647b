#pragma once

#include "chapters/02_collision_detection/query.hpp"

#include <string>
#include <vector>

namespace enduring::chapter02 {

/// The queries that a scene asks: the pairs whose swept boxes overlap.
struct RecordedQueries {
    std::vector<VertexFaceStep> vertex_face;
    std::vector<EdgeEdgeStep> edge_edge;
    int detections = 0;  ///< from which they come
};

/// Runs a scene of the course with chapter 1's answer of the ground and none between the bodies, and records
/// from the detection in which boxes first overlap: the approach, the touch, and the start of the overlap.
/// @param scene_name  of common/scenes
/// @param detections  to record; a step has one more whenever the ground answers
RecordedQueries record_queries(const std::string& scene_name, int detections);

}  // namespace enduring::chapter02
