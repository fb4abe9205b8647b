#include "chapters/02_collision_detection/edge_triangle.hpp"

namespace enduring {

//! [edge_triangle]
std::optional<EdgeTriangleHit> find_edge_triangle_hit(const Vec3& p, const Vec3& q, const Vec3& a,
                                                      const Vec3& b, const Vec3& c)
{
    const Vec3 to_p = p - a, back = p - q, ab = b - a, ac = c - a;
    const Vec3 normal = ab.cross(ac);
    const double determinant = back.dot(normal);
    if (determinant == 0)
        return std::nullopt;

    const Vec3 across = to_p.cross(back);
    const EdgeTriangleHit hit{to_p.dot(normal) / determinant, -ac.dot(across) / determinant,
                              ab.dot(across) / determinant};
    const bool on_edge = 0 <= hit.along_edge && hit.along_edge <= 1;
    const bool in_triangle = hit.weight_b >= 0 && hit.weight_c >= 0 && hit.weight_b + hit.weight_c <= 1;
    return on_edge && in_triangle ? std::optional(hit) : std::nullopt;
}
//! [edge_triangle]

}  // namespace enduring
