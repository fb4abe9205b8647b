#pragma once

#include "chapters/02_collision_detection/experiments/gallery_cases.hpp"
#include "chapters/02_collision_detection/experiments/tunnelling.hpp"
#include "common/experiments/render/renderer.hpp"

#include <optional>

namespace enduring::chapter02 {

/// Draws the gallery: three moments side by side, the touching features in the course's colours.
class GalleryStage {
public:
    GalleryStage();
    /// @param touch  when its features touch, if they do
    Picture draw_case(const GalleryCase& one, const std::optional<double>& touch);
    Picture draw_tunnelling(const Tunnelling& scene, double touch);
    /// One triangle and three edges: one that ends before it, one
    /// through it, one beside it in its parallelogram.
    Picture draw_edge_triangle();

private:
    Renderer renderer_;
};

}  // namespace enduring::chapter02
