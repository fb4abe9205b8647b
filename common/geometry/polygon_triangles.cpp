#include "common/geometry/polygon_triangles.hpp"

#include "common/geometry/surface_checks.hpp"

#include <algorithm>
#include <cstddef>

namespace enduring {
namespace {

/// The area of a polygon times two, along its normal; right for any polygon in a plane, also with dents.
Vec3 doubled_area(const std::vector<int>& corners, const std::vector<Vec3>& x)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += (x[corners[i]] - x[corners[0]]).cross(x[corners[i + 1]] - x[corners[0]]);
    return sum;
}

/// Whether the triangle abc can be cut off: it turns as the polygon does, and holds no other corner of it.
bool is_ear(const Face& ear, const std::vector<int>& corners, const Vec3& normal, const std::vector<Vec3>& x)
{
    const auto left_of = [&](int from, int to, const Vec3& p) {
        return (x[to] - x[from]).cross(p - x[from]).dot(normal);
    };
    const int a = ear[0], b = ear[1], c = ear[2];  // no structured binding: clang 14 captures none
    if (!(left_of(a, b, x[c]) > 0))
        return false;
    return std::none_of(corners.begin(), corners.end(), [&](int other) {
        return other != a && other != b && other != c && left_of(a, b, x[other]) >= 0 &&
               left_of(b, c, x[other]) >= 0 && left_of(c, a, x[other]) >= 0;
    });
}

}  // namespace

bool append_triangles(std::vector<int> corners, const std::vector<Vec3>& x, std::vector<Face>& faces)
{
    const Vec3 normal = doubled_area(corners, x);
    std::size_t refused = 0;
    for (std::size_t i = 0; corners.size() > 3; ++i) {
        const std::size_t count = corners.size(), middle = (i + 1) % count;
        const Face ear{corners[i % count], corners[middle], corners[(i + 2) % count]};
        if (is_ear(ear, corners, normal, x)) {
            faces.push_back(ear);
            corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(middle));
            refused = 0;
        } else if (++refused == count) {
            return false;
        }
    }
    faces.push_back({corners[0], corners[1], corners[2]});
    return true;
}

SurfaceMesh surface_from_polygons(std::vector<Vec3> vertices, const std::vector<std::vector<long>>& polygons,
                                  const std::function<void(long polygon, const std::string& reason)>& fail)
{
    if (polygons.empty())
        fail(-1, "the file has no faces");
    SurfaceMesh mesh{std::move(vertices), {}};
    const long count = static_cast<long>(mesh.vertices.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const long place = static_cast<long>(i);
        std::vector<int> corners;
        for (const long vertex : polygons[i]) {
            if (vertex < 0 || vertex >= count)
                fail(place, "the face names vertex " + std::to_string(vertex) + "; the file has 0 to " +
                                std::to_string(count - 1));
            corners.push_back(static_cast<int>(vertex));
        }
        if (corners.size() < 3)
            fail(place, "a face with " + std::to_string(corners.size()) + " corners; three are needed");
        if (!append_triangles(std::move(corners), mesh.vertices, mesh.faces))
            fail(place, "this polygon cannot be cut into triangles");
    }
    return without_unused_vertices(mesh);
}

}  // namespace enduring
