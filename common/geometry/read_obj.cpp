#include "common/geometry/read_obj.hpp"

#include "common/geometry/surface_checks.hpp"
#include "common/input/input_error.hpp"
#include "common/input/text_lines.hpp"

#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <charconv>
#include <fstream>
#include <sstream>

namespace enduring {
namespace {

/// What the file says, checked line by line. tinyobjloader reads "nan" and missing numbers as 0 and rounds decimals
/// more than once, so coordinates are read here; it gets the vertices for its triangulation, and the faces.
struct ObjContent {
    std::vector<Vec3> vertices;
    struct Corner {
        long vertex;  ///< counted from 1
        int line;
    };
    std::vector<Corner> corners;     ///< of all faces
    std::size_t triangle_count = 0;  ///< that the polygons should yield
    std::string for_library;         ///< vertices and faces, without texture, normals, materials and groups
};

void read_vertex(TextLines& lines, ObjContent& content)
{
    Vec3 x;
    for (double& coordinate : x)
        coordinate = lines.next_finite_number("coordinate");
    content.vertices.push_back(x);
    content.for_library.append(lines.line()).append("\n");
}

/// The vertex of a corner "vertex/texture/normal", counted from 1; negative numbers count back from the last vertex.
long vertex_of_corner(std::string_view word, const TextLines& lines, const ObjContent& content)
{
    const std::string_view digits = word.substr(0, word.find('/'));
    long number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number == 0)
        lines.fail(TextLines::quoted(word) + " does not name a vertex; vertices are counted from 1");
    return number > 0 ? number : static_cast<long>(content.vertices.size()) + 1 + number;
}

void read_face(TextLines& lines, ObjContent& content)
{
    content.for_library += 'f';
    int corners = 0;
    for (std::string_view word = lines.next_word(); !word.empty(); word = lines.next_word(), ++corners) {
        const long vertex = vertex_of_corner(word, lines, content);
        content.corners.push_back({vertex, lines.number()});
        content.for_library.append(1, ' ').append(std::to_string(vertex));
    }
    content.for_library += '\n';
    if (corners < 3)
        lines.fail("a face with " + std::to_string(corners) + " corners; three are needed");
    content.triangle_count += static_cast<std::size_t>(corners) - 2;
}

ObjContent read_content(TextLines& lines)
{
    ObjContent content;
    while (lines.next()) {
        const std::string_view keyword = lines.next_word();
        if (keyword == "v")
            read_vertex(lines, content);
        else if (keyword == "f")
            read_face(lines, content);
    }
    if (content.corners.empty())
        lines.fail("the file ends without a face");
    for (const auto& [vertex, line] : content.corners)  // only now: faces may stand before their vertices
        if (vertex < 1 || vertex > static_cast<long>(content.vertices.size()))
            lines.fail_at(line, "the face names vertex " + std::to_string(vertex) + "; the file has 1 to " +
                                    std::to_string(content.vertices.size()));
    return content;
}

std::vector<Face> triangles(const ObjContent& content, const TextLines& lines)
{
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    std::istringstream text(content.for_library);
    const bool read = tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &text, nullptr, true, false);

    std::vector<int> corners;
    for (const tinyobj::shape_t& shape : shapes)
        for (const tinyobj::index_t& index : shape.mesh.indices)
            corners.push_back(index.vertex_index);
    if (!read || corners.size() != 3 * content.triangle_count)
        lines.fail("a polygon of this file cannot be cut into triangles");

    std::vector<Face> faces;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        faces.push_back({corners[i], corners[i + 1], corners[i + 2]});
    return faces;
}

}  // namespace

SurfaceMesh read_obj(std::istream& stream, const std::string& name)
{
    TextLines lines(stream, name);
    ObjContent content = read_content(lines);
    std::vector<Face> faces = triangles(content, lines);
    return without_unused_vertices({std::move(content.vertices), std::move(faces)});
}

SurfaceMesh read_obj(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file))
        throw InputError(file.string() + ": cannot be opened");
    return read_obj(stream, file.string());
}

}  // namespace enduring
