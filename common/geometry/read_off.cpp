#include "common/geometry/polygon_triangles.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/input/text_lines.hpp"

#include <algorithm>
#include <sstream>

namespace enduring {
namespace {

/// The next line that is no comment; the file may not end here.
void next_off_line(TextLines& lines, const char* what)
{
    do
        if (!lines.next())
            lines.fail(std::string("the file ends where ") + what + " is missing");
    while (lines.line()[0] == '#');
}

/// The keyword, and the counts of vertices and faces behind it or in the next line.
std::array<long, 2> read_off_head(TextLines& lines)
{
    next_off_line(lines, "OFF");
    const std::string_view keyword = lines.next_word();
    if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF")
        lines.fail("not an OFF file: it does not start with OFF");
    if (lines.line() == keyword)
        next_off_line(lines, "the count of vertices");
    const long vertices = lines.next_integer("count of vertices"),
               faces = lines.next_integer("count of faces");
    if (vertices < 0 || faces < 0)
        lines.fail("the count of " + std::string(vertices < 0 ? "vertices" : "faces") + " is " +
                   std::to_string(std::min(vertices, faces)) + ", below zero");
    return {vertices, faces};
}

}  // namespace

SurfaceMesh read_off(const std::string& bytes, const std::string& name)
{
    std::istringstream stream(bytes);
    TextLines lines(stream, name);
    const auto [vertex_count, face_count] = read_off_head(lines);
    std::vector<Vec3> vertices;
    for (long i = 0; i < vertex_count; ++i) {
        next_off_line(lines, "a vertex");
        Vec3& x = vertices.emplace_back();
        for (double& coordinate : x)
            coordinate = lines.next_finite_number("coordinate");
    }
    std::vector<std::vector<long>> polygons;
    std::vector<int> line_of;
    for (long i = 0; i < face_count; ++i) {
        next_off_line(lines, "a face");
        line_of.push_back(lines.number());
        std::vector<long>& corners = polygons.emplace_back();
        const long count = lines.next_integer("count of corners");
        if (count < 0)
            lines.fail("the count of corners is " + std::to_string(count) + ", below zero");
        for (long left = count; left > 0; --left)
            corners.push_back(lines.next_integer("vertex of the face"));
    }
    return surface_from_polygons(std::move(vertices), polygons, [&](long polygon, const std::string& reason) {
        if (polygon < 0)
            lines.fail(reason);
        lines.fail_at(line_of[static_cast<std::size_t>(polygon)], reason);
    });
}

}  // namespace enduring
