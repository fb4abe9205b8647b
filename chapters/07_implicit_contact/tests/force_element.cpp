#include "chapters/07_implicit_contact/force_element.hpp"

#include "chapters/07_implicit_contact/islands.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

/// Three lines, of which the first is two-sided, the second pushes only, and the third is a motor at its
/// most.
ElementLaw three_lines()
{
    ElementLaw law;
    law.axes << 0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1;
    law.lines[0] = {0.3, 2};
    law.lines[1] = {-0.1, 3, 0};
    law.lines[2] = {-9, 5, -0.5, 0.5};
    return law;
}

World three_bodies()
{
    World world;
    for (int i = 0; i < 3; ++i) {
        SurfaceMesh mesh = box(Vec3::Ones());
        for (Vec3& vertex : mesh.vertices)
            vertex.x() += 5 * i;
        world.bodies.push_back(std::make_unique<RigidBody>("cube", mesh, mass_properties(mesh, 1)));
    }
    return world;
}

}  // namespace

TEST_CASE("force element: its Hessian is minus the derivative of its impulse")
{
    const ElementLaw law = three_lines();
    for (const Vec3& velocity : {Vec3(0.2, -0.1, 0.3), Vec3(-0.4, 0.5, 1.75), Vec3(-1, -1, 0)}) {
        Mat3 differences;
        for (int i = 0; i < 3; ++i)
            differences.col(i) = (law.impulse(velocity - 1e-6 * Vec3::Unit(i)) -
                                  law.impulse(velocity + 1e-6 * Vec3::Unit(i))) /
                                 2e-6;
        CHECK((law.hessian(velocity) - differences).norm() <= 1e-8);
        CHECK((law.hessian(velocity) - law.hessian(velocity).transpose()).norm() <= 1e-12);
    }
}

TEST_CASE("force element: a line pushes between its bounds, and between them it falls with the velocity")
{
    const LineLaw pushes{-0.1, 3, 0}, motor{-9, 5, -0.5, 0.5};
    CHECK(pushes.impulse(0) == doctest::Approx(0.1));
    CHECK(pushes.impulse(1) == 0);
    CHECK(pushes.slope_at(1) == 0);
    CHECK(motor.impulse(0) == 0.5);
    CHECK(motor.impulse(1.8) == doctest::Approx(0));
    CHECK(motor.impulse(9) == -0.5);
    CHECK(motor.slope_at(1.8) == 5);
}

TEST_CASE("force element: it joins its bodies to one island, with what it brings upon them")
{
    const World world = three_bodies();
    Contacts none;
    const std::vector<ElementBodies> elements{{-1, -1, 7}, {2, 0, 3}, {1, -1}};
    const std::vector<Island> islands = find_islands(world, none, elements);
    REQUIRE(islands.size() == 2);
    CHECK(islands[0].bodies == std::vector<int>{0, 2});
    CHECK(islands[0].elements == std::vector<int>{1});
    CHECK(islands[0].element_force == 3);
    CHECK(islands[1].bodies == std::vector<int>{1});
    CHECK(islands[1].elements == std::vector<int>{2});
    CHECK(find_islands(world, none).empty());
}
