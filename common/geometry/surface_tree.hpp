#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/geometry/vector.hpp"

#include <unsupported/Eigen/BVH>

#include <span>

namespace enduring {

/// Says where points lie to a surface that stands still: a tree of boxes over
/// its faces, for checks of a scene before it runs.
class SurfaceTree {
public:
    /// @param faces, positions  of the surface [m]; they have to outlive the tree
    SurfaceTree(std::span<const Face> faces, std::span<const Vec3> positions);

    /// Whether a closed surface that faces outwards has the point inside: a ray
    /// from there leaves it once more than it enters.
    /// @param point  on the surface it may be either
    bool contains(const Vec3& point) const { return winding(point) > 0; }

    /// How often a closed surface winds around the point: -1 in one that faces inwards.
    int winding(const Vec3& point) const;

    /// Distance to the nearest face [m].
    double distance(const Vec3& point) const;

    /// Whether the segment passes through a face so that `behind` is where its normal comes from.
    bool is_passed(const Vec3& before, const Vec3& behind) const;

private:
    using Box = Eigen::AlignedBox3d;
    struct Triangle {
        Vec3 a, b, c;
    };
    struct Ray;      ///< counts how often a ray leaves less how often it enters
    struct Nearest;  ///< looks for the face nearest to a point
    struct Segment;  ///< looks for a face that it passes from the front to the back

    Triangle triangle(int face) const;

    std::span<const Face> faces_;
    std::span<const Vec3> positions_;
    Eigen::KdBVH<double, 3, int> tree_;
};

}  // namespace enduring
