#include "common/scenes/shape_reader.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/mend.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/read_surface.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/geometry/weld.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"
#include "common/scenes/frame_reader.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace enduring {
namespace {

const NumberRange length{0, 1e4, false, true, "m"};
constexpr int max_cells = 2000;  // along one side; the product has its own limit

template <std::size_t n>
std::array<int, n> read_cells(const JsonValue& value, const std::array<int, n>& otherwise)
{
    const std::optional<JsonValue> list = value.find("cells");
    if (!list)
        return otherwise;
    std::array<int, n> cells{};
    const std::vector<JsonValue> items = list->items(n, n);
    std::transform(items.begin(), items.end(), cells.begin(),
                   [](const JsonValue& item) { return item.integer(1, max_cells); });
    return cells;
}

void require_at_most(const JsonValue& value, double count, int limit, const std::string& of_what)
{
    if (count > limit)
        value.complain("asks for " + std::to_string(static_cast<long>(count)) + " " + of_what + "; at most " +
                       std::to_string(limit) + " are allowed");
}

double grid_faces(const std::array<int, 3>& cells)
{
    const double x = cells[0], y = cells[1], z = cells[2];
    return 4 * (x * y + y * z + z * x);
}

Shape surface_only(SurfaceMesh mesh) { return {std::move(mesh), std::nullopt, {}}; }

Shape with_surface(TetrahedralMesh solid)
{
    SurfaceMesh surface = surface_of(solid).mesh;
    return {std::move(surface), std::move(solid), {}};
}

Shape read_box(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"size", "cells"});
    const std::array<int, 3> cells = read_cells<3>(value, {1, 1, 1});
    require_at_most(value, grid_faces(cells), limits.surface_faces, "faces");
    return surface_only(box(value.at("size").vector(length), cells));
}

Shape read_slope(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"size", "angle_deg", "cells"});
    const std::array<int, 3> cells = read_cells<3>(value, {1, 1, 1});
    require_at_most(value, grid_faces(cells), limits.surface_faces, "faces");
    const double angle = value.at("angle_deg").angle({-90, 90, false, false});
    return surface_only(slope(value.at("size").vector(length), angle, cells));
}

Shape read_bar(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"size", "cells", "split"});
    const std::array<int, 3> cells = read_cells<3>(value, {1, 1, 1});
    const std::optional<JsonValue> split = value.find("split");
    const bool five = !split || split->choice({"six", "five"}) == 1;
    require_at_most(value, (five ? 5.0 : 6.0) * cells[0] * cells[1] * cells[2], limits.elements, "elements");
    return with_surface(bar(value.at("size").vector(length), cells, five ? CellSplit::five : CellSplit::six));
}

Shape read_plane_grid(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"size", "cells", "diagonals"});
    const std::vector<JsonValue> size = value.at("size").items(2, 2);
    const std::array<int, 2> cells = read_cells<2>(value, {1, 1});
    const std::optional<JsonValue> word = value.find("diagonals");
    constexpr std::array<GridDiagonals, 3> diagonals{GridDiagonals::same, GridDiagonals::alternating,
                                                     GridDiagonals::crossed};
    const std::size_t chosen = word ? word->choice({"same", "alternating", "crossed"}) : 0;
    require_at_most(value, 4.0 * cells[0] * cells[1], limits.surface_faces, "faces");
    return surface_only(plane_grid(size[0].number(length), size[1].number(length), cells, diagonals[chosen]));
}

Shape read_tetrahedron(const JsonValue& value, const SceneLimits&)
{
    value.require_keys({"edge"});
    return surface_only(tetrahedron(value.at("edge").number(length)));
}

Shape read_sphere(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"radius", "subdivisions"});
    const std::optional<JsonValue> finer = value.find("subdivisions");
    const int subdivisions = finer ? finer->integer(0, 8) : 2;
    require_at_most(value, 20.0 * (1 << (2 * subdivisions)), limits.surface_faces, "faces");
    return surface_only(sphere(value.at("radius").number(length), subdivisions));
}

Shape read_bowl(const JsonValue& value, const SceneLimits& limits)
{
    value.require_keys({"inner_radius", "thickness", "rim_angle_deg", "foot_radius", "segments_around",
                        "segments_along", "segments_rim"});
    const auto segments = [&](const std::string& key, int low, int otherwise) {
        const std::optional<JsonValue> count = value.find(key);
        return count ? count->integer(low, max_cells) : otherwise;
    };
    BowlShape shape;
    shape.inner_radius = value.at("inner_radius").number(length);
    shape.thickness = value.at("thickness").number(length);
    if (const std::optional<JsonValue> rim = value.find("rim_angle_deg"))
        shape.rim_angle = rim->angle({0, 180, false, false});
    shape.foot_radius = value.number_or("foot_radius", {0, 1e4, true, true, "m"}, shape.foot_radius);
    shape.segments_around = segments("segments_around", 3, shape.segments_around);
    shape.segments_along = segments("segments_along", 2, shape.segments_along);
    shape.segments_rim = segments("segments_rim", 2, shape.segments_rim);
    require_at_most(value, 4.0 * shape.segments_around * (shape.segments_along + shape.segments_rim),
                    limits.surface_faces, "faces");
    return surface_only(bowl(shape));
}

