#pragma once

#include "common/experiments/render/stage.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <filesystem>

namespace enduring {

inline Drawable drawable(const SurfaceMesh& mesh, const Vec3& shift, const Vec3& color, bool smooth = false)
{
    Drawable body{mesh.vertices, mesh.faces, color, smooth};
    for (Vec3& position : body.positions)
        position += shift;
    return body;
}

/// A box and a ball next to each other on the floor y = 0.
inline Stage box_and_ball()
{
    Stage stage;
    stage.bodies = {drawable(box({1, 1, 1}, {3, 3, 3}), {0.3, 0.5, 0}, palette::terracotta),
                    drawable(sphere(0.4, 4), {-0.9, 0.4, 0.2}, palette::blue, true)};
    stage.bodies[0].wireframe = true;
    stage.grounds = {{}};
    stage.camera = frame(points_of(stage), {0.3, 0.6, 1});
    return stage;
}

/// The bunny in a bowl that lets it show through, with one feature of each kind marked.
inline Stage bunny_in_bowl()
{
    BowlShape shape;
    shape.segments_around = 48;
    shape.foot_radius = 0.4;
    SurfaceMesh bunny = surface_of(read_gmsh(source_directory() / "common/meshes/bunny_1452.msh")).mesh;
    for (Vec3& vertex : bunny.vertices)
        vertex *= 0.14;
    Stage stage;
    stage.bodies = {drawable(bowl(shape), {0, 0, 0}, palette::sand, true),
                    drawable(bunny, {0.1, -0.75, 0}, palette::ivory)};
    stage.bodies[1].wireframe = true;
    double lowest = 0;
    for (const Vec3& point : stage.bodies[0].positions)
        lowest = std::min(lowest, point.y());
    stage.grounds = {{{0, lowest, 0}}};
    stage.camera = frame(points_of(stage), {0.2, 0.8, 1});

    // The face nearest to the camera is one that it sees.
    const auto& at = stage.bodies[1].positions;
    const auto corner = [&](const Face& face, std::size_t i) -> const Vec3& { return at[face[i]]; };
    const auto depth = [&](const Face& f) {
        return stage.camera.depth((corner(f, 0) + corner(f, 1) + corner(f, 2)) / 3);
    };
    const Face face = *std::min_element(stage.bodies[1].faces.begin(), stage.bodies[1].faces.end(),
                                        [&](const Face& f, const Face& g) { return depth(f) < depth(g); });
    const Vec3 a = corner(face, 0), b = corner(face, 1), c = corner(face, 2);
    stage.triangles = {{{a, b, c}}};
    stage.segments = {{a, b, palette::colliding_edge, 5},
                      {c, c + Vec3(0, 0.4, 0.2), palette::artefact, 4, true}};
    stage.dots = {{c}};
    stage.labels = {{"a vertex", c, {14, -12}}};
    return stage;
}

}  // namespace enduring
