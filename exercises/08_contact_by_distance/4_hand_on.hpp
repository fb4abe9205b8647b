#pragma once

#include "common/geometry/vector.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// The plane of a face, farther out by the skins of both bodies.
struct FacePlane {
    Vec3 point, normal;  ///< some point of it [m]; unit length, out of the body
};

/// What a pair of a vertex and a face remembers.
struct PairSpring {
    double stiffness;    ///< [N/m]
    double rest_offset;  ///< depth at which it pushes nothing, not positive [m]
    Vec3 stretch;        ///< of friction, along the face [m]
};

/// Depth of a vertex: negative inside [m].
double depth_of(const FacePlane& face, const Vec3& vertex);

/// Depth less rest offset where that is negative, and else 0: what the spring is compressed by, not positive
/// [m].
double compression_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex);

/// Force on the vertex [N]: along the normal that of the compression, along the face that of the stretch.
Vec3 force_of(const PairSpring& spring, const FacePlane& face, const Vec3& vertex);

/// A vector turned as the shortest turn does that takes one normal to the other one. The two are not
/// opposite.
Vec3 turned_along(const Vec3& from, const Vec3& to, const Vec3& vector);

/// The spring at another face which takes over from this one: as stiff, as compressed (if the vertex is deep
/// enough for that; else with no rest offset), and its stretch turned. None if the cosine of the angle of the
/// two normals is below the limit.
std::optional<PairSpring> handed_on(const PairSpring& spring, const FacePlane& from, const FacePlane& to,
                                    const Vec3& vertex, double least_cosine);

/// The spring after a tour over some faces, in order, of a vertex that is at `places[i]` when it goes from
/// face i to the next one. None if one of them does not take over.
std::optional<PairSpring> after_tour(PairSpring spring, const std::vector<FacePlane>& faces,
                                     const std::vector<Vec3>& places, double least_cosine);

}  // namespace enduring
