#include "common/geometry/gmsh_groups.hpp"

#include "common/geometry/sort_once.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace enduring {
namespace {

/// The next line of a section, or false at its end.
bool goes_on_to(TextLines& lines, const std::string& end)
{
    if (!lines.next())
        lines.fail("the file ends where " + end + " is missing");
    return lines.line() != end;
}

/// What stands between the first quotation mark of the line and the last.
std::string name_on(const TextLines& lines)
{
    const std::string_view line = lines.line();
    const std::size_t first = line.find('"'), last = line.rfind('"');
    if (first == last)
        lines.fail("the name of a group stands between quotation marks");
    return std::string(line.substr(first + 1, last - first - 1));
}

}  // namespace

GmshElementType gmsh_element_type(long type)
{
    switch (type) {
        case 15: return {0, 1};
        case 1:
        case 8: return {1, 2};
        case 2:
        case 9:
        case 20:
        case 21: return {2, 3};
        case 3:
        case 10:
        case 16: return {2, 4};
        case 4:
        case 11: return {3, 4};
        default: return {};
    }
}

void GmshGroups::read_names(TextLines& lines)
{
    const std::string end = "$EndPhysicalNames";
    if (!goes_on_to(lines, end))
        lines.fail("the count of $PhysicalNames is missing");
    while (goes_on_to(lines, end)) {
        const long dimension = lines.next_integer("dimension of a group"),
                   number = lines.next_integer("number of a group");
        if (dimension < 0 || dimension > 3)
            lines.fail("a group of dimension " + std::to_string(dimension));
        names_[{static_cast<int>(dimension), number}] = name_on(lines);
    }
}

void GmshGroups::read_entities(TextLines& lines)
{
    const std::string end = "$EndEntities";
    if (!goes_on_to(lines, end))
        lines.fail("the counts of $Entities are missing");
    std::array<long, 4> counts{};
    for (long& count : counts)
        if (count = lines.next_integer("count of entities"); count < 0)
            lines.fail("$Entities has a count of " + std::to_string(count) + ", below zero");
    for (int dimension = 0; dimension < 4; ++dimension)
        for (long i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i) {
            if (!goes_on_to(lines, end))
                lines.fail("$Entities ends before it has what it promises");
            std::vector<long>& groups = groups_of_entity_[{dimension, lines.next_integer("entity")}];
            for (int n = dimension == 0 ? 3 : 6; n > 0; --n)
                lines.next_finite_number("coordinate");
            for (long n = lines.next_integer("number of groups"); n > 0; --n)
                groups.push_back(std::abs(lines.next_integer("group")));  // negative: turned over
        }
    if (goes_on_to(lines, end))
        lines.fail("$Entities has more than it promises");
}

std::vector<long> GmshGroups::groups_of(int dimension, long entity) const
{
    const auto found = groups_of_entity_.find({dimension, entity});
    return found == groups_of_entity_.end() ? std::vector<long>{} : found->second;
}

void GmshGroups::add(int dimension, long group, std::span<const int> corners)
{
    const auto name = names_.find({dimension, group});
    if (name == names_.end())
        return;
    NodeGroup& of_name = by_place_[name->second];
    of_name.nodes.insert(of_name.nodes.end(), corners.begin(), corners.end());
    const std::size_t count = corners.size();
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (dimension != 2 || count == 3 || (i - j) % 2 == 1)  // a quadrangle has no edge across
                of_name.edges.push_back({corners[j], corners[i]});
}

NodeGroups GmshGroups::on_nodes(std::span<const int> renumbered, int count) const
{
    const auto node_at = [&](int place) {
        const int node = renumbered[static_cast<std::size_t>(place)];
        return node < count ? node : -1;
    };
    NodeGroups groups;
    for (const auto& [name, by_place] : by_place_) {
        NodeGroup& group = groups[name];
        for (const int place : by_place.nodes)
            if (node_at(place) >= 0)
                group.nodes.push_back(node_at(place));
        for (const auto& [a, b] : by_place.edges)
            if (node_at(a) >= 0 && node_at(b) >= 0)
                group.edges.push_back({std::min(node_at(a), node_at(b)), std::max(node_at(a), node_at(b))});
        sort_once(group.nodes);
        sort_once(group.edges);
    }
    return groups;
}

}  // namespace enduring
