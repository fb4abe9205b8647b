#include "chapters/09_deep_contacts/intersection_curve.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace enduring {
namespace {

/// A face of A and a face of B that cross, and a piercing at an end of the piece of curve along both.
struct End {
    int face_a, face_b, piercing;
    auto faces() const { return std::tie(face_a, face_b); }
};

std::vector<End> ends_of_pieces(const std::vector<Piercing>& piercings, const StillSurface& a,
                                const StillSurface& b)
{
    not_implemented_yet("9.1");
}

/// At most two pieces of curve leave a piercing, one along each face at its edge.
using Neighbours = std::array<int, 2>;

/// Two triangles cross along one piece of a line, which has two ends.
std::vector<Neighbours> link(const std::vector<End>& ends, std::size_t piercings)
{
    not_implemented_yet("9.1");
}

/// From a piercing on, until the curve comes back or ends.
IntersectionCurve walk(int first, const std::vector<Neighbours>& next, std::vector<bool>& passed)
{
    not_implemented_yet("9.1");
}

}  // namespace

Intersection join_piercings(std::vector<Piercing> piercings, const StillSurface& a, const StillSurface& b)
{
    Intersection intersection{std::move(piercings), {}};
    const std::size_t count = intersection.piercings.size();
    const std::vector<Neighbours> next = link(ends_of_pieces(intersection.piercings, a, b), count);
    std::vector<bool> passed(count);
    // Those that end at a border first: a walk along them has to begin at an end.
    for (const bool from_ends : {true, false})
        for (std::size_t i = 0; i < count; ++i)
            if (!passed[i] && (!from_ends || next[i][1] < 0))
                intersection.curves.push_back(walk(static_cast<int>(i), next, passed));
    return intersection;
}

Intersection trace_intersection(const StillSurface& a, const StillSurface& b)
{
    return join_piercings(find_piercings(a, b), a, b);
}

}  // namespace enduring
