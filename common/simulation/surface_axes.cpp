#include "common/simulation/surface_axes.hpp"

namespace enduring {

//! [surface_axes]
std::optional<Mat3> surface_axes(const Vec3& side_1, const Vec3& side_2)
{
    const Vec3 one = side_1.stableNormalized(), other = side_2.stableNormalized();
    const Vec3 normal = one.cross(other).stableNormalized(), along = (one + other).stableNormalized();
    if (normal.isZero(0) || along.isZero(0))
        return std::nullopt;
    Mat3 axes;
    axes << along, normal, along.cross(normal);
    return axes;
}
//! [surface_axes]

}  // namespace enduring
