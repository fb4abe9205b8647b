#pragma once

#include "gallery_cases.hpp"

#include "common/geometry/meshes.hpp"
#include "common/render/renderer.hpp"

#include <filesystem>
#include <optional>

namespace enduring::chapter02 {

std::vector<Face> plate_faces();  ///< of a plate's four corners, both sides of a sheet being one
std::vector<Face> spike_faces();  ///< of a spike's four corners, outwards

/// Draws the gallery: three moments side by side, the touching features in the course's colours.
class GalleryStage {
public:
    GalleryStage();
    void write_case(const GalleryCase& one, const std::optional<double>& touch, const std::filesystem::path& file);
    void write_tunnelling(const Tunnelling& scene, double touch, int hits_before, int hits_after, const std::filesystem::path& file);
    /// One triangle and three edges: through it, beside it in its parallelogram, and ending before it.
    void write_edge_triangle(const std::filesystem::path& file);

private:
    Renderer renderer_;
};

}  // namespace enduring::chapter02
