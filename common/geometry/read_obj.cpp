#include "common/geometry/read_obj.hpp"

#include "common/geometry/polygon_triangles.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/input/input_error.hpp"
#include "common/input/input_file.hpp"
#include "common/input/text_lines.hpp"

#include <algorithm>
#include <charconv>

namespace enduring {
namespace {

/// A face as it stands in the file, with three corners or more.
struct Polygon {
    std::vector<long> vertices;  ///< counted from 1
    int line;
};

struct ObjContent {
    std::vector<Vec3> vertices;
    std::vector<Polygon> polygons;
};

Vec3 read_vertex(TextLines& lines)
{
    Vec3 x;
    for (double& coordinate : x)
        coordinate = lines.next_finite_number("coordinate");
    return x;
}

/// The vertex of a corner "vertex/texture/normal", counted from 1;
/// negative numbers count back from the last vertex.
long vertex_of_corner(std::string_view word, const TextLines& lines, std::size_t vertices_so_far)
{
    const std::string_view digits = word.substr(0, word.find('/'));
    long number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error != std::errc() || end != digits.data() + digits.size() || number == 0)
        lines.fail(TextLines::quoted(word) + " does not name a vertex; vertices are counted from 1");
    return number > 0 ? number : static_cast<long>(vertices_so_far) + 1 + number;
}

Polygon read_face(TextLines& lines, std::size_t vertices_so_far)
{
    Polygon polygon{{}, lines.number()};
    for (std::string_view word = lines.next_word(); !word.empty(); word = lines.next_word())
        polygon.vertices.push_back(vertex_of_corner(word, lines, vertices_so_far));
    if (polygon.vertices.size() < 3)
        lines.fail("a face with " + std::to_string(polygon.vertices.size()) + " corners; three are needed");
    return polygon;
}

ObjContent read_obj_content(TextLines& lines)
{
    ObjContent content;
    while (lines.next()) {
        const std::string_view keyword = lines.next_word();
        if (keyword == "v")
            content.vertices.push_back(read_vertex(lines));
        else if (keyword == "f")
            content.polygons.push_back(read_face(lines, content.vertices.size()));
    }
    if (content.polygons.empty())
        lines.fail("the file ends without a face");
    for (const Polygon& polygon : content.polygons)  // only now: faces may stand before their vertices
        for (const long vertex : polygon.vertices)
            if (vertex < 1 || vertex > static_cast<long>(content.vertices.size()))
                lines.fail_at(polygon.line, "the face names vertex " + std::to_string(vertex) +
                                                "; the file has 1 to " +
                                                std::to_string(content.vertices.size()));
    return content;
}

std::vector<Face> triangles(const ObjContent& content, const TextLines& lines)
{
    std::vector<Face> faces;
    for (const Polygon& polygon : content.polygons) {
        std::vector<int> corners;
        for (const long vertex : polygon.vertices)
            corners.push_back(static_cast<int>(vertex) - 1);
        if (!append_triangles(std::move(corners), content.vertices, faces))
            lines.fail_at(polygon.line, "this polygon cannot be cut into triangles");
    }
    return faces;
}

/// A line through its vertices, one after the other, as edges.
void read_line(TextLines& lines, SurfaceMesh& frame, std::vector<int>& line_of_edge)
{
    std::vector<int> vertices;
    for (std::string_view word = lines.next_word(); !word.empty(); word = lines.next_word())
        vertices.push_back(static_cast<int>(vertex_of_corner(word, lines, frame.vertices.size())) - 1);
    if (vertices.size() < 2)
        lines.fail("a line with " + std::to_string(vertices.size()) + " vertices; two are needed");
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
        frame.wires.push_back({vertices[i], vertices[i + 1]});
        line_of_edge.push_back(lines.number());
    }
}

}  // namespace

SurfaceMesh read_obj_frame(std::istream& stream, const std::string& name, int most)
{
    TextLines lines(stream, name);
    SurfaceMesh frame;
    std::vector<int> line_of_edge;
    while (lines.next()) {
        const std::string_view keyword = lines.next_word();
        if (keyword == "v")
            frame.vertices.push_back(read_vertex(lines));
        else if (keyword == "l")
            read_line(lines, frame, line_of_edge);
        else if (keyword == "f")
            lines.fail("a face; points and edges alone are wanted here");
        if (static_cast<int>(std::max(frame.vertices.size(), frame.wires.size())) > most)
            lines.fail("more than " + std::to_string(most) + " vertices or edges");
    }
    if (frame.vertices.empty())
        lines.fail("the file ends without a vertex");
    const auto vertices = static_cast<int>(frame.vertices.size());
    for (std::size_t e = 0; e < frame.wires.size(); ++e)
        for (const int vertex : frame.wires[e])
            if (vertex < 0 || vertex >= vertices)
                lines.fail_at(line_of_edge[e], "the line names vertex " + std::to_string(vertex + 1) +
                                                   "; the file has 1 to " + std::to_string(vertices));
    return frame;
}

SurfaceMesh read_obj_frame(const std::filesystem::path& file, int most)
{
    std::ifstream stream = open_file(file);
    return read_obj_frame(stream, file.string(), most);
}

SurfaceMesh read_obj(std::istream& stream, const std::string& name)
{
    TextLines lines(stream, name);
    ObjContent content = read_obj_content(lines);
    std::vector<Face> faces = triangles(content, lines);
    return without_unused_vertices({std::move(content.vertices), std::move(faces)});
}

SurfaceMesh read_obj(const std::filesystem::path& file)
{
    std::ifstream stream = open_file(file);
    return read_obj(stream, file.string());
}

}  // namespace enduring
