#include "exercises/09_deep_contacts/3_separation_direction.hpp"
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

Vec3 vector_area(const Loop& loop)
{
    not_implemented_yet("9.3");
}

std::optional<Vec3> separation_direction(const std::vector<Loop>& loops, double cancelled)
{
    not_implemented_yet("9.3");
}

Vec3 turning(const Loop& loop, const Vec3& centre)
{
    not_implemented_yet("9.3");
}

}  // namespace enduring
