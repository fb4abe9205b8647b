#include "chapters/08_contact_by_distance/skin.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/surface_step.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

Vec3 normal_of(const Face& face, const std::vector<Vec3>& x)
{
    const auto at = [&](std::size_t i) { return x[static_cast<std::size_t>(face[i])]; };
    return (at(1) - at(0)).cross(at(2) - at(0));
}

/// A double pyramid over a square, as high as it is told on both sides.
SurfaceMesh spindle(double height)
{
    SurfaceMesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {0, height, 0}, {0, -height, 0}};
    for (int i = 0; i < 4; ++i) {
        mesh.faces.push_back({i, (i + 1) % 4, 4});
        mesh.faces.push_back({(i + 1) % 4, i, 5});
    }
    return mesh;
}

std::vector<Vec3> inset(const SurfaceMesh& mesh, double distance)
{
    const SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), mesh.faces);
    return inset_surface(topology, mesh.vertices, distance);
}

/// Two soft cubes of 0.2 m above each other, without gravity.
World two_soft_cubes(double apart)
{
    World world;
    world.gravity.setZero();
    for (const double height : {0.0, 0.2 + apart}) {
        TetrahedralMesh mesh = bar({0.2, 0.2, 0.2}, {2, 2, 2});
        for (Vec3& node : mesh.nodes)
            node.y() += height;
        DeformableSettings settings;
        settings.material = {.young = 1e5, .poisson = 0.3, .density = 1000};
        settings.impulse_response = ImpulseResponse::implicit;
        world.bodies.push_back(std::make_unique<DeformableBody>("cube", mesh, settings));
    }
    return world;
}

}  // namespace

TEST_CASE(
    "skin: soft bodies that begin nearer than their skins are not pushed apart, and a run that goes on keeps their skins")
{
    const double size = two_soft_cubes(1).bodies[0]->size(), skin = distance_parts.skin * size;
    for (const double apart : {0.1 * skin, 0.5 * skin, 10 * skin}) {
        CAPTURE(apart);
        World world = two_soft_cubes(apart);
        const distance_tests::Run run(world, 3, 0.01);
        CHECK((run.pushed > 0) == (apart < 2 * distance_parts.least_skin * skin));
        const double thin = std::max(distance_parts.least_skin * skin, std::min(skin, apart / 2));
        CHECK(world.skins[0] == doctest::Approx(thin).epsilon(1e-9));
        World later = two_soft_cubes(1e-9);
        later.skins = {2 * thin, 2 * thin};
        const distance_tests::Run resumed(later, 1, 0.01);
        CHECK(later.skins[0] == 2 * thin);
    }
}

TEST_CASE("skin: the planes of a box move in by the distance, whatever its faces are cut into")
{
    for (const int cells : {1, 3}) {
        const SurfaceMesh mesh = box({1, 1, 1}, {cells, cells, cells});
        const std::vector<Vec3> moved = inset(mesh, 0.01);
        double largest = 0, smallest = 1;
        for (std::size_t v = 0; v < moved.size(); ++v) {
            largest = std::max(largest, moved[v].cwiseAbs().maxCoeff());
            smallest = std::min(smallest, moved[v].cwiseAbs().maxCoeff());
        }
        CHECK(largest == doctest::Approx(0.49).epsilon(1e-12));
        CHECK(smallest == doctest::Approx(0.49).epsilon(1e-12));
    }
}

TEST_CASE(
    "skin: no face turns over, and no surface meets itself on its way in, also of needles, plates and slivers")
{
    const std::vector<std::pair<SurfaceMesh, double>> cases{
        {spindle(30), 0.05},
        {spindle(0.02), 0.001},
        {spindle(0.02), 0.1},
        {spindle(1), 0.7},
        {box({1, 0.002, 1}, {2, 1, 2}), 0.002},
    };
    for (std::size_t n = 0; n < cases.size(); ++n) {
        CAPTURE(n);
        const auto& [mesh, distance] = cases[n];
        const std::vector<Vec3> moved = inset(mesh, distance);
        for (const Face& face : mesh.faces)
            CHECK(normal_of(face, mesh.vertices).dot(normal_of(face, moved)) > 0);
        const SurfaceTopology topology(static_cast<int>(mesh.vertices.size()), mesh.faces);
        const SurfaceStep step{topology, mesh.vertices, moved};
        for (int v = 0; v < topology.vertex_count(); ++v) {
            CHECK(winding_number(mesh.faces, mesh.vertices, moved[static_cast<std::size_t>(v)] * (1 + 1e-9)) >
                  -0.01);
            for (int f = 0; f < static_cast<int>(mesh.faces.size()); ++f)
                if (const Face& face = mesh.faces[static_cast<std::size_t>(f)];
                    face[0] != v && face[1] != v && face[2] != v)
                    CHECK_FALSE(time_of_impact(vertex_face_step(step, v, step, f)));
        }
    }
}

TEST_CASE("skin: what is thinner than its inset keeps its surface where it cannot go in")
{
    const SurfaceMesh plate = box({1, 0.002, 1});
    const std::vector<Vec3> moved = inset(plate, 0.004);
    for (std::size_t v = 0; v < moved.size(); ++v)
        CHECK(moved[v].y() * plate.vertices[v].y() > 0);
}
