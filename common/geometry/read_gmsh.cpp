#include "common/geometry/read_gmsh.hpp"

#include "common/geometry/element_quality.hpp"
#include "common/geometry/gmsh_binary.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/input/input_error.hpp"
#include "common/input/input_file.hpp"
#include "common/input/text_lines.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>

namespace enduring {
namespace {

constexpr long four_node_tetrahedron = 4, ten_node_tetrahedron = 11;
/// Gmsh lists the last two edges of a 10-node tetrahedron as 23, 13; ours are 13, 23.
constexpr std::array<std::size_t, 10> place_in_file{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};

/// The file as it stands: nodes in their order, elements of one type with 4 or 10 of those nodes.
struct GmshContent {
    bool in_blocks = false;  ///< as version 4.1 has it: a head for each block of nodes or elements
    std::vector<Vec3> nodes;
    std::map<long, int> node_of_number;
    long type = 0;
    std::vector<std::array<int, 10>> elements;  ///< the last six are -1 for 4-node elements
    GmshGroups groups{};
};

bool goes_on(TextLines& lines, const std::string& end)
{
    if (!lines.next())
        lines.fail("the file ends where " + end + " is missing");
    return lines.line() != end;
}

void read_format(TextLines& lines, GmshContent& content)
{
    if (!goes_on(lines, "$EndMeshFormat"))
        lines.fail("$MeshFormat is empty");
    const std::string version(lines.next_word());
    if (version != "2.2" && version != "4.1")
        lines.fail("Gmsh format " + TextLines::quoted(version) +
                   " is not supported; save the mesh as version 4.1 or 2.2");
    content.in_blocks = version == "4.1";
    if (lines.next_integer("file type") != 0)
        lines.fail("the file type is neither 0, text, nor 1, binary");
    if (goes_on(lines, "$EndMeshFormat"))
        lines.fail("$EndMeshFormat expected");
}

/// Reads one section: a count, then that many lines. What the file really holds
/// decides how much is stored, never the count alone.
template <class ReadLine>
void read_counted(TextLines& lines, const std::string& section, const ReadLine& read_line)
{
    const std::string end = "$End" + section;
    if (!goes_on(lines, end))
        lines.fail("the count of $" + section + " is missing");
    const long count = lines.next_integer("count");
    if (count < 1)
        lines.fail("$" + section + " holds " + std::to_string(count) + " entries; at least one is needed");
    long entries = 0;
    for (; goes_on(lines, end); ++entries) {
        if (entries == count)
            lines.fail("$" + section + " promises " + std::to_string(count) + " entries and goes on");
        read_line();
    }
    if (entries < count)
        lines.fail("$" + section + " promises " + std::to_string(count) + " entries and ends after " +
                   std::to_string(entries));
}

/// Reads one section of version 4.1: the counts of blocks and entries, then for each block a line with its
/// entity, one number of its own and the count of its entries, and these.
/// @param read_block  is given the dimension and number of the entity, that number and that count
template <class ReadBlock>
void read_blocks(TextLines& lines, const std::string& section, const ReadBlock& read_block)
{
    const std::string end = "$End" + section;
    if (!goes_on(lines, end))
        lines.fail("the counts of $" + section + " are missing");
    const long blocks = lines.next_integer("count of blocks"), entries = lines.next_integer("count");
    if (blocks < 0 || entries < 0)
        lines.fail("$" + section + " has a count of " + std::to_string(std::min(blocks, entries)) +
                   ", below zero");
    long blocks_read = 0, entries_read = 0;
    for (; goes_on(lines, end); ++blocks_read) {
        if (blocks_read == blocks)
            lines.fail("$" + section + " promises " + std::to_string(blocks) + " blocks and goes on");
        const long dimension = lines.next_integer("dimension of the entity");
        const long entity = lines.next_integer("entity");
        const long own = lines.next_integer("number of the block"), count = lines.next_integer("count");
        if (count < 0)
            lines.fail("a block of " + std::to_string(count) + " entries");
        read_block(dimension, entity, own, count);
        entries_read += count;
    }
    if (blocks_read < blocks || entries_read != entries)
        lines.fail("$" + section + " promises " + std::to_string(entries) + " entries in " +
                   std::to_string(blocks) + " blocks and has " + std::to_string(entries_read) + " in " +
                   std::to_string(blocks_read));
}

/// The next line of a block that promises it.
void next_of_block(TextLines& lines, const std::string& section)
{
    if (!goes_on(lines, "$End" + section))
        lines.fail("a block of $" + section + " ends before it has what it promises");
}

void append_node(TextLines& lines, long number, GmshContent& content)
{
    Vec3 x;
    for (double& coordinate : x)
        coordinate = lines.next_finite_number("coordinate");
    const int index = static_cast<int>(content.nodes.size());
    if (!content.node_of_number.emplace(number, index).second)
        lines.fail("node " + std::to_string(number) + " is given twice");
    content.nodes.push_back(x);
}

/// All numbers of a block's nodes, then all of their coordinates, a node a line.
void read_node_block(TextLines& lines, long count, GmshContent& content)
{
    std::vector<long> numbers;
    for (long i = 0; i < count; ++i) {
        next_of_block(lines, "Nodes");
        numbers.push_back(lines.next_integer("node number"));
    }
    for (const long number : numbers) {
        next_of_block(lines, "Nodes");
        append_node(lines, number, content);
    }
}

/// Positions of an element's nodes, in our order.
template <std::size_t N>
std::array<Vec3, N> positions_of(const GmshContent& content, const std::array<int, 10>& element)
{
    std::array<Vec3, N> x;
    for (std::size_t i = 0; i < N; ++i)
        x[i] = content.nodes[element[i]];
    return x;
}

/// Whether the element is a tetrahedron, and of the same kind as those before it; false if it bounds or marks
/// the solid.
bool is_wanted(TextLines& lines, const std::string& name, long type, GmshContent& content)
{
    const GmshElementType kind = gmsh_element_type(type);
    if (kind.corners > 0 && kind.dimension < 3)
        return false;
    if (type != four_node_tetrahedron && type != ten_node_tetrahedron)
        lines.fail(name + " is of type " + std::to_string(type) +
                   "; of solid elements only tetrahedra (4 and 11) can be read");
    if (content.type != 0 && content.type != type)
        lines.fail(name + " has another number of nodes than the tetrahedra before it");
    content.type = type;
    return true;
}

/// Of a node of an element, in the file.
int place_of(TextLines& lines, const std::string& name, long node, const GmshContent& content)
{
    const auto found = content.node_of_number.find(node);
    if (found == content.node_of_number.end())
        lines.fail(name + " names node " + std::to_string(node) + ", which does not exist");
    return found->second;
}

/// The nodes of a tetrahedron, to the end of the line.
void append_tetrahedron(TextLines& lines, const std::string& name, GmshContent& content)
{
    std::array<int, 10> element;
    element.fill(-1);
    const std::size_t count = content.type == four_node_tetrahedron ? 4 : 10;
    for (std::size_t i = 0; i < count; ++i) {
        const long node = lines.next_integer("node");
        const int place = place_of(lines, name, node, content);
        if (std::find(element.begin(), element.end(), place) != element.end())
            lines.fail(name + " names node " + std::to_string(node) + " twice");
        element[place_in_file[i]] = place;
    }
    if (!lines.next_word().empty())
        lines.fail(name + " names too many nodes");
    const std::string fault = count == 4 ? element_fault(positions_of<4>(content, element))
                                         : element_fault(positions_of<10>(content, element));
    if (!fault.empty())
        lines.fail(name + " " + fault);
    content.elements.push_back(element);
}

std::string next_element_name(TextLines& lines)
{
    return "element " + std::to_string(lines.next_integer("element number"));
}

/// The nodes of an element, to the end of the line where it is a tetrahedron.
/// @param groups  physical ones that it belongs to
void read_element_nodes(TextLines& lines, const std::string& name, long type, std::span<const long> groups,
                        GmshContent& content)
{
    const GmshElementType kind = gmsh_element_type(type);
    std::vector<int> corners;
    if (is_wanted(lines, name, type, content)) {
        append_tetrahedron(lines, name, content);
        corners.assign(content.elements.back().begin(), content.elements.back().begin() + 4);
    } else if (std::any_of(groups.begin(), groups.end(),
                           [&](long group) { return content.groups.is_named(kind.dimension, group); })) {
        corners.reserve(static_cast<std::size_t>(kind.corners));
        for (int i = 0; i < kind.corners; ++i)
            corners.push_back(place_of(lines, name, lines.next_integer("node"), content));
    }
    for (const long group : groups)
        content.groups.add(kind.dimension, group, corners);
}

/// Version 2.2 has the physical group as the first tag of an element, 0 for none.
void read_element(TextLines& lines, GmshContent& content)
{
    const std::string name = next_element_name(lines);
    const long type = lines.next_integer("element type");
    std::vector<long> groups;
    const long count = lines.next_integer("number of tags");
    if (count < 0)
        lines.fail(name + " has " + std::to_string(count) + " tags, below zero");
    for (long tags = count; tags > 0; --tags) {
        const long tag = lines.next_integer("tag");
        if (groups.empty())
            groups.push_back(tag);
    }
    read_element_nodes(lines, name, type, groups, content);
}

void read_element_block(TextLines& lines, std::span<const long> groups, long type, long count,
                        GmshContent& content)
{
    for (long i = 0; i < count; ++i) {
        next_of_block(lines, "Elements");
        const std::string name = next_element_name(lines);
        read_element_nodes(lines, name, type, groups, content);
    }
}

void read_nodes(TextLines& lines, GmshContent& content)
{
    if (content.in_blocks)
        read_blocks(lines, "Nodes",
                    [&](long, long, long, long count) { read_node_block(lines, count, content); });
    else
        read_counted(lines, "Nodes", [&] { append_node(lines, lines.next_integer("node number"), content); });
}

void read_elements(TextLines& lines, GmshContent& content)
{
    if (content.in_blocks)
        read_blocks(lines, "Elements", [&](long dimension, long entity, long type, long count) {
            const std::vector<long> groups = content.groups.groups_of(static_cast<int>(dimension), entity);
            read_element_block(lines, groups, type, count, content);
        });
    else
        read_counted(lines, "Elements", [&] { read_element(lines, content); });
}

GmshContent read_gmsh_content(TextLines& lines)
{
    GmshContent content;
    bool format_known = false;
    while (lines.next()) {
        const std::string section(lines.line());
        if (section[0] != '$')
            lines.fail("a section such as $Nodes expected");
        if (section != "$MeshFormat" && !format_known)
            lines.fail("not a Gmsh file: it does not start with $MeshFormat");
        if (section == "$MeshFormat") {
            read_format(lines, content);
            format_known = true;
        } else if (section == "$Nodes") {
            read_nodes(lines, content);
        } else if (section == "$Elements") {
            read_elements(lines, content);
        } else if (section == "$PhysicalNames") {
            content.groups.read_names(lines);
        } else if (section == "$Entities" && content.in_blocks) {
            content.groups.read_entities(lines);
        } else {
            while (goes_on(lines, "$End" + section.substr(1))) {}
        }
    }
    if (content.elements.empty())
        lines.fail("the file ends without a tetrahedron");
    return content;
}

/// Renumbers the nodes that elements use: corners first, then the
/// middles of edges, each in the order of the file.
/// @param renumbered  is told the new number of each place in the file, -1 for none
QuadraticTetrahedralMesh compact(const GmshContent& content, std::vector<int>& renumbered)
{
    enum Use { unused, middle, corner };
    std::vector<Use> use(content.nodes.size(), unused);
    for (const auto& element : content.elements)
        for (std::size_t i = 0; i < 10 && element[i] >= 0; ++i) {
            Use& of_node = use[element[i]];
            of_node = std::max(of_node, i < 4 ? corner : middle);
        }
    QuadraticTetrahedralMesh mesh;
    renumbered.assign(content.nodes.size(), -1);
    for (Use wanted : {corner, middle}) {
        for (std::size_t n = 0; n < use.size(); ++n)
            if (use[n] == wanted) {
                renumbered[n] = static_cast<int>(mesh.nodes.size());
                mesh.nodes.push_back(content.nodes[n]);
            }
        if (wanted == corner)
            mesh.corner_count = static_cast<int>(mesh.nodes.size());
    }
    for (std::array<int, 10> element : content.elements) {
        for (int& node : element)
            node = node < 0 ? -1 : renumbered[node];
        mesh.elements.push_back(element);
    }
    return mesh;
}

/// Of a binary file the text is read that Gmsh would have saved.
GmshContent read_content(std::istream& stream, const std::string& name)
{
    const std::string bytes(std::istreambuf_iterator<char>(stream), {});
    const bool is_binary = is_binary_gmsh(bytes);
    std::istringstream text(is_binary ? gmsh_as_text(bytes, name) : bytes);
    TextLines lines(text, is_binary ? name + ", as text" : name);
    return read_gmsh_content(lines);
}

}  // namespace

GmshSolid read_gmsh_with_groups(std::istream& stream, const std::string& name)
{
    const GmshContent content = read_content(stream, name);
    std::vector<int> renumbered;
    const QuadraticTetrahedralMesh mesh = compact(content, renumbered);
    return {corners_of(mesh), content.groups.on_nodes(renumbered, mesh.corner_count)};
}

TetrahedralMesh read_gmsh(std::istream& stream, const std::string& name)
{
    return read_gmsh_with_groups(stream, name).mesh;
}

QuadraticTetrahedralMesh read_gmsh_quadratic(std::istream& stream, const std::string& name)
{
    const GmshContent content = read_content(stream, name);
    std::vector<int> renumbered;
    QuadraticTetrahedralMesh mesh = compact(content, renumbered);
    return content.type == ten_node_tetrahedron ? mesh : with_edge_midpoints(corners_of(mesh));
}

TetrahedralMesh read_gmsh(const std::filesystem::path& file) { return read_gmsh_with_groups(file).mesh; }

GmshSolid read_gmsh_with_groups(const std::filesystem::path& file)
{
    std::ifstream stream = open_file(file);
    return read_gmsh_with_groups(stream, file.string());
}

QuadraticTetrahedralMesh read_gmsh_quadratic(const std::filesystem::path& file)
{
    std::ifstream stream = open_file(file);
    return read_gmsh_quadratic(stream, file.string());
}

}  // namespace enduring
