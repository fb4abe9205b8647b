#pragma once

#include "../normal_span.hpp"

namespace enduring::testing {

/// A surface that rests, as a vertex 0 with a fan of faces around it.
struct Corner {
    SurfaceTopology topology;
    std::vector<Vec3> positions;

    SurfaceMoment surface(double tau = 0) const { return {{topology, positions, positions}, tau}; }
    std::span<const int> faces() const { return topology.faces_around_vertex(0); }
};

/// @param rim      around the vertex at the origin, clockwise or not
/// @param outside  some direction that every face of the fan looks to
/// @param closed   the last of the rim joins the first
inline Corner fan(const std::vector<Vec3>& rim, const Vec3& outside, bool closed = true)
{
    Corner corner;
    corner.positions = {Vec3::Zero()};
    corner.positions.insert(corner.positions.end(), rim.begin(), rim.end());
    const int n = static_cast<int>(rim.size());
    const bool turned = rim[0].cross(rim[1]).dot(outside) < 0;
    std::vector<Face> faces;
    for (int i = 0; i < (closed ? n : n - 1); ++i) {
        const int from = 1 + i, to = 1 + (i + 1) % n;
        faces.push_back(turned ? Face{0, to, from} : Face{0, from, to});
    }
    corner.topology = SurfaceTopology(n + 1, faces);
    return corner;
}

}  // namespace enduring::testing
