#pragma once

#include "common/geometry/surface_topology.hpp"
#include "common/input/text_lines.hpp"

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace enduring {

/// Nodes of a solid mesh that stand under one name: corners of its elements, and the edges whose middles
/// belong to them.
struct NodeGroup {
    std::vector<int> nodes;   ///< ascending, each once
    std::vector<Edge> edges;  ///< the same
};
using NodeGroups = std::map<std::string, NodeGroup>;

/// The physical groups of a Gmsh file while it is read: their names, and the elements of any dimension that
/// are in them.
class GmshGroups {
public:
    /// The section $PhysicalNames: a count, then dimension, number and name of each group.
    void read_names(TextLines& lines);
    /// The section $Entities of version 4.1, which tells the groups of each entity.
    void read_entities(TextLines& lines);

    /// Whether an element that begins here belongs to a group with a name.
    bool is_named(int dimension, long group) const { return names_.contains({dimension, group}); }
    /// In version 4.1 an entity has any number of groups.
    std::vector<long> groups_of(int dimension, long entity) const;
    /// @param corners  of the element, by their places in the file
    void add(int dimension, long group, std::span<const int> corners);

    /// @param renumbered  the node of the solid mesh for each place in the file, or one from `count` on, or
    ///     -1
    NodeGroups on_nodes(std::span<const int> renumbered, int count) const;

private:
    using Key = std::pair<int, long>;  ///< dimension, and number of a group or an entity
    std::map<Key, std::string> names_;
    std::map<Key, std::vector<long>> groups_of_entity_;
    NodeGroups by_place_;
};

/// Of an element type of Gmsh: dimension, and how many corners it has; no corners for a type that is not
/// known.
struct GmshElementType {
    int dimension = 0, corners = 0;
};
GmshElementType gmsh_element_type(long type);

}  // namespace enduring
