#include "chapters/07_implicit_contact/normal_cone.hpp"

#include "common/geometry/tolerances.hpp"

#include <cmath>

namespace enduring {
namespace {

//! [cone]
/// Within the cosine of the flat cone between two normals: its foot on their plane lies between them.
bool pair_reaches(const Vec3& n, const Vec3& m, const Vec3& direction, double cosine)
{
    const Vec3 across = n.cross(m);
    const double out_of_plane = direction.dot(across), squared_length = across.squaredNorm();
    return n.cross(direction).dot(across) >= 0 && direction.cross(m).dot(across) >= 0 &&
           out_of_plane * out_of_plane <= (1 - cosine * cosine) * direction.squaredNorm() * squared_length &&
           squared_length > 0;
}

/// Inside the cone of three normals. Those of a flat side's triangles differ by rounding, which spans none.
bool triple_holds(const Vec3& n, const Vec3& m, const Vec3& l, const Vec3& direction)
{
    const double volume = n.dot(m.cross(l));
    return std::abs(volume) > tolerance::least_sine && volume * direction.dot(n.cross(m)) >= 0 &&
           volume * direction.dot(m.cross(l)) >= 0 && volume * direction.dot(l.cross(n)) >= 0;
}

}  // namespace

/// What lies in a cone lies in that of three of its normals (Carathéodory); what lies beside it is nearest to
/// one of them or to a place between two.
bool cone_reaches(std::span<const Vec3> normals, const Vec3& direction, double cosine)
{
    const std::size_t count = normals.size();
    for (const Vec3& n : normals)
        if (n.dot(direction) >= cosine * direction.norm())
            return true;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            if (pair_reaches(normals[i], normals[j], direction, cosine))
                return true;
            for (std::size_t k = j + 1; k < count; ++k)
                if (triple_holds(normals[i], normals[j], normals[k], direction))
                    return true;
        }
    return false;
}
//! [cone]

bool cone_reaches(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction,
                  double cosine)
{
    const std::vector<Vec3> normals = normal_span(surface, faces);
    return normals.empty() || cone_reaches(normals, direction, cosine);
}

}  // namespace enduring
