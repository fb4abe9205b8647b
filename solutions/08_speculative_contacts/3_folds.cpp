#include "exercises/08_speculative_contacts/3_folds.hpp"

namespace enduring {
namespace {

Vec3 along(const FoldedEdge& edge) { return (edge.q - edge.p).stableNormalized(); }

Vec3 into(const FoldedEdge& edge, const Vec3& corner)
{
    const Vec3 path = corner - edge.p;
    return (path - path.dot(along(edge)) * along(edge)).stableNormalized();
}

}  // namespace

Vec3 into_left(const FoldedEdge& edge) { return into(edge, edge.left); }
Vec3 into_right(const FoldedEdge& edge) { return into(edge, edge.right); }

double fold_of(const FoldedEdge& edge)
{
    const Vec3 left_normal = along(edge).cross(into_left(edge));
    return left_normal.dot(into_right(edge));
}

FoldKind kind_of(const FoldedEdge& edge, double least)
{
    const double fold = fold_of(edge);
    if (fold > least)
        return FoldKind::valley;
    return fold < -least ? FoldKind::ridge : FoldKind::flat;
}

bool can_push(const FoldedEdge& edge, const Vec3& direction, double least, double sine)
{
    const Vec3 left_normal = along(edge).cross(into_left(edge)),
               right_normal = into_right(edge).cross(along(edge));
    const bool looks_out = left_normal.dot(direction) > 0 || right_normal.dot(direction) > 0;
    const bool is_behind = into_left(edge).dot(direction) <= sine && into_right(edge).dot(direction) <= sine;
    return kind_of(edge, least) == FoldKind::ridge && looks_out && is_behind;
}

std::optional<Vec3> normal_of_pair(const FoldedEdge& a, const FoldedEdge& b, double least, double sine,
                                   double parallel)
{
    const Vec3 across = along(a).cross(along(b));
    if (across.norm() <= parallel)
        return std::nullopt;
    const Vec3 normal = across.normalized();
    for (const Vec3& out : {normal, Vec3(-normal)})
        if (can_push(b, out, least, sine) && can_push(a, -out, least, sine))
            return out;
    return std::nullopt;
}

}  // namespace enduring
