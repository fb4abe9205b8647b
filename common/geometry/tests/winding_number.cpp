#include "common/geometry/winding_number.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

TEST_CASE("winding number: 1 inside a closed surface, 0 outside, -1 inside one that faces inwards")
{
    SurfaceMesh cube = box({2, 2, 2});
    CHECK(winding_number(cube.faces, cube.vertices, {0.3, -0.2, 0.9}) == doctest::Approx(1).epsilon(1e-14));
    CHECK(std::abs(winding_number(cube.faces, cube.vertices, {0.3, -0.2, 1.1})) < 1e-14);
    for (Face& face : cube.faces)
        std::swap(face[0], face[1]);
    CHECK(winding_number(cube.faces, cube.vertices, {0.3, -0.2, 0.9}) == doctest::Approx(-1).epsilon(1e-14));
}

TEST_CASE("winding number: a side of a cube fills a sixth of what is seen from its middle")
{
    const SurfaceMesh cube = box({2, 2, 2});
    std::vector<Face> top;
    std::copy_if(cube.faces.begin(), cube.faces.end(), std::back_inserter(top), [&](const Face& face) {
        return std::all_of(face.begin(), face.end(), [&](int v) { return cube.vertices[v].y() > 0; });
    });
    REQUIRE_FALSE(top.empty());
    CHECK(winding_number(top, cube.vertices, Vec3::Zero()) == doctest::Approx(1.0 / 6).epsilon(1e-14));
}
