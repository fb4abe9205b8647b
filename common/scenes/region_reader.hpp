#pragma once

#include "common/geometry/quadratic.hpp"
#include "common/input/json_value.hpp"
#include "common/scenes/shape_reader.hpp"

#include <string_view>
#include <vector>

namespace enduring {

/// The keys of a region, which stand beside others.
inline constexpr std::string_view region_keys[] = {"min", "max", "ball", "group"};
bool gives_region(const JsonValue& value);

/// The nodes of a deformable body where it is not placed, and what stands under a name among them.
struct NamedNodes {
    std::vector<Vec3> nodes;  ///< [m]
    NodeGroups groups;

    static NamedNodes of(const TetrahedralMesh& mesh, const NodeGroups& groups);
    /// The middle of an edge is in the groups of the edge.
    static NamedNodes of(const QuadraticTetrahedralMesh& mesh, const NodeGroups& groups);
};

/// The nodes in all that is given of a box ("min", "max"), a ball and a group, ascending.
/// @throws InputError  there are none, or no such group
std::vector<int> read_region(const JsonValue& value, const NamedNodes& of_body);

}  // namespace enduring
