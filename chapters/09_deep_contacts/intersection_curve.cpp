#include "chapters/09_deep_contacts/intersection_curve.hpp"

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
    std::vector<End> ends;
    for (std::size_t i = 0; i < piercings.size(); ++i) {
        const Piercing& piercing = piercings[i];
        const SurfaceTopology& surface = (piercing.edge_of_a ? a : b).topology;
        for (const int face : surface.faces_at_edge(piercing.edge))
            if (face >= 0)
                ends.push_back({piercing.face_of_a(face), piercing.face_of_b(face), static_cast<int>(i)});
    }
    std::sort(ends.begin(), ends.end(), [](const End& one, const End& other) {
        return std::tie(one.face_a, one.face_b, one.piercing) <
               std::tie(other.face_a, other.face_b, other.piercing);
    });
    return ends;
}

/// At most two pieces of curve leave a piercing, one along each face at its edge.
using Neighbours = std::array<int, 2>;

//! [link]
/// Two triangles cross along one piece of a line, which has two ends.
std::vector<Neighbours> link(const std::vector<End>& ends, std::size_t piercings)
{
    std::vector<Neighbours> next(piercings, {-1, -1});
    const auto add = [&](int from, int to) {
        Neighbours& of = next[from];
        (of[0] < 0 ? of[0] : of[1]) = to;
    };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (ends[i].faces() == ends[i + 1].faces()) {
            add(ends[i].piercing, ends[i + 1].piercing);
            add(ends[i + 1].piercing, ends[i].piercing);
        }
    return next;
}
//! [link]

//! [walk]
/// From a piercing on, until the curve comes back or ends.
IntersectionCurve walk(int first, const std::vector<Neighbours>& next, std::vector<bool>& passed)
{
    IntersectionCurve curve;
    for (int now = first; now >= 0;) {
        curve.piercings.push_back(now);
        passed[now] = true;
        const auto [one, other] = next[now];
        const auto is_free = [&](int piercing) { return piercing >= 0 && !passed[piercing]; };
        if (!is_free(one) && !is_free(other))
            curve.closed = curve.piercings.size() > 2 && (one == first || other == first);
        now = is_free(one) ? one : is_free(other) ? other : -1;
    }
    return curve;
}
//! [walk]

}  // namespace

//! [join]
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
//! [join]

Intersection trace_intersection(const StillSurface& a, const StillSurface& b)
{
    return join_piercings(find_piercings(a, b), a, b);
}

}  // namespace enduring
