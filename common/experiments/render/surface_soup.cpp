#include "common/experiments/render/surface_soup.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

const double same_side_of_a_crease = std::cos(40 * std::numbers::pi / 180);

Vec3 area_vector(const Drawable& body, const Face& face)
{
    const auto corner = [&](std::size_t i) -> const Vec3& { return body.positions[face[i]]; };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

}  // namespace

void add_surface(TriangleSoup& soup, const Drawable& body, const Vec3& centre)
{
    std::vector<Vec3> areas;
    std::vector<std::vector<std::size_t>> around(body.positions.size());
    for (const Face& face : body.faces) {
        for (const int vertex : face)
            around[vertex].push_back(areas.size());
        areas.push_back(area_vector(body, face));
    }
    const auto smooth_normal = [&](std::size_t face, std::size_t vertex) {
        Vec3 sum = Vec3::Zero();
        for (const std::size_t other : around[vertex])
            if (areas[face].dot(areas[other]) >=
                same_side_of_a_crease * areas[face].norm() * areas[other].norm())
                sum += areas[other];
        return sum;
    };
    for (std::size_t f = 0; f < body.faces.size(); ++f)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto vertex = static_cast<std::size_t>(body.faces[f][i]);
            const Vec3 normal = body.smooth ? smooth_normal(f, vertex) : areas[f];
            soup.push_back({(body.positions[vertex] - centre).cast<float>(),
                            normal.normalized().cast<float>(), body.color.cast<float>(),
                            Vec3::Unit(static_cast<Eigen::Index>(i)).cast<float>()});
        }
}

}  // namespace enduring
