#pragma once

#include "common/geometry/meshes.hpp"
#include "common/input/json_value.hpp"
#include "common/scenes/shape_reader.hpp"

namespace enduring {

/// The shapes "points" and "wire": points and edges alone, {"vertices": [...], "edges": [...]} or {"file":
/// "frame.obj"}.
/// @throws InputError  an edge twice or without two ends, a vertex of a wire in no edge, one point alone, all
///     at one place
SurfaceMesh read_points(const JsonValue& value, const SceneSurroundings& surroundings);
SurfaceMesh read_wire(const JsonValue& value, const SceneSurroundings& surroundings);

/// What stands at a body of points and edges and has no meaning there: a spin or a torque about a line on
/// which all its points lie.
/// @param placed  its points in the world [m]
void refuse_turns_about_own_line(const JsonValue& body, std::span<const Vec3> placed);

}  // namespace enduring
