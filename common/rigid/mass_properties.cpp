#include "common/rigid/mass_properties.hpp"

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/tolerances.hpp"
#include "common/input/input_error.hpp"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numeric>
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

std::optional<Vec3> common_line(std::span<const Vec3> points)
{
    const Vec3 mean = std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) /
                      static_cast<double>(points.size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& x : points)
        spread += (x - mean) * (x - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Mat3> along(spread);  // ascending
    if (along.eigenvalues()[1] > tolerance::least_inertia * along.eigenvalues()[2])
        return std::nullopt;
    return along.eigenvectors().col(2);
}

//! [frame_properties]
MassProperties frame_properties(const SurfaceMesh& mesh, double mass)
{
    check_positive("mass", mass);
    const Vec3 origin = mesh.vertices.front();
    double shares = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    const auto add = [&](double share, const Vec3& mean, const Mat3& square) {
        shares += share;
        first += share * mean;
        second += share * square;
    };
    if (mesh.wires.empty())
        for (const Vec3& vertex : mesh.vertices) {
            const Vec3 x = vertex - origin;
            add(1, x, x * x.transpose());
        }
    for (const auto& [i, j] : mesh.wires) {
        const Vec3 a = mesh.vertices[static_cast<std::size_t>(i)] - origin,
                   b = mesh.vertices[static_cast<std::size_t>(j)] - origin, s = a + b;
        if (a == b)
            throw InputError("the edge between the vertices " + std::to_string(i) + " and " +
                             std::to_string(j) + " has no length");
        add((b - a).norm(), s / 2, (a * a.transpose() + b * b.transpose() + s * s.transpose()) / 6);
    }
    const Vec3 centre = first / shares;
    second = second / shares - centre * centre.transpose();
    if (!(second.trace() > 0))
        throw InputError("all points are at one place; a body of points and edges needs two or more");
    const double largest = second.trace();  // about a line, across it
    const Mat3 inertia = common_line(mesh.vertices) ? Mat3(largest * Mat3::Identity())
                                                    : Mat3(largest * Mat3::Identity() - second);
    return {mass, origin + centre, mass * inertia};
}
//! [frame_properties]

MassProperties with_mass(MassProperties properties, double mass)
{
    check_positive("mass", mass);
    properties.inertia *= mass / properties.mass;
    properties.mass = mass;
    return properties;
}

}  // namespace enduring
