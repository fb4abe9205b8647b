#include "exercises/08_contact_by_distance/2_nearest_feature.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

namespace enduring {

MeshFeature feature_at(const Face& face, const std::array<double, 3>& weights)
{
    not_implemented_yet("8.2");
}

bool is_locally_nearest(const SurfaceMesh& mesh, const MeshFeature& feature, const Vec3& p, double distance)
{
    not_implemented_yet("8.2");
}

std::vector<PointPair> near_pairs(const SurfaceMesh& mesh, const Vec3& p, double distance)
{
    not_implemented_yet("8.2");
}

int ridges_at(const SurfaceMesh& mesh, int vertex)
{
    not_implemented_yet("8.2");
}

bool has_directions(const SurfaceMesh& mesh, int vertex)
{
    not_implemented_yet("8.2");
}

}  // namespace enduring
