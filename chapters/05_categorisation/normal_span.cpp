#include "chapters/05_categorisation/normal_span.hpp"

namespace enduring {

std::vector<Vec3> normal_span(const SurfaceMoment& surface, std::span<const int> faces)
{
    std::vector<Vec3> normals;
    any_in_span(surface, faces, [&](const Vec3& normal) {
        normals.push_back(normal);
        return false;
    });
    return normals;
}

//! [span_reaches]
bool span_reaches(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction,
                  double cosine)
{
    const double enough = cosine * direction.norm();
    bool empty = true;
    const bool reached = any_in_span(surface, faces, [&](const Vec3& normal) {
        empty = false;
        return normal.dot(direction) >= enough;
    });
    return reached || empty;
}
//! [span_reaches]

}  // namespace enduring
