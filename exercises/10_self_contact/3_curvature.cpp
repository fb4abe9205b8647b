#include "exercises/10_self_contact/3_curvature.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

std::optional<Vec3> common_side(const std::vector<Vec3>& normals)
{
    not_implemented_yet("10.3");
}

bool border_crosses_itself(const std::vector<Vec3>& border, const Vec3& direction)
{
    not_implemented_yet("10.3");
}

bool may_touch_itself(const std::vector<Vec3>& normals, const std::vector<Vec3>& border)
{
    not_implemented_yet("10.3");
}

}  // namespace enduring
