#include "common/fem/tetrahedron_quadrature.hpp"

#include "common/geometry/meshes.hpp"

namespace enduring {
namespace {

/// Four points, each on the line from a corner to the middle of the opposite face.
void add_corner_orbit(double a, double weight, std::vector<QuadraturePoint>& points)
{
    for (int i = 0; i < 4; ++i) {
        points.push_back({Eigen::Vector4d::Constant(a), weight});
        points.back().barycentric[i] = 1 - 3 * a;
    }
}

/// Six points, each on the line between the middles of opposite edges.
void add_edge_orbit(double a, double weight, std::vector<QuadraturePoint>& points)
{
    for (const auto& [i, j] : tetrahedron_edges) {
        points.push_back({Eigen::Vector4d::Constant(a), weight});
        points.back().barycentric[i] = points.back().barycentric[j] = 0.5 - a;
    }
}

}  // namespace

const std::vector<QuadraturePoint>& degree_five_quadrature()
{
    static const std::vector<QuadraturePoint> rule = [] {
        std::vector<QuadraturePoint> points;
        add_corner_orbit(0.31088591926330060980, 0.11268792571801585080, points);
        add_corner_orbit(0.092735250310891226402, 0.073493043116361949544, points);
        add_edge_orbit(0.045503704125649649492, 0.042546020777081466438, points);
        return points;
    }();
    return rule;
}

}  // namespace enduring
