#include "exercises/08_contact_by_distance/4_hand_on.hpp"

#include <algorithm>

namespace enduring {

double depth_of(const FacePlane& face, const Vec3& vertex) { return face.normal.dot(vertex - face.point); }

double compression_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    return std::min(0.0, depth_of(face, vertex) - spring.rest_offset);
}

Vec3 force_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex)
{
    return -spring.stiffness * (compression_of(spring, face, vertex) * face.normal + spring.stretch);
}

Vec3 turned_along(const Vec3& from, const Vec3& to, const Vec3& vector)
{
    const Vec3 axis = from.cross(to);
    const double cosine = from.dot(to);
    return cosine * vector + axis.cross(vector) + axis.dot(vector) / (1 + cosine) * axis;
}

std::optional<PairSpring> handed_on(const PairSpring& spring, const FacePlane& from, const FacePlane& to,
                                    const Vec3& vertex, double least_cosine)
{
    if (from.normal.dot(to.normal) < least_cosine)
        return std::nullopt;
    PairSpring next = spring;
    next.rest_offset = std::min(0.0, depth_of(to, vertex) - compression_of(spring, from, vertex));
    next.stretch = turned_along(from.normal, to.normal, spring.stretch);
    return next;
}

std::optional<PairSpring> after_tour(PairSpring spring, const std::vector<FacePlane>& faces,
                                     const std::vector<Vec3>& places, double least_cosine)
{
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        const auto next = handed_on(spring, faces[i], faces[i + 1], places[i], least_cosine);
        if (!next)
            return std::nullopt;
        spring = *next;
    }
    return spring;
}

}  // namespace enduring
