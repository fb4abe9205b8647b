#pragma once

#include "common/experiments/render/camera.hpp"
#include "common/experiments/render/palette.hpp"
#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// A triangle surface to be drawn. Colours everywhere on the stage are linear RGB in [0, 1].
struct Drawable {
    std::vector<Vec3> positions;
    std::vector<Face> faces;
    Vec3 color = palette::blue;
    bool smooth = false;     ///< normals blend over edges flatter than 40 degrees
    bool wireframe = false;  ///< thin dark lines along the edges
    double opacity = 1;      ///< below 1 what lies behind shows through
    /// off for surfaces much larger than the rest, such as a plane given as a mesh
    bool casts_shadow = true;
};

/// A plane that receives shadows and fades into the background.
struct Ground {
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitY();
    /// spacing of its faint lines [m]; 0 leaves it to the camera's distance, negative means none
    double grid = 0;
};

/// Annotations keep their size in pixels, take no part in shadows, and shine faintly through what hides them.
struct Dot {
    Vec3 point;
    Vec3 color = palette::colliding_vertex;
    double radius_px = 5;
};
struct Segment {
    Vec3 from, to;
    Vec3 color = palette::ink;
    double width_px = 3;
    bool arrow = false;   ///< a head at `to`
    bool dashed = false;  ///< for trajectories
};
struct TintedTriangle {
    std::array<Vec3, 3> corners;
    Vec3 color = palette::colliding_face;
};

/// A line of text, on top of everything.
struct Label {
    std::string text;
    /// a point of the stage; without it `offset_px` counts from the top left
    std::optional<Vec3> anchor;
    Eigen::Vector2d offset_px{10, -10};  ///< right and down, to the left end of the base line
    Vec3 color = palette::ink;
    double size_px = 17;  ///< height of the font
};

/// All that one picture shows.
struct Stage {
    std::vector<Drawable> bodies;
    std::vector<Ground> grounds;
    std::vector<Dot> dots;
    std::vector<Segment> segments;
    std::vector<TintedTriangle> triangles;
    std::vector<Label> labels;
    Camera camera;
};

/// Every vertex and annotated point of a stage, for `frame`.
std::vector<Vec3> points_of(const Stage& stage);

}  // namespace enduring
