#pragma once

#include "chapters/05_categorisation/normal_span.hpp"

#include <string>
#include <vector>

namespace enduring::chapter05 {

/// A surface that rests: vertex 0 at the origin with a fan of faces around it.
struct Corner {
    std::string name;
    SurfaceTopology topology;
    std::vector<Vec3> positions;

    SurfaceMoment surface() const { return {{topology, positions, positions}, 0}; }
    std::span<const int> faces() const { return topology.faces_around_vertex(0); }
};

/// @param rim     the vertices around, counter-clockwise seen from outside
/// @param closed  the last of them joins the first; if not, the vertex lies on a border
Corner fan(std::string name, const std::vector<Vec3>& rim, bool closed = true);

/// A tip that looks to +y, n edges that make `angle` [rad] with the axis below it; pi/2 is flat.
Corner cone_corner(std::string name, int edges, double angle);

/// The tip of a regular tetrahedron, the corner of a cube, a vertex of a
/// flat surface, and of a saddle; all look to +y.
std::vector<Corner> sphere_corners();

/// The first of them with this in its name: "tetrahedron", "cube", "flat", "saddle".
/// @throws std::invalid_argument  there is none
Corner sphere_corner(const std::string& part);

/// A point on the ridge of a wedge that runs along z and looks to -y: in the
/// plane z = 0 a corner as in the thesis' drawings.
/// @param opening  angle of the solid at the ridge [rad], in (0, pi]
Corner wedge_corner(std::string name, double opening);

/// Whether a flat obstacle can touch the corner at its vertex without cutting into it: all
/// of the corner lies on the side that the obstacle's normal points to. This is what a
/// label should find, and it needs no normals of the corner.
bool can_touch(const Corner& corner, const Vec3& contact_normal);

/// Thesis (6.1): the averaged vertex normal alone calls it regular.
bool average_says_regular(const Corner& corner, const Vec3& contact_normal);

/// Thesis (6.2): the span calls it regular.
bool span_says_regular(const Corner& corner, const Vec3& contact_normal);

}  // namespace enduring::chapter05
