#include "common/geometry/weld.hpp"

#include "common/geometry/surface_checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace enduring {
namespace {

using Key = std::array<double, 3>;

/// Where the vertices that are kept lie, by the cells of a grid; a cell's edge is four distances, so most
/// points are near the vertices of one cell only.
class KeptVertices {
public:
    explicit KeptVertices(double distance) : distance_(distance) {}

    /// The kept vertex that x belongs to; x itself, as `vertex`, if there is none.
    int find_or_keep(const Vec3& x, int vertex, const std::vector<Vec3>& positions)
    {
        // Of the cells on both sides, which are often the same; not a loop from one to the next: far from the
        // origin, adding 1 to the number of a cell may not change it.
        const std::array<Key, 2> ends{cell(x.array() - distance_), cell(x.array() + distance_)};
        int found = vertex;
        for (const Key& i : ends)
            for (const Key& j : ends)
                for (const Key& k : ends)
                    if (const auto there = cells_.find({i[0], j[1], k[2]}); there != cells_.end())
                        for (const int kept : there->second)
                            if ((positions[kept] - x).norm() <= distance_)
                                found = std::min(found, kept);
        if (found == vertex)
            cells_[cell(x)].push_back(vertex);
        return found;
    }

private:
    Key cell(const Eigen::Array3d& x) const
    {
        const Eigen::Array3d c = (x / (4 * distance_)).floor();
        return {c.x(), c.y(), c.z()};
    }

    double distance_;
    std::map<Key, std::vector<int>> cells_;
};

/// For each vertex the first one with the same coordinates.
std::vector<int> first_equals(const std::vector<Vec3>& positions)
{
    std::map<Key, int> first;
    std::vector<int> same;
    same.reserve(positions.size());
    for (const Vec3& x : positions)
        same.push_back(first.emplace(Key{x.x(), x.y(), x.z()}, static_cast<int>(same.size())).first->second);
    return same;
}

SurfaceMesh merged(const SurfaceMesh& mesh, const std::vector<int>& same)
{
    SurfaceMesh result{mesh.vertices, {}};
    for (const Face& face : mesh.faces) {
        const Face corners{same[face[0]], same[face[1]], same[face[2]]};
        if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
            result.faces.push_back(corners);
    }
    return without_unused_vertices(result);
}

}  // namespace

SurfaceMesh welded(const SurfaceMesh& mesh, double distance)
{
    SurfaceMesh exact = merged(mesh, first_equals(mesh.vertices));
    if (!(distance > 0))
        return exact;
    KeptVertices kept(distance);
    std::vector<int> same;
    for (const Vec3& x : exact.vertices)
        same.push_back(kept.find_or_keep(x, static_cast<int>(same.size()), exact.vertices));
    return merged(exact, same);
}

double weld_distance(const SurfaceMesh& mesh)
{
    if (mesh.vertices.empty())
        return 0;
    Vec3 low = mesh.vertices.front(), high = low;
    for (const Vec3& x : mesh.vertices) {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
    return same_vertex * (high - low).norm();
}

}  // namespace enduring
