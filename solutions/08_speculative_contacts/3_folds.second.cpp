#include "exercises/08_speculative_contacts/3_folds.hpp"

#include <cmath>

namespace enduring {
namespace {

Vec3 normal_of(const Vec3& p, const Vec3& q, const Vec3& r) { return (q - p).cross(r - p).normalized(); }
Vec3 left_normal(const FoldedEdge& edge) { return normal_of(edge.p, edge.q, edge.left); }
Vec3 right_normal(const FoldedEdge& edge) { return normal_of(edge.q, edge.p, edge.right); }

}  // namespace

Vec3 into_left(const FoldedEdge& edge) { return left_normal(edge).cross((edge.q - edge.p).normalized()); }
Vec3 into_right(const FoldedEdge& edge) { return right_normal(edge).cross((edge.p - edge.q).normalized()); }

double fold_of(const FoldedEdge& edge)
{
    // The turn from one normal to the other one, about the edge.
    return left_normal(edge).cross(right_normal(edge)).dot((edge.p - edge.q).normalized());
}

FoldKind kind_of(const FoldedEdge& edge, double least)
{
    if (std::abs(fold_of(edge)) <= least)
        return FoldKind::flat;
    return fold_of(edge) > 0 ? FoldKind::valley : FoldKind::ridge;
}

bool can_push(const FoldedEdge& edge, const Vec3& direction, double least, double sine)
{
    if (kind_of(edge, least) != FoldKind::ridge)
        return false;
    if (std::fmax(into_left(edge).dot(direction), into_right(edge).dot(direction)) > sine)
        return false;
    return std::fmax(left_normal(edge).dot(direction), right_normal(edge).dot(direction)) > 0;
}

std::optional<Vec3> normal_of_pair(const FoldedEdge& a, const FoldedEdge& b, double least, double sine,
                                   double parallel)
{
    const Vec3 of_a = (a.q - a.p).normalized(), of_b = (b.q - b.p).normalized();
    if (of_a.cross(of_b).norm() <= parallel)
        return std::nullopt;
    Vec3 out = of_b.cross(of_a).normalized();
    if (out.dot(left_normal(b) + right_normal(b)) < 0)
        out = -out;
    if (!can_push(b, out, least, sine) || !can_push(a, -out, least, sine))
        return std::nullopt;
    return out;
}

}  // namespace enduring
