#include "exercises/08_contact_by_distance/4_hand_on.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

double depth_of(const FacePlane& face, const Vec3& vertex)
{
    not_implemented_yet("8.4");
}

double compression_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    not_implemented_yet("8.4");
}

Vec3 force_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    not_implemented_yet("8.4");
}

Vec3 turned_along(const Vec3& from, const Vec3& to, const Vec3& vector)
{
    not_implemented_yet("8.4");
}

std::optional<PairSpring> handed_on(const PairSpring& spring, const FacePlane& from, const FacePlane& to,
                                    const Vec3& vertex, double least_cosine)
{
    not_implemented_yet("8.4");
}

std::optional<PairSpring> after_tour(PairSpring spring, const std::vector<FacePlane>& faces,
                                     const std::vector<Vec3>& places, double least_cosine)
{
    not_implemented_yet("8.4");
}

}  // namespace enduring
