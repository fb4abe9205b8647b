#include "common/geometry/raw_number.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/geometry/weld.hpp"
#include "common/input/input_error.hpp"
#include "common/input/text_lines.hpp"

#include <cstdint>
#include <sstream>

namespace enduring {
namespace {

/// A binary file: a head of 80 bytes, the count, and for each triangle its normal, its corners and two bytes.
constexpr std::size_t head_bytes = 80, first_triangle = head_bytes + 4, triangle_bytes = 50,
                      normal_bytes = 12;

std::size_t promised_bytes(const std::string& bytes)
{
    return first_triangle +
           triangle_bytes * raw_number<std::uint32_t>(bytes.data() + head_bytes, std::endian::little);
}

SurfaceMesh read_binary_stl(const std::string& bytes, const std::string& name)
{
    if (bytes.size() < first_triangle)
        throw InputError(
            name + ": neither a text (it does not start with solid) nor a binary STL file (it is too short)");
    if (bytes.size() < promised_bytes(bytes))
        throw InputError(name + ": a binary STL file that promises " + std::to_string(promised_bytes(bytes)) +
                         " bytes and has " + std::to_string(bytes.size()));
    SurfaceMesh mesh;
    for (std::size_t at = first_triangle; at < promised_bytes(bytes); at += triangle_bytes) {
        const int first = static_cast<int>(mesh.vertices.size());
        for (std::size_t i = 0; i < 9; i += 3) {
            Vec3& x = mesh.vertices.emplace_back();
            for (std::size_t axis = 0; axis < 3; ++axis)
                x[static_cast<Eigen::Index>(axis)] = static_cast<double>(raw_number<float>(
                    bytes.data() + at + normal_bytes + sizeof(float) * (i + axis), std::endian::little));
            if (!x.allFinite())
                throw InputError(name + ": triangle " + std::to_string(mesh.faces.size()) +
                                 " has a coordinate that is not finite");
        }
        mesh.faces.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

SurfaceMesh read_text_stl(const std::string& bytes, const std::string& name)
{
    std::istringstream stream(bytes);
    TextLines lines(stream, name);
    SurfaceMesh mesh;
    std::size_t corners = 0;
    while (lines.next()) {
        const std::string_view keyword = lines.next_word();
        if (keyword == "vertex") {
            Vec3& x = mesh.vertices.emplace_back();
            for (double& coordinate : x)
                coordinate = lines.next_finite_number("coordinate");
            ++corners;
        } else if (keyword == "endloop") {
            if (corners != 3)
                lines.fail("a facet with " + std::to_string(corners) + " corners; three are needed");
            corners = 0;
            const int end = static_cast<int>(mesh.vertices.size());
            mesh.faces.push_back({end - 3, end - 2, end - 1});
        } else if (keyword != "solid" && keyword != "facet" && keyword != "outer" && keyword != "endfacet" &&
                   keyword != "endsolid") {
            lines.fail(TextLines::quoted(keyword) + " is no keyword of an STL file");
        }
    }
    if (corners > 0)
        lines.fail("the file ends within a facet");
    return mesh;
}

}  // namespace

SurfaceMesh read_stl(const std::string& bytes, const std::string& name)
{
    if (bytes.empty())
        throw InputError(name + ": the file is empty");
    // The head of a binary file may say solid, too; then its size decides.
    const bool is_text = bytes.starts_with("solid") &&
                         (bytes.size() < first_triangle || bytes.size() != promised_bytes(bytes));
    const SurfaceMesh mesh = is_text ? read_text_stl(bytes, name) : read_binary_stl(bytes, name);
    if (mesh.faces.empty())
        throw InputError(name + ": the file has no faces");
    return welded(mesh, 0);
}

}  // namespace enduring
