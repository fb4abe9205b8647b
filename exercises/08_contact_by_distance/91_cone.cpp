#include "exercises/08_contact_by_distance/91_cone.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

bool in_cone(const Vec3& x, const std::vector<Vec3>& neighbours, const Vec3& d, double sine)
{
    not_implemented_yet("8.91");
}

bool in_cone_of_edge(const Vec3& a, const Vec3& b, const Vec3& left, const Vec3& right, const Vec3& d,
                     double sine)
{
    not_implemented_yet("8.91");
}

std::vector<Push> one_of_each_line(std::vector<Push> pushes, double apart)
{
    not_implemented_yet("8.91");
}

}  // namespace enduring
