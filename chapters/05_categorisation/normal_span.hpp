#pragma once

#include "chapters/02_collision_detection/surface_step.hpp"
#include "common/geometry/tolerances.hpp"

#include <span>
#include <vector>

namespace enduring {

/// A surface at one moment of the step.
struct SurfaceMoment {
    SurfaceStep step;
    double tau = 0;  ///< in [0, 1]

    Vec3 position(int vertex) const  ///< [m]
    {
        return tau == 0 ? step.start(vertex) : lerp(step.start(vertex), step.end(vertex), tau);
    }
    Vec3 face_normal(int face) const  ///< outwards, as long as twice the face's area [m^2]
    {
        const auto [f0, f1, f2] = step.face(face);
        const Vec3 corner = position(f0);
        return (position(f1) - corner).cross(position(f2) - corner);
    }
};

inline SurfaceMoment surface_at(const Body& body, double tau) { return {surface_step(body), tau}; }

//! [any_in_span]
/// Whether `test` holds for a unit normal of the span of a vertex or an edge: for one of its
/// faces, or for their average (thesis 6.2.2). Asks them in turn, the average last, and
/// stops at the first yes. Faces without area are passed over.
///
/// @param faces  topology.faces_around_vertex(v) or topology.faces_at_edge(e); -1 stands for no face
/// @param test   bool(const Vec3& unit_normal)
template <typename Test>
bool any_in_span(const SurfaceMoment& surface, std::span<const int> faces, Test&& test)
{
    Vec3 sum = Vec3::Zero();
    for (const int face : faces) {
        if (face < 0)
            continue;
        Vec3 normal = surface.face_normal(face);
        const double length = normal.norm();
        if (!(length > 0))
            continue;
        normal *= 1 / length;
        if (test(normal))
            return true;
        sum += normal;
    }
    const double length = sum.norm();
    return length > tolerance::cancelled && test(Vec3(sum / length));
}
//! [any_in_span]

/// The unit normals of a span, the average last where there is one. For
/// pictures and checks; the rule itself needs no list.
std::vector<Vec3> normal_span(const SurfaceMoment& surface, std::span<const int> faces);

/// Whether some normal of the span lies within an angle of a direction. True for an empty span: a feature
/// without a surface of its own, a lone particle, can be pushed anywhere.
/// @param direction  any length but zero
/// @param cosine     of the angle
bool span_reaches(const SurfaceMoment& surface, std::span<const int> faces, const Vec3& direction,
                  double cosine);

}  // namespace enduring
