#include "common/scenes/region_reader.hpp"

#include "common/geometry/sort_once.hpp"

#include <algorithm>
#include <limits>

namespace enduring {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A box and a ball in the shape's coordinates: the points in both.
struct Region {
    Vec3 low, high, centre = Vec3::Zero();
    double radius = infinity;
    bool contains(const Vec3& point) const
    {
        return (point.array() >= low.array()).all() && (point.array() <= high.array()).all() &&
               !((point - centre).norm() > radius);
    }
};

Region read_box_and_ball(const JsonValue& value)
{
    const NumberRange coordinate{-1e6, 1e6, true, true, "m"};
    Region region{value.vector_or("min", coordinate, Vec3::Constant(-infinity)),
                  value.vector_or("max", coordinate, Vec3::Constant(infinity))};
    if (const std::optional<JsonValue> ball = value.find("ball")) {
        ball->require_keys({"centre", "radius"});
        region.centre = ball->at("centre").vector(coordinate);
        region.radius = ball->at("radius").number({0, 1e6, true, true, "m"});
    }
    return region;
}

const std::vector<int>& nodes_of_group(const JsonValue& name, const NodeGroups& groups)
{
    const auto found = groups.find(name.text());
    if (found != groups.end())
        return found->second.nodes;
    std::string known;
    for (const auto& [other, group] : groups)
        known += (known.empty() ? "it has \"" : ", \"") + other + '"';
    name.complain("the shape has no group \"" + name.text() + "\"; " +
                  (known.empty() ? "only a Gmsh file with physical groups has some" : known));
}

}  // namespace

bool gives_region(const JsonValue& value)
{
    return std::any_of(std::begin(region_keys), std::end(region_keys),
                       [&](std::string_view key) { return value.find(std::string(key)).has_value(); });
}

NamedNodes NamedNodes::of(const TetrahedralMesh& mesh, const NodeGroups& groups)
{
    return {mesh.nodes, groups};
}

NamedNodes NamedNodes::of(const QuadraticTetrahedralMesh& mesh, const NodeGroups& groups)
{
    NamedNodes named{mesh.nodes, groups};
    for (auto& [name, group] : named.groups) {
        for (const std::array<int, 10>& element : mesh.elements)
            for (std::size_t e = 0; e < tetrahedron_edges.size(); ++e) {
                const auto [i, j] = tetrahedron_edges[e];
                const auto [a, b] = std::minmax(element[static_cast<std::size_t>(i)],
                                                element[static_cast<std::size_t>(j)]);
                if (std::binary_search(group.edges.begin(), group.edges.end(), Edge{a, b}))
                    group.nodes.push_back(element[4 + e]);
            }
        sort_once(group.nodes);
    }
    return named;
}

std::vector<int> read_region(const JsonValue& value, const NamedNodes& of_body)
{
    const Region region = read_box_and_ball(value);
    const std::optional<JsonValue> group = value.find("group");
    const std::vector<int>* of_group = group ? &nodes_of_group(*group, of_body.groups) : nullptr;
    std::vector<int> inside;
    for (std::size_t node = 0; node < of_body.nodes.size(); ++node)
        if (region.contains(of_body.nodes[node]) &&
            (!of_group || std::binary_search(of_group->begin(), of_group->end(), static_cast<int>(node))))
            inside.push_back(static_cast<int>(node));
    if (inside.empty())
        value.complain("no node of the shape lies in this region");
    return inside;
}

}  // namespace enduring
