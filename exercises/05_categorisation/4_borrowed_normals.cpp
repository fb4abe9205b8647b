#include "exercises/05_categorisation/4_borrowed_normals.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

/// What one hooked vertex borrows. The search goes out in rings: all neighbours, then all theirs, and stops
/// at the first ring with a regular vertex in it.
/// @param place  of a vertex in `buried`, -1 for one that is not buried
/// @param start  the hooked vertex, its place in `buried`
static std::optional<Vec3> borrowed_by(const SurfaceTopology& surface, std::span<const BuriedVertex> buried,
                                       const std::vector<int>& place, int start)
{
    not_implemented_yet("5.4");
}

std::vector<std::optional<Vec3>> borrowed_normals(const SurfaceTopology& surface,
                                                  std::span<const BuriedVertex> buried)
{
    not_implemented_yet("5.4");
}

}  // namespace enduring
