#include "common/rigid/mass_properties.hpp"

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/tolerances.hpp"
#include "common/input/input_error.hpp"

#include <cmath>
#include <string>

namespace enduring {
namespace {

//! [moments]
/// The integrals of 1, x and x x^T over a solid.
struct Moments {
    double volume = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
};

/// Sum over the signed tetrahedra (origin, a, b, c), one a face. What such a tetrahedron covers outside the
/// body, another one takes away again, so the origin may lie anywhere.
Moments integrate(const SurfaceMesh& mesh, const Vec3& origin)
{
    Moments sum;
    for (const Face& face : mesh.faces) {
        const Vec3 a = mesh.vertices[face[0]] - origin;
        const Vec3 b = mesh.vertices[face[1]] - origin;
        const Vec3 c = mesh.vertices[face[2]] - origin;
        const double determinant = a.dot(b.cross(c));
        const Vec3 s = a + b + c;
        sum.volume += determinant / 6;
        sum.first += determinant / 24 * s;
        sum.second += determinant / 120 *
                      (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    return sum;
}
//! [moments]

void check_solid(const SurfaceMesh& mesh)
{
    const SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), mesh.faces);
    if (mesh.faces.empty() || !topology.is_closed())
        throw InputError("mass properties: the mesh is open; a rigid body needs a closed surface");
    if (!topology.is_consistently_oriented())
        throw InputError("mass properties: neighbouring faces run in opposite directions");
}

/// The side of the mesh's bounding box that is longest [m].
double extent(const SurfaceMesh& mesh)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : mesh.vertices)
        box.extend(vertex);
    return box.sizes().maxCoeff();
}

void check_positive(const char* what, double value)
{
    if (!(value > 0) || !std::isfinite(value))
        throw InputError(std::string(what) + " is " + std::to_string(value) +
                         ", it has to be positive and finite");
}

}  // namespace

//! [mass_properties]
MassProperties mass_properties(const SurfaceMesh& mesh, double density)
{
    check_positive("density", density);
    check_solid(mesh);

    // An origin on the body: far away, the large terms of the sum would
    // cancel and leave their rounding errors.
    const Vec3 origin = mesh.vertices[mesh.faces.front()[0]];
    const Moments moments = integrate(mesh, origin);
    if (!(moments.volume > tolerance::least_volume * std::pow(extent(mesh), 3)))
        throw InputError("mass properties: the mesh encloses a volume of " + std::to_string(moments.volume) +
                         " m^3; it has to be positive (faces counter-clockwise seen from outside)");

    const Vec3 centre = moments.first / moments.volume;
    const Mat3 second = moments.second - moments.volume * centre * centre.transpose();
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    return {density * moments.volume, origin + centre, density * inertia};
}
//! [mass_properties]

//! [sheet_properties]
MassProperties sheet_properties(const SurfaceMesh& mesh, double area_density)
{
    check_positive("area density", area_density);
    const Vec3 origin = mesh.vertices[mesh.faces.front()[0]];
    double area = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    for (const Face& face : mesh.faces) {
        const Vec3 a = mesh.vertices[face[0]] - origin, b = mesh.vertices[face[1]] - origin,
                   c = mesh.vertices[face[2]] - origin, s = a + b + c;
        const double of_face = (b - a).cross(c - a).norm() / 2;
        area += of_face;
        first += of_face / 3 * s;
        second += of_face / 12 *
                  (a * a.transpose() + b * b.transpose() + c * c.transpose() + s * s.transpose());
    }
    const Vec3 centre = first / area;
    second -= area * centre * centre.transpose();
    const Mat3 inertia = second.trace() * Mat3::Identity() - second;
    return {area_density * area, origin + centre, area_density * inertia};
}
//! [sheet_properties]

MassProperties with_mass(MassProperties properties, double mass)
{
    check_positive("mass", mass);
    properties.inertia *= mass / properties.mass;
    properties.mass = mass;
    return properties;
}

}  // namespace enduring
