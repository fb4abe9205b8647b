#include "common/experiments/render/stage.hpp"

namespace enduring {

std::vector<Vec3> points_of(const Stage& stage)
{
    std::vector<Vec3> points;
    for (const Drawable& body : stage.bodies)
        points.insert(points.end(), body.positions.begin(), body.positions.end());
    for (const TintedTriangle& triangle : stage.triangles)
        points.insert(points.end(), triangle.corners.begin(), triangle.corners.end());
    for (const Dot& dot : stage.dots)
        points.push_back(dot.point);
    for (const Segment& segment : stage.segments) {
        points.push_back(segment.from);
        points.push_back(segment.to);
    }
    return points;
}

}  // namespace enduring
