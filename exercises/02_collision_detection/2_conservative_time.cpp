#include "exercises/02_collision_detection/2_conservative_time.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

static double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b)
{
    not_implemented_yet("2.2");
}

double distance_to_triangle(const Vec3& point, const Vec3& f0, const Vec3& f1, const Vec3& f2)
{
    not_implemented_yet("2.2");
}

double fastest_approach(const VertexFaceStep& step)
{
    not_implemented_yet("2.2");
}

std::optional<double> conservative_time(const VertexFaceStep& step, double gap, double close)
{
    not_implemented_yet("2.2");
}

}  // namespace enduring
