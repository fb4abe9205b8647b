#include "exercises/02_collision_detection/3_gliding_edges.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

Times when_between(const Times& times, double at_start, double rate, double low, double high)
{
    not_implemented_yet("2.3");
}

std::optional<double> first_touch_of_gliding_edge(const Vec3& a0, const Vec3& a1, const Vec3& way,
                                                  const Vec3& b0, const Vec3& b1)
{
    not_implemented_yet("2.3");
}

}  // namespace enduring
