#include "chapters/08_contact_by_distance/sliding_normal.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {

//! [sliding_normal]
Vec3 sliding_normal(const Vec3& start, const Vec3& end, const Vec3& motion)
{
    const Vec3 before = 2 * start - end;
    const double at_start = start.dot(motion), at_before = before.dot(motion);
    const double part = at_start / (at_start - at_before);  // not a number where the surface is flat
    if (start.dot(end) < distance_parts.hand_on || !(std::abs(part) <= 1))
        return Vec3::Zero();
    return (start + std::max(0.0, part) * (before - start)).normalized();
}
//! [sliding_normal]

}  // namespace enduring
