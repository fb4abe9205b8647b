#include "common/geometry/element_quality.hpp"

#include "common/geometry/meshes.hpp"
#include "common/geometry/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace enduring {
namespace {

std::string describe(const char* fault, double volume)
{
    std::ostringstream text;
    text << fault << " " << volume << " m^3";
    return text.str();
}

/// Determinant of the derivative of the 10-node map, against barycentric coordinates 1 to 3, at one point.
double map_determinant(const std::array<Vec3, 10>& nodes, const std::array<double, 4>& at)
{
    std::array<Vec3, 4> slope;  // against each of the four coordinates, as if they were independent
    for (std::size_t i = 0; i < 4; ++i)
        slope[i] = (4 * at[i] - 1) * nodes[i];
    for (std::size_t e = 0; e < 6; ++e) {
        const auto i = static_cast<std::size_t>(tetrahedron_edges[e][0]),
                   j = static_cast<std::size_t>(tetrahedron_edges[e][1]);
        slope[i] += 4 * at[j] * nodes[4 + e];
        slope[j] += 4 * at[i] * nodes[4 + e];
    }
    return (slope[1] - slope[0]).cross(slope[2] - slope[0]).dot(slope[3] - slope[0]);
}

}  // namespace

double signed_volume(const std::array<Vec3, 4>& x)
{
    return (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) / 6;
}

std::string element_fault(const std::array<Vec3, 4>& nodes)
{
    double longest = 0;
    for (const auto& [i, j] : tetrahedron_edges)
        longest = std::max(longest, (nodes[i] - nodes[j]).norm());
    const double volume = signed_volume(nodes);
    if (!std::isfinite(volume) || !std::isfinite(longest * longest * longest))
        return "is too large for its volume to be a finite number";
    if (std::abs(volume) <= tolerance::least_volume * longest * longest * longest)
        return describe("is flat: its volume is", volume);
    return volume < 0 ? describe("is inverted: its volume is", volume) : "";
}

std::string element_fault(const std::array<Vec3, 10>& nodes)
{
    std::string fault = element_fault(std::array{nodes[0], nodes[1], nodes[2], nodes[3]});
    if (!fault.empty())
        return fault;
    for (std::size_t n = 0; n < 10; ++n) {
        std::array<double, 4> at{};
        if (n < 4)
            at[n] = 1;
        else
            for (int corner : tetrahedron_edges[n - 4])
                at[corner] = 0.5;
        if (!(map_determinant(nodes, at) > 0))
            return "is so curved that it is inverted at its node " + std::to_string(n);
    }
    return "";
}

double smallest_dihedral_angle(const std::array<Vec3, 4>& x)
{
    std::array<Vec3, 4> normals;
    for (std::size_t f = 0; f < 4; ++f) {
        const auto& [a, b, c] = tetrahedron_faces[f];
        const Vec3& origin = x[a];
        normals[f] = (x[b] - origin).cross(x[c] - origin);
    }
    double smallest = 4;
    for (std::size_t f = 0; f < 4; ++f)
        for (std::size_t g = f + 1; g < 4; ++g)
            smallest = std::min(smallest,
                                std::atan2(normals[f].cross(normals[g]).norm(), -normals[f].dot(normals[g])));
    return smallest;
}

}  // namespace enduring
