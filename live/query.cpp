#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/cubic_roots.hpp"
#include "chapters/03_penalty_impulses/penetration.hpp"
#include "live/figures.hpp"

namespace enduring::live {
namespace {

Vec3 point(const std::array<double, 24>& points, int i)
{
    const auto at = static_cast<std::size_t>(3 * i);
    return {points[at], points[at + 1], points[at + 2]};
}

PairInstant instant(bool edges, const std::array<double, 24>& points, int first)
{
    const PairVertices x{point(points, first), point(points, first + 1), point(points, first + 2),
                         point(points, first + 3)};
    return edges ? edge_edge_instant(x, 1) : vertex_face_instant(x);
}

CertifiedAnswer answer(bool edges, const std::array<double, 24>& points)
{
    const auto p = [&](int i) { return point(points, i); };
    if (edges)
        return certified_answer(EdgeEdgeStep{p(0), p(1), p(2), p(3), p(4), p(5), p(6), p(7)});
    return certified_answer(VertexFaceStep{p(0), p(1), p(2), p(3), p(4), p(5), p(6), p(7)});
}

}  // namespace

Numbers query(bool edges, const std::array<double, 24>& points)
{
    const PairStep step{instant(edges, points, 0), instant(edges, points, 4)};
    const auto [b0, b1, b2, b3] = penetration_depth(contact_normal(step), step).coefficients;
    const CertifiedAnswer found = answer(edges, points);
    Numbers result{found.time.value_or(-1), static_cast<double>(found.stage), b0, b1, b2, b3};
    for (const double root :
         cubic_roots({b0, 3 * (b1 - b0), 3 * (b2 - 2 * b1 + b0), b3 - 3 * b2 + 3 * b1 - b0}, 1e-12))
        if (root >= 0 && root <= 1)
            result.push_back(root);
    return result;
}

}  // namespace enduring::live
