#include "common/geometry/surface_tree.hpp"

#include "common/geometry/triangle_distance.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace enduring {
namespace {

/// Where the line from `point` along `direction` meets the plane of a
/// triangle, in units of `direction`; infinite beside it.
double meeting(const Vec3& point, const Vec3& direction, Vec3 a, Vec3 b, Vec3 c)
{
    a -= point;
    b -= point;
    c -= point;
    const double u = direction.dot(a.cross(b)), v = direction.dot(b.cross(c)), w = direction.dot(c.cross(a));
    const bool hit = (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    const Vec3 normal = (b - a).cross(c - a);
    const double across = direction.dot(normal);
    return hit && across != 0 ? a.dot(normal) / across : std::numeric_limits<double>::infinity();
}

}  // namespace

struct SurfaceTree::Ray {
    const SurfaceTree& tree;
    Vec3 point;
    int winding = 0;

    /// No mesh that somebody made by hand has edges in the way of this one.
    static Vec3 direction() { return {0.48157, 0.79323, 0.37281}; }

    bool intersectVolume(const Box& box)
    {
        const Vec3 to_low = (box.min() - point).cwiseQuotient(direction()),
                   to_high = (box.max() - point).cwiseQuotient(direction());
        const double leaves = to_high.minCoeff();  // all of the direction's parts are positive
        return leaves >= 0 && to_low.maxCoeff() <= leaves;
    }
    bool intersectObject(int face)
    {
        const auto [a, b, c] = tree.triangle(face);
        const double at = meeting(point, direction(), a, b, c);
        if (at >= 0 && std::isfinite(at))
            winding += direction().dot((b - a).cross(c - a)) > 0 ? 1 : -1;
        return false;  // go through all
    }
};

struct SurfaceTree::Nearest {
    using Scalar = double;
    const SurfaceTree& tree;
    Vec3 point;

    double minimumOnVolume(const Box& box) const { return box.exteriorDistance(point); }
    double minimumOnObject(int face) const
    {
        const auto [a, b, c] = tree.triangle(face);
        return distance_to_triangle(point, a, b, c);
    }
};

struct SurfaceTree::Segment {
    const SurfaceTree& tree;
    Vec3 before, behind;
    bool found = false;

    bool intersectVolume(const Box& box) const
    {
        return box.intersects(Box(before.cwiseMin(behind), before.cwiseMax(behind)));
    }
    bool intersectObject(int face)
    {
        const auto [a, b, c] = tree.triangle(face);
        const double at = meeting(before, behind - before, a, b, c);
        found = at >= 0 && at <= 1 && (behind - before).dot((b - a).cross(c - a)) < 0;
        return found;
    }
};

SurfaceTree::SurfaceTree(std::span<const Face> faces, std::span<const Vec3> positions)
    : faces_(faces), positions_(positions)
{
    std::vector<int> numbers(faces.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<Box> boxes;
    for (const int face : numbers) {
        const auto [a, b, c] = triangle(face);
        boxes.push_back(Box(a).extend(b).extend(c));
    }
    tree_.init(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

SurfaceTree::Triangle SurfaceTree::triangle(int face) const
{
    const auto& [a, b, c] = faces_[face];
    const auto at = [&](int vertex) -> const Vec3& { return positions_[vertex]; };
    return {at(a), at(b), at(c)};
}

int SurfaceTree::winding(const Vec3& point) const
{
    Ray ray{*this, point};
    Eigen::BVIntersect(tree_, ray);
    return ray.winding;
}

double SurfaceTree::distance(const Vec3& point) const
{
    Nearest nearest{*this, point};
    return Eigen::BVMinimize(tree_, nearest);
}

bool SurfaceTree::is_passed(const Vec3& before, const Vec3& behind) const
{
    Segment segment{*this, before, behind};
    Eigen::BVIntersect(tree_, segment);
    return segment.found;
}

}  // namespace enduring
