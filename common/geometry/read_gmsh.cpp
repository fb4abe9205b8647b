#include "common/geometry/read_gmsh.hpp"

#include "common/geometry/element_quality.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/input/input_error.hpp"
#include "common/input/text_lines.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>

namespace enduring {
namespace {

constexpr long four_node_tetrahedron = 4, ten_node_tetrahedron = 11;
/// Points, lines, triangles and quadrangles of first and second order: what bounds or marks the solid.
constexpr std::array<long, 10> elements_passed_over{1, 2, 3, 8, 9, 10, 15, 16, 20, 21};
/// Gmsh lists the last two edges of a 10-node tetrahedron as 23, 13; ours are 13, 23.
constexpr std::array<std::size_t, 10> place_in_file{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};

/// The file as it stands: nodes in their order, elements of one type with 4 or 10 of those nodes.
struct GmshContent {
    std::vector<Vec3> nodes;
    std::map<long, int> node_of_number;
    long type = 0;
    std::vector<std::array<int, 10>> elements;  ///< the last six are -1 for 4-node elements
};

bool goes_on(TextLines& lines, const std::string& end)
{
    if (!lines.next())
        lines.fail("the file ends where " + end + " is missing");
    return lines.line() != end;
}

void read_format(TextLines& lines)
{
    if (!goes_on(lines, "$EndMeshFormat"))
        lines.fail("$MeshFormat is empty");
    const std::string version(lines.next_word());
    if (version != "2.2")
        lines.fail("Gmsh format " + TextLines::quoted(version) +
                   " is not supported; save the mesh as version 2.2 ASCII");
    if (lines.next_integer("file type") != 0)
        lines.fail("a binary Gmsh file; save the mesh as version 2.2 ASCII");
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

void read_node(TextLines& lines, GmshContent& content)
{
    const long number = lines.next_integer("node number");
    Vec3 x;
    for (double& coordinate : x)
        coordinate = lines.next_finite_number("coordinate");
    const int index = static_cast<int>(content.nodes.size());
    if (!content.node_of_number.emplace(number, index).second)
        lines.fail("node " + std::to_string(number) + " is given twice");
    content.nodes.push_back(x);
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

void read_element(TextLines& lines, GmshContent& content)
{
    const long number = lines.next_integer("element number");
    const long type = lines.next_integer("element type");
    if (std::find(elements_passed_over.begin(), elements_passed_over.end(), type) !=
        elements_passed_over.end())
        return;
    const std::string name = "element " + std::to_string(number);
    if (type != four_node_tetrahedron && type != ten_node_tetrahedron)
        lines.fail(name + " is of type " + std::to_string(type) +
                   "; of solid elements only tetrahedra (4 and 11) can be read");
    if (content.type != 0 && content.type != type)
        lines.fail(name + " has another number of nodes than the tetrahedra before it");
    content.type = type;

    for (long tags = lines.next_integer("number of tags"); tags > 0; --tags)
        lines.next_integer("tag");
    std::array<int, 10> element;
    element.fill(-1);
    const std::size_t count = type == four_node_tetrahedron ? 4 : 10;
    for (std::size_t i = 0; i < count; ++i) {
        const long node = lines.next_integer("node");
        const auto found = content.node_of_number.find(node);
        if (found == content.node_of_number.end())
            lines.fail(name + " names node " + std::to_string(node) + ", which does not exist");
        if (std::find(element.begin(), element.end(), found->second) != element.end())
            lines.fail(name + " names node " + std::to_string(node) + " twice");
        element[place_in_file[i]] = found->second;
    }
    if (!lines.next_word().empty())
        lines.fail(name + " names too many nodes");
    const std::string fault = count == 4 ? element_fault(positions_of<4>(content, element))
                                         : element_fault(positions_of<10>(content, element));
    if (!fault.empty())
        lines.fail(name + " " + fault);
    content.elements.push_back(element);
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
            read_format(lines);
            format_known = true;
        } else if (section == "$Nodes") {
            read_counted(lines, "Nodes", [&] { read_node(lines, content); });
        } else if (section == "$Elements") {
            read_counted(lines, "Elements", [&] { read_element(lines, content); });
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
QuadraticTetrahedralMesh compact(const GmshContent& content)
{
    enum Use { unused, middle, corner };
    std::vector<Use> use(content.nodes.size(), unused);
    for (const auto& element : content.elements)
        for (std::size_t i = 0; i < 10 && element[i] >= 0; ++i) {
            Use& of_node = use[element[i]];
            of_node = std::max(of_node, i < 4 ? corner : middle);
        }
    QuadraticTetrahedralMesh mesh;
    std::vector<int> renumbered(content.nodes.size(), -1);
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

std::ifstream open(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(file.string() + ": cannot be opened");
    return stream;
}

}  // namespace

TetrahedralMesh read_gmsh(std::istream& stream, const std::string& name)
{
    TextLines lines(stream, name);
    return corners_of(compact(read_gmsh_content(lines)));
}

QuadraticTetrahedralMesh read_gmsh_quadratic(std::istream& stream, const std::string& name)
{
    TextLines lines(stream, name);
    const GmshContent content = read_gmsh_content(lines);
    return content.type == ten_node_tetrahedron ? compact(content)
                                                : with_edge_midpoints(corners_of(compact(content)));
}

TetrahedralMesh read_gmsh(const std::filesystem::path& file)
{
    std::ifstream stream = open(file);
    return read_gmsh(stream, file.string());
}

QuadraticTetrahedralMesh read_gmsh_quadratic(const std::filesystem::path& file)
{
    std::ifstream stream = open(file);
    return read_gmsh_quadratic(stream, file.string());
}

}  // namespace enduring
