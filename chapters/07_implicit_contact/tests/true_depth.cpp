#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/07_implicit_contact/experiments/depth_runs.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

std::unique_ptr<Body> box_at(const Vec3& centre, double turn)
{
    SurfaceMesh mesh = box(Vec3::Ones());
    const Eigen::AngleAxisd turned(turn, Vec3(1, 0, 1).normalized());
    for (Vec3& vertex : mesh.vertices)
        vertex = centre + turned * vertex;
    return std::make_unique<RigidBody>("box", mesh, mass_properties(mesh, 1000));
}

}  // namespace

TEST_CASE("true depth: a corner, an edge and a plane say how deep a box is")
{
    World world;
    world.bodies.push_back(box_at(Vec3::Zero(), 0));
    SUBCASE("a corner over the middle of a side")
    {
        const double corner =
            std::acos(1 / std::sqrt(3.0));  // turns a corner down, as deep as half the diagonal
        world.bodies.push_back(box_at({0.1, 0.5 + 0.5 * std::sqrt(3.0) - 0.01, 0.05}, corner));
        double lowest = 1;
        for (const Vec3& vertex : world.bodies[1]->positions_t0())
            lowest = std::min(lowest, vertex.y());
        CHECK(true_depth(world) == doctest::Approx(0.5 - lowest));
    }
    SUBCASE("two edges that cross, all corners outside")
    {
        const auto roof = [](const Vec3& along, double y) {
            SurfaceMesh mesh = box({1, 1, 1});
            const Eigen::AngleAxisd turned(std::acos(0.0) / 2, along);
            for (Vec3& vertex : mesh.vertices)
                vertex = Vec3(0, y, 0) + turned * vertex;
            return std::make_unique<RigidBody>("roof", mesh, mass_properties(mesh, 1000));
        };
        world.bodies.clear();
        world.bodies.push_back(roof(Vec3::UnitX(), 0));
        world.bodies.push_back(roof(Vec3::UnitZ(), std::sqrt(2.0) - 1e-3));
        CHECK(true_depth(world) == doctest::Approx(1e-3 * std::sqrt(0.5)));  // to a side of 45 degrees
    }
    SUBCASE("a plane")
    {
        world.planes.push_back({"ground", Vec3(0, -0.48, 0)});
        CHECK(true_depth(world) == doctest::Approx(0.02));
    }
    SUBCASE("an open sheet that ends under the box, which leans over its border")
    {
        const SurfaceMesh sheet = plane_grid(1, 1, {1, 1});
        world.bodies.push_back(
            std::make_unique<StaticBody>("sheet", SurfaceTopology(4, sheet.faces), sheet.vertices));
        world.bodies[0] = box_at({0.6, 0.499, 0.1}, 0);
        CHECK(true_depth(world) == doctest::Approx(1e-3));
    }
    SUBCASE("bodies apart")
    {
        world.bodies.push_back(box_at({0, 1.001, 0}, 0));
        CHECK(true_depth(world) == 0);
    }
}
