#pragma once

#include "common/geometry/meshes.hpp"
#include "common/simulation/contact.hpp"
#include "common/simulation/static_body.hpp"
#include "common/simulation/step.hpp"

#include <memory>

namespace enduring::chapter05 {

/// Places of the two bodies in World::bodies.
inline constexpr int floor_body = 0, cube_body = 1;

/// A body that stays where it is put.
std::unique_ptr<StaticBody> still(SurfaceMesh mesh, const Vec3& at);

/// A cube of side 1 that stands a little in a floor of 4 x 4 cells of side 1.
World cube_in_floor();

/// The edge of a body whose ends lie in this direction from each other, with its lowest middle; -1 for none.
int lowest_edge_along(const Body& body, const Vec3& direction);

/// The cube's lowest edge along one direction (A) against the floor's along
/// another (B), with a normal that looks along `out`.
Contact edge_pair(const World& world, const Vec3& cube_edge, const Vec3& floor_edge, const Vec3& out);

}  // namespace enduring::chapter05
