#pragma once

#include "common/geometry/meshes.hpp"
#include "common/geometry/vector.hpp"

#include <optional>
#include <span>

namespace enduring {

/// Everything a rigid body's motion knows of its shape.
struct MassProperties {
    double mass = 0;              ///< [kg]
    Vec3 centre = Vec3::Zero();   ///< centre of mass [m], in the mesh's coordinates
    Mat3 inertia = Mat3::Zero();  ///< about the centre, along the mesh's axes [kg m^2]
};

/// Mass, centre and inertia of a homogeneous body, exact for a closed polyhedron:
/// every face spans a signed tetrahedron with one common point, and the polynomials 1,
/// x and x x^T are integrated over each in closed form.
///
/// @param mesh     closed, consistently oriented, faces counter-clockwise seen from outside
/// @param density  [kg/m^3], positive
/// @throws InputError  density not positive and finite; mesh open or
///     inconsistently oriented; volume not positive
MassProperties mass_properties(const SurfaceMesh& mesh, double density);

/// The same of a sheet: all of its mass lies on the faces, as on thin metal. Exact as well; it need not be
/// closed.
/// @param mesh          faces with an area
/// @param area_density  [kg/m^2], positive
/// @throws InputError   density not positive and finite
MassProperties sheet_properties(const SurfaceMesh& mesh, double area_density);

/// The same of points and edges alone, as of threads and pins. The mass lies on the edges, shared by their
/// lengths, if there are any; else each point has an equal share. Exact.
///
/// About a line on which all points lie they have no inertia, and no force on one of them turns them about
/// it. There the largest moment stands in place of none, so that an inverse exists: nothing that moves the
/// points depends on it.
/// @param mesh  without faces; two or more points
/// @param mass  [kg], positive
/// @throws InputError  mass not positive and finite; all points at one place; an edge without length
MassProperties frame_properties(const SurfaceMesh& mesh, double mass);

/// The direction of the line on which all points lie, unit length; none where they do not.
std::optional<Vec3> common_line(std::span<const Vec3> points);

/// The same shape with another mass [kg], positive; the inertia scales along.
/// @throws InputError  mass not positive and finite
MassProperties with_mass(MassProperties properties, double mass);

}  // namespace enduring
