#pragma once

#include "common/simulation/body.hpp"

#include <vector>

namespace enduring {

/// What pictures, films and files for viewers show of a body: its own surface, or of points and edges alone a
/// rod along each edge and a small octahedron at each point without one.

/// The drawn vertices where the body is now [m]; always as many.
std::vector<Vec3> drawn_points(const Body& body);

/// Its drawn faces, by places in drawn_points().
std::vector<Face> drawn_faces(const Body& body);

/// The body's own vertices to which a drawn face belongs: three, or the two of an edge, or a point.
std::vector<int> vertices_of_drawn_face(const Body& body, int face);

}  // namespace enduring
