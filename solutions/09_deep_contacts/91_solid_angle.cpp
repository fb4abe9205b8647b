#include "exercises/09_deep_contacts/91_solid_angle.hpp"

#include <cmath>

namespace enduring {

double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point)
{
    const Vec3 u = a - point, v = b - point, w = c - point;
    const double volume = u.dot(v.cross(w));
    const double lengths = u.norm() * v.norm() * w.norm();
    const double mixed = u.dot(v) * w.norm() + v.dot(w) * u.norm() + w.dot(u) * v.norm();
    return 2 * std::atan2(volume, lengths + mixed);
}

double winding(const SurfaceMesh& mesh, const Vec3& point)
{
    double sum = 0;
    for (const auto& [a, b, c] : mesh.faces) {
        const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
        sum += solid_angle(at(a), at(b), at(c), point);
    }
    return sum / (16 * std::atan(1.0));
}

std::vector<int> vertices_inside(const SurfaceMesh& one, const SurfaceMesh& other)
{
    std::vector<int> found;
    for (std::size_t v = 0; v < one.vertices.size(); ++v)
        if (winding(other, one.vertices[v]) > 0.5)
            found.push_back(static_cast<int>(v));
    return found;
}

std::vector<Vec3> middles_inside(const SurfaceMesh& one, const SurfaceMesh& other)
{
    std::vector<Vec3> found;
    for (const Face& face : one.faces)
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = face[i], to = face[(i + 1) % 3];
            const Vec3 middle =
                (one.vertices[static_cast<std::size_t>(from)] + one.vertices[static_cast<std::size_t>(to)]) /
                2;
            if (from < to && winding(other, middle) > 0.5)
                found.push_back(middle);
        }
    return found;
}

}  // namespace enduring
