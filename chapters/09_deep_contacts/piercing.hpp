#pragma once

#include "chapters/02_collision_detection/face_tree.hpp"

#include <vector>

namespace enduring {

/// A difference of two points that is not rounded: it stays the two.
struct Difference {
    const Vec3 &to, &from;
};

/// Sign of (x + shift e) . (v x w) with e = (eps, eps^2, eps^3) and an eps above 0 and below every number:
/// the sign of x . (v x w) where that is not zero, else that of the first coordinate of v x w that is not
/// zero.
///
/// Never wrong: what the doubles leave open is computed with whole numbers. Coordinates lie between 1e-40 and
/// 1e40 in size, or are zero.
/// @param shift  1, -1, or 0 for no shift at all
/// @return       1 or -1; 0 only for v and w exactly parallel, or for x in their plane without a shift
/// @see Edelsbrunner and Mücke 1990, for the perturbation; Shewchuk 1997, for the bound of the doubles
int side_of_plane(const Difference& x, const Difference& v, const Difference& w, int shift);

/// A surface at one moment: who is whose neighbour, where the vertices lie [m], and a tree over the faces
/// that was fitted to them.
struct StillSurface {
    const SurfaceTopology& topology;
    std::span<const Vec3> positions;
    const FaceTree& tree;
};

/// An edge of one surface that passes through a face of another one.
struct Piercing {
    bool edge_of_a;  ///< else it is an edge of B, and a face of A
    int edge, face;
    int entry;  ///< 1: from the smaller to the larger vertex it passes the face from the front; -1: from
                ///< behind

    int face_of_a(int face_at_edge) const { return edge_of_a ? face_at_edge : face; }
    int face_of_b(int face_at_edge) const { return edge_of_a ? face : face_at_edge; }
};

/// Whether a segment from p to q passes through the triangle a, b, c: 1 from the front, -1 from behind, 0 not
/// at all. The segment is shifted by less than any number before it is asked (see side_of_plane), so it never
/// only touches: of two triangles with a common edge it passes one or the other, or neither, and none both.
/// @param shift  1 or -1: the same for all segments of one body and the opposite for those of the other one
int pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, int shift);

/// All piercings of two surfaces, of edges of A and of edges of B; always in the same order.
std::vector<Piercing> find_piercings(const StillSurface& a, const StillSurface& b);

/// Where the edge is in the face, but for rounding [m]; for an edge in the plane of the face its middle.
Vec3 point_of(const Piercing& piercing, const StillSurface& a, const StillSurface& b);

/// How often surface B winds around a point of A: 1 inside, 0 outside. It counts the faces that a path
/// upwards to the outside passes, the point shifted as all of A is.
int winding_by_ray(const Vec3& point, const StillSurface& b, int shift);

}  // namespace enduring