Shape read_file(const JsonValue& value, const SceneSurroundings& surroundings)
{
    const std::filesystem::path path = find_mesh(value, surroundings.mesh_folders);
    const std::string ending = ending_of(path);
    if (ending == ".msh") {
        GmshSolid read = read_gmsh_with_groups(path);
        Shape shape = with_surface(std::move(read.mesh));
        shape.groups = std::move(read.groups);
        return shape;
    }
    if (ending == ".obj" || ending == ".off" || ending == ".stl" || ending == ".ply")
        return surface_only(read_surface(path));
    value.fail("a mesh file ending in .msh (tetrahedra) or .obj, .off, .stl or .ply (surface)");
}

/// "weld": true, beside a "file" that is a surface.
void weld_if_asked(const JsonValue& value, Shape& shape)
{
    const bool is_surface_file = value.find("file") && !shape.solid;
    if (value.flag_or("mend", false) && !is_surface_file)
        value.at("mend").complain("only a surface file (.obj, .off, .stl, .ply) can be mended");
    if (!value.flag_or("weld", false))
        return;
    if (!is_surface_file)
        value.at("weld").complain(
            "only the vertices of a surface file (.obj, .off, .stl, .ply) can be welded");
    shape.surface = welded(shape.surface, weld_distance(shape.surface));
}

/// The key "transform": rows of a 3 x 4 matrix (R | t), so that a point X goes to R X + t.
void transform_if_asked(const JsonValue& value, Shape& shape)
{
    const std::optional<JsonValue> given = value.find("transform");
    if (!given)
        return;
    const std::vector<JsonValue> rows = given->items(3, 3);
    Eigen::Matrix<double, 3, 4> matrix;
    for (int row = 0; row < 3; ++row) {
        const std::vector<JsonValue> numbers = rows[static_cast<std::size_t>(row)].items(4, 4);
        for (int column = 0; column < 4; ++column)
            matrix(row, column) = numbers[static_cast<std::size_t>(column)].number({-1e4, 1e4});
    }
    const Mat3 linear = matrix.leftCols<3>();
    if (!(linear.determinant() > 0))
        given->complain(
            "flattens or mirrors the shape: the determinant of its first three columns has to be positive, and is " +
            shortest(linear.determinant()));
    const auto apply = [&](std::vector<Vec3>& points) {
        for (Vec3& x : points)
            x = linear * x + matrix.col(3);
    };
    apply(shape.surface.vertices);
    if (shape.solid)
        apply(shape.solid->nodes);
}

using Reader = Shape (*)(const JsonValue&, const SceneLimits&);
struct NamedReader {
    const char* name;
    Reader read;
};
constexpr std::array<NamedReader, 7> generated{{{"bar", read_bar},
                                                {"bowl", read_bowl},
                                                {"box", read_box},
                                                {"plane_grid", read_plane_grid},
                                                {"slope", read_slope},
                                                {"sphere", read_sphere},
                                                {"tetrahedron", read_tetrahedron}}};

/// The one entry of the object that says which shape it is; "scale", "transform", "weld" and "mend" may stand
/// beside it.
Shape read_unscaled(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"bar", "bowl", "box", "file", "plane_grid", "points", "slope", "sphere",
                        "tetrahedron", "wire", "scale", "transform", "weld", "mend"});
    std::vector<std::pair<std::string, JsonValue>> kinds = value.members();
    kinds.erase(std::remove_if(kinds.begin(), kinds.end(),
                               [](const auto& member) {
                                   return member.first == "scale" || member.first == "transform" ||
                                          member.first == "weld" || member.first == "mend";
                               }),
                kinds.end());
    if (kinds.size() != 1)
        value.fail(
            "an object with exactly one of \"bar\", \"bowl\", \"box\", \"file\", \"plane_grid\", \"points\", \"slope\", \"sphere\", \"tetrahedron\", \"wire\"");
    const auto& [kind, description] = kinds.front();
    try {
        if (kind == "file")
            return read_file(description, surroundings);
        if (kind == "points" || kind == "wire")
            return surface_only((kind == "wire" ? read_wire : read_points)(description, surroundings));
        const auto reader = std::find_if(generated.begin(), generated.end(),
                                         [&k = kind](const NamedReader& r) { return r.name == k; });
        return reader->read(description, surroundings.limits);
    } catch (const InputError& error) {
        description.pass_on(error);
    }
}

}  // namespace

std::filesystem::path find_mesh(const JsonValue& value, const std::vector<std::filesystem::path>& folders)
{
    const std::string name = value.text();
    std::string searched;
    for (const std::filesystem::path& folder : folders) {
        std::error_code ignored;
        std::filesystem::path path = folder / name;
        if (std::filesystem::exists(path, ignored))
            return path;
        searched += (searched.empty() ? "" : " and ") + folder.string();
    }
    value.complain("there is no mesh file \"" + name + "\" (searched in " + searched + ")");
}

Shape read_shape(const JsonValue& value, const SceneSurroundings& surroundings)
{
    Shape shape = read_unscaled(value, surroundings);
    weld_if_asked(value, shape);
    const double scale = value.number_or("scale", {0, 1e4, false, true}, 1.0);
    for (Vec3& vertex : shape.surface.vertices)
        vertex *= scale;
    if (shape.solid)
        for (Vec3& node : shape.solid->nodes)
            node *= scale;
    transform_if_asked(value, shape);
    return shape;
}

SurfaceMesh mend_if_asked(const JsonValue& shape, SurfaceMesh mesh, Border border,
                          const SceneSurroundings& surroundings)
{
    if (!shape.flag_or("mend", false))
        return mesh;
    MendedSurface found = mended(mesh, border);
    if (const std::string what = found.counts.text(); surroundings.told && !what.empty())
        surroundings.told->push_back(shape.file() + ": " + shape.path() + "/mend: " + what);
    return std::move(found.mesh);
}

}  // namespace enduring
