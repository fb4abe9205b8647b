#include "exercises/08_contact_by_distance/4_hand_on.hpp"

#include <cmath>

namespace enduring {

double depth_of(const FacePlane& face, const Vec3& vertex)
{
    return vertex.dot(face.normal) - face.point.dot(face.normal);
}

double compression_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    const double depth = depth_of(face, vertex);
    return depth < spring.rest_offset ? depth - spring.rest_offset : 0;
}

Vec3 force_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    const Vec3 push = spring.stiffness * -compression_of(spring, face, vertex) * face.normal;
    return push - spring.stiffness * spring.stretch;
}

Vec3 turned_along(const Vec3& from, const Vec3& to, const Vec3& vector)
{
    const Vec3 axis = from.cross(to);
    if (axis.norm() < 1e-15)
        return vector;
    return Eigen::AngleAxisd(std::atan2(axis.norm(), from.dot(to)), axis.normalized()) * vector;
}

std::optional<PairSpring> handed_on(const PairSpring& spring, const FacePlane& from, const FacePlane& to,
                                    const Vec3& vertex, double least_cosine)
{
    if (to.normal.dot(from.normal) < least_cosine)
        return std::nullopt;
    const double rest_offset = depth_of(to, vertex) - compression_of(spring, from, vertex);
    return PairSpring{spring.stiffness, rest_offset > 0 ? 0 : rest_offset,
                      turned_along(from.normal, to.normal, spring.stretch)};
}

std::optional<PairSpring> after_tour(PairSpring spring, const std::vector<FacePlane>& faces,
                                     const std::vector<Vec3>& places, double least_cosine)
{
    std::optional<PairSpring> now = spring;
    for (std::size_t i = 1; i < faces.size() && now; ++i)
        now = handed_on(*now, faces[i - 1], faces[i], places[i - 1], least_cosine);
    return now;
}

}  // namespace enduring
