#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/experiments/other_methods.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/render/scene_view.hpp"

#include <cmath>
#include <map>

namespace enduring::chapter09 {
namespace {

struct Method {
    std::string name;
    SeparationMethod* find;
};
const std::vector<Method>& all_methods()
{
    static const std::vector<Method> all{{"vector area", overlap_direction},
                                         {"from the border", directions_from_the_border},
                                         {"to the boundary", directions_to_the_boundary}};
    return all;
}

/// A body in a floor, over the corner of a ledge, or wholly in it: everywhere the way out is up.
struct Place {
    std::string name, body;
    Surroundings surroundings;
    double depth;
};

std::vector<Place> places()
{
    const Surroundings floor = {"floor",
                                "",
                                R"({"name": "floor", "type": "static", "position": [0, -0.5, 0],
                                    "shape": {"box": {"size": [2, 1, 2], "cells": [19, 9, 19]}}}, )",
                                {}},
                       ledge = {"ledge",
                                "",
                                R"({"name": "floor", "type": "static", "position": [0.4, -0.5, 0.4],
                                    "shape": {"box": {"size": [1, 1, 1], "cells": [9, 9, 9]}}}, )",
                                {}};
    return {{"cube in a floor", "fine block", floor, 0.1},
            {"cube's corner in a floor", "block on a corner", floor, 0.2},
            {"cube over a ledge's corner", "fine block", ledge, 0.1},
            {"cube wholly in a floor", "fine block", floor, 0.45}};
}

/// The directions that vertices of both bodies get at the start.
struct Directions {
    struct Arrow {
        Vec3 from, direction;
        bool wrong;  ///< more than 45 degrees off
    };
    std::vector<Arrow> of_vertices;
    long wrong = 0, none = 0;  ///< none: without a direction
};

void add_directions(const OverlapShape& inner, const std::vector<int>& vertices, const OverlapShape& outer,
                    const Vec3& out, SeparationMethod* find, double up, Directions& directions)
{
    const std::vector<Vec3> found = find(inner.still(), vertices, outer.still(), out);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const bool none = found[i].isZero(0), wrong = up * found[i].y() < std::sqrt(0.5);
        directions.of_vertices.push_back(
            {inner.positions()[static_cast<std::size_t>(vertices[i])], found[i], wrong});
        directions.none += none;
        directions.wrong += !none && wrong;
    }
}

OverlapShape shape_of(const Body& body)
{
    const auto positions = body.positions_t0();
    const auto faces = body.surface().faces();
    return OverlapShape(SurfaceMesh{{positions.begin(), positions.end()}, {faces.begin(), faces.end()}});
}

/// The cube's vertices should go up, and those of what it is in down.
Directions directions_at_start(const Scene& scene, SeparationMethod* find)
{
    const OverlapShape cube = shape_of(*scene.world.bodies[1]), other = shape_of(*scene.world.bodies[0]);
    Directions directions;
    for (const Overlap& overlap : find_overlaps(cube.still(), other.still())) {
        const Vec3& out = overlap.separation_direction;
        add_directions(cube, overlap.vertices_of_a, other, out, find, 1, directions);
        add_directions(other, overlap.vertices_of_b, cube, -out, find, -1, directions);
    }
    return directions;
}

/// The start over the ledge's corner by each method: both bodies pale, and an arrow for each vertex inside.
void show_starts(Report& report)
{
    // The same corner and the same cells, with less of the ledge behind them: all of it is in the picture.
    const Surroundings ledge = {
        "ledge",
        "",
        R"({"name": "floor", "type": "static", "position": [0.177777777777778, -0.166666666666667, 0.177777777777778],
            "shape": {"box": {"size": [0.555555555555556, 0.333333333333333, 0.555555555555556], "cells": [5, 3, 5]}}}, )",
        {}};
    constexpr int width = 480, height = 400;
    std::vector<Moment> starts;
    for (const Method& method : all_methods()) {
        const Scene scene = scene_inside(ledge, "fine block", 0.1, 0.01);
        Stage stage = stage_of(scene.world, scene);
        for (Drawable& body : stage.bodies)
            body.opacity = 0.35;
        for (const auto& [from, direction, wrong] : directions_at_start(scene, method.find).of_vertices) {
            const Vec3& color = wrong ? palette::colliding_vertex : palette::colliding_face;
            stage.segments.push_back({from, from + 0.08 * direction, color, 3, true});
            stage.dots.push_back({from, color, 3});
        }
        starts.push_back({std::move(stage), method.name});
    }
    frame_together(starts, {-1.1, 0.5, 1.3}, static_cast<double>(width) / height);
    write_png(draw_moments(starts, 3, width, height), report.file("separation_methods.png"));
}

}  // namespace

/// Three choices of the separation direction in the same scenes: how many vertices get a wrong one at the
/// start.
void separation_methods(const RunOptions& /*options*/, Report& report)
{
    Table table({"scene", "method", "vertices", "wrong", "without"});
    std::map<std::string, long> wrong, asked;
    for (const Place& place : places())
        for (const Method& method : all_methods()) {
            const Scene scene = scene_inside(place.surroundings, place.body, place.depth, 0.01);
            const Directions directions = directions_at_start(scene, method.find);
            const auto vertices = static_cast<long>(directions.of_vertices.size());
            table.add({place.name, method.name, vertices, directions.wrong, directions.none});
            wrong[method.name] += directions.wrong;
            asked[method.name] += vertices;
        }
    show_starts(report);
    report.table("separation_methods", table);
    report.page_table("separation_methods", table);
    for (const Method& method : all_methods())
        report.fact(
            "separation_methods", method.name.substr(method.name.rfind(' ') + 1) + "_wrong",
            100.0 * static_cast<double>(wrong[method.name]) / static_cast<double>(asked[method.name]));
}

}  // namespace enduring::chapter09
