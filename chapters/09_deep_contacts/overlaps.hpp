#pragma once

#include "chapters/09_deep_contacts/intersection_curve.hpp"

namespace enduring {

/// The parts into which the curves of an intersection cut the vertices of one surface.
struct SurfaceRegions {
    std::vector<int> region_of_vertex;
    /// of each region: how often the other surface winds around it, 1 inside and 0 outside
    std::vector<int> winding;

    int winding_of_vertex(int vertex) const { return winding[region_of_vertex[vertex]]; }
};

/// Floods a surface from vertex to vertex along the edges that nothing pierces: that is a region. Its first
/// vertex asks with a ray on which side all of them lie.
/// @param piercings    of A and B, from find_piercings
/// @param of_a         whether the regions of A are wanted, else those of B
/// @see Baraff, Witkin and Kass 2003, "Untangling cloth"
SurfaceRegions flood_regions(const std::vector<Piercing>& piercings, const StillSurface& a,
                             const StillSurface& b, bool of_a);

/// A volume that two bodies share: the vertices of each that lie in it, and the separation direction.
struct Overlap {
    std::vector<int> vertices_of_a, vertices_of_b;
    Vec3 separation_direction =
        Vec3::Zero();  ///< unit length: A leaves B along it, and B leaves A against it
    std::vector<std::vector<Piercing>> curves;  ///< around it, the piercings of each in their order
};

/// The vector area that a curve bounds on A [m^2]: the integral of A's normals over what is inside B there,
/// which by Stokes' theorem is half the sum of r x dr along the curve. It does not depend on where the origin
/// lies.
Vec3 vector_area(const Intersection& intersection, const IntersectionCurve& curve, const StillSurface& a,
                 const StillSurface& b);

/// The normal of the face that is nearest to a point, unit length.
Vec3 nearest_normal(const StillSurface& surface, const Vec3& point);

/// All volumes that two closed surfaces share.
///
/// The separation direction is that in which the volume shrinks fastest: if A moves by a small s, it grows by
/// s times the integral of A's normals over its surface inside B, so against the vector areas of the curves
/// around it. Where those of several curves cancel, as of a beam through a plate, it is against the largest
/// of them. A body that is wholly inside another one has no curve: then it is the one of the shortest path,
/// of those along the normals of the faces that are nearest to its vertices.
std::vector<Overlap> find_overlaps(const StillSurface& a, const StillSurface& b);

/// Where a path from a point inside a surface leaves it.
struct Exit {
    int face = -1;
    std::array<double, 3> weights{};
    double distance = INFINITY;  ///< [m]
};

/// The first face that a straight path passes from behind; none (face -1) where rounding hides it.
Exit find_exit(const StillSurface& surface, const Vec3& point, const Vec3& direction);

}  // namespace enduring
