#include "common/simulation/natural_units.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

/// A cube of 0.5 m on a slab of 2 m and a plane.
World cube_on_slab()
{
    const SurfaceMesh cube = box(Vec3::Constant(0.5)), slab = box(Vec3::Constant(2));
    World world;
    world.planes.push_back({"ground"});
    world.bodies.push_back(std::make_unique<StaticBody>(
        "slab", SurfaceTopology(static_cast<int>(slab.vertices.size()), slab.faces), slab.vertices));
    world.bodies.push_back(std::make_unique<RigidBody>("cube", cube, mass_properties(cube, 1000)));
    return world;
}

}  // namespace

TEST_CASE("natural units: a pair's length is the smaller body's, in either order, and a plane has none")
{
    const World world = cube_on_slab();
    CHECK(natural_length(world, {ContactKind::vertex_face, 0, 1}) == doctest::Approx(0.5));
    CHECK(natural_length(world, {ContactKind::edge_edge, 1, 0}) == doctest::Approx(0.5));
    CHECK(natural_length(world, {ContactKind::vertex_plane, 1, 0}) == doctest::Approx(0.5));
    CHECK(natural_length(world, {ContactKind::vertex_plane, 0, 0}) == doctest::Approx(2));
}

TEST_CASE(
    "natural units: a speed is sqrt(g L), whatever the step, and without gravity the step alone tells the time")
{
    for (const double dt : {0.01, 0.001}) {
        const NaturalUnits heavy = natural_units(0.5, 8, dt), weightless = natural_units(0.5, 0, dt);
        CHECK(heavy.speed == 2);
        CHECK(weightless.length / weightless.speed == doctest::Approx(scale_parts.weightless_steps * dt));
    }
}

TEST_CASE(
    "natural units: of a body of one metre on Earth they are the same with gravity and without, but for 1 %")
{
    CHECK(natural_units(1, 9.81, 0.01).speed == doctest::Approx(NaturalUnits{}.speed).epsilon(0.01));
    CHECK(natural_units(1, 0, 0.01).speed == doctest::Approx(NaturalUnits{}.speed).epsilon(0.01));
}

TEST_CASE(
    "natural units: a scene's leaving speed holds for every pair, else it grows as the root of the size")
{
    const World world = cube_on_slab();
    const Contact with_cube{ContactKind::vertex_plane, 1, 0}, with_slab{ContactKind::vertex_plane, 0, 0};
    CHECK(max_depenetration_velocity(world, with_cube, 0.2, 0.01) == 0.2);
    CHECK(max_depenetration_velocity(world, with_slab, 0.2, 0.01) == 0.2);
    CHECK(max_depenetration_velocity(world, with_slab, {}, 0.01) ==
          doctest::Approx(2 * max_depenetration_velocity(world, with_cube, {}, 0.01)));
}
