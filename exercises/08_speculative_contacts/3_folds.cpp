#include "exercises/08_speculative_contacts/3_folds.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {
namespace {

Vec3 along(const FoldedEdge& edge) { return (edge.q - edge.p).stableNormalized(); }

Vec3 into(const FoldedEdge& edge, const Vec3& corner)
{
    const Vec3 path = corner - edge.p;
    return (path - path.dot(along(edge)) * along(edge)).stableNormalized();
}

}  // namespace

Vec3 into_left(const FoldedEdge& edge)
{
    not_implemented_yet("8.3");
}
Vec3 into_right(const FoldedEdge& edge)
{
    not_implemented_yet("8.3");
}

double fold_of(const FoldedEdge& edge)
{
    not_implemented_yet("8.3");
}

FoldKind kind_of(const FoldedEdge& edge, double least)
{
    not_implemented_yet("8.3");
}

bool can_push(const FoldedEdge& edge, const Vec3& direction, double least, double sine)
{
    not_implemented_yet("8.3");
}

std::optional<Vec3> normal_of_pair(const FoldedEdge& a, const FoldedEdge& b, double least, double sine,
                                   double parallel)
{
    not_implemented_yet("8.3");
}

}  // namespace enduring
