#pragma once

#include "common/simulation/step.hpp"

#include <string>
#include <vector>

namespace enduring {

/// The surfaces of all bodies at the committed state, as a VTK PolyData document (.vtp).
///
/// A point a surface vertex, a polygon a face. On points: velocity [m/s], contact_force
/// [N] (what normal and friction impulses gave the vertex, as their mean over the
/// step), body (index into World::bodies). On faces: body.
/// @param contacts  alive after the step, with the impulses they gave in it
/// @param dt        of that step [s], positive
std::string surfaces_vtp(const World& world, const Contacts& contacts, double dt);

/// The inside of all deformable bodies, as a VTK UnstructuredGrid document (.vtu).
///
/// A cell an element: 4-node tetrahedra, and 10-node ones for quadratic elements, whose edge points are
/// points of the body and not its control points, so that VTK's shape is ours. On points: velocity [m/s],
/// body. On cells: inverted (0 or 1, as Body::inverted_elements() counts), body.
std::string elements_vtu(const World& world);

/// The pairs in contact, as a VTK PolyData document (.vtp): a line from q to p a pair.
///
/// On lines: normal_force and friction_force on body A [N], impulse [N s] (both together), depth [m]
/// (negative inside), kind (0 plane, 1 vertex-face, 2 edge-edge), category (0 unknown, 1 regular, 2 hooked),
/// held (0 or 1), body_a, body_b (for a plane: -1 - its index).
/// @param contacts, dt  as above
std::string pairs_vtp(const World& world, const Contacts& contacts, double dt);

/// Whether any body has elements to show.
bool has_elements(const World& world);

/// One file of a time series.
struct VtkMoment {
    double time;       ///< [s]
    std::string file;  ///< from the series' own folder
};

/// A time series, as a ParaView collection (.pvd).
std::string series_pvd(const std::vector<VtkMoment>& moments);

}  // namespace enduring
