#include "common/experiments/render/scene_view.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

std::unique_ptr<Body> standing(const std::string& name, const SurfaceMesh& mesh)
{
    const int count = static_cast<int>(mesh.vertices.size());
    return std::make_unique<StaticBody>(name, SurfaceTopology(count, mesh.faces), mesh.vertices);
}

Scene two_bodies()
{
    Scene scene;
    scene.world.bodies.push_back(standing("box", box({1, 1, 1})));
    scene.world.bodies.push_back(standing("floor", plane_grid(9, 9, {3, 3})));
    scene.world.planes.push_back({"plane", {0, -1, 0}});
    scene.looks["box"] = {palette::plum, true};
    scene.camera.eye = {7, 8, 9};
    return scene;
}

}  // namespace

TEST_CASE("scene view: bodies, looks, planes and camera are those of the scene")
{
    const Scene scene = two_bodies();
    const Stage stage = stage_of(scene.world, scene);
    REQUIRE(stage.bodies.size() == 2);
    CHECK(stage.bodies[0].positions.size() == 8);
    CHECK(stage.bodies[0].faces.size() == 12);
    CHECK(stage.bodies[0].color == palette::plum);
    CHECK(stage.bodies[0].smooth);
    CHECK(stage.bodies[0].casts_shadow);
    CHECK_FALSE(stage.bodies[1].casts_shadow);
    CHECK(stage.grounds.at(0).point == Vec3(0, -1, 0));
    CHECK(stage.camera.eye == Vec3(7, 8, 9));
}

TEST_CASE("scene view: each kind of contact marks its own vertices in the thesis' colours")
{
    const Scene scene = two_bodies();
    const auto box_at = scene.world.bodies[0]->positions_t0(),
               floor_at = scene.world.bodies[1]->positions_t0();
    Contact vertex_face{ContactKind::vertex_face, 0, 1, 3, 0, {3, 0, 1, 4}};
    Contact edge_edge{ContactKind::edge_edge, 0, 1, 0, 0, {2, 5, 6, 7}};
    Contact vertex_plane{ContactKind::vertex_plane, 0, 0, 6, -1, {6, -1, -1, -1}};
    Stage stage = stage_of(scene.world, scene);
    mark_contacts(stage, scene.world, {vertex_face, edge_edge, vertex_plane});

    CHECK(stage.bodies[0].color == palette::plum);  // marking changes no body
    REQUIRE(stage.dots.size() == 2);
    CHECK(stage.dots[0].point == box_at[3]);
    CHECK(stage.dots[1].point == box_at[6]);
    CHECK(stage.dots[0].color == palette::colliding_vertex);
    REQUIRE(stage.triangles.size() == 1);
    CHECK(stage.triangles[0].corners[2] == floor_at[4]);
    CHECK(stage.triangles[0].color == palette::colliding_face);
    REQUIRE(stage.segments.size() == 2);
    CHECK(stage.segments[0].to == box_at[5]);
    CHECK(stage.segments[1].from == floor_at[6]);
    CHECK(stage.segments[1].color == palette::colliding_edge);

    mark_artefacts(stage, scene.world, {vertex_face, edge_edge});
    CHECK(stage.dots.back().point == box_at[3]);
    for (const Vec3& color :
         {stage.dots.back().color, stage.triangles.back().color, stage.segments.back().color})
        CHECK(color == palette::artefact);
}
