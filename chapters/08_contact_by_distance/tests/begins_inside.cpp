#include "chapters/08_contact_by_distance/begins_inside.hpp"

#include "chapters/08_contact_by_distance/tests/small_world.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::distance_tests;

namespace {

/// Soft bodies have no surface inside their own, so what is in touch is in touch.
void add_soft(World& world, const TetrahedralMesh& mesh, const Vec3& at, double angle)
{
    DeformableSettings settings;
    settings.material = {.young = 1e5, .poisson = 0.3, .density = 1000};
    settings.position = at;
    settings.rotation = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    settings.impulse_response = ImpulseResponse::implicit;
    world.bodies.push_back(
        std::make_unique<DeformableBody>("soft " + std::to_string(world.bodies.size()), mesh, settings));
}

/// Two cubes of a metre whose middles are apart, turned together.
World two_cubes(const Vec3& apart, int cells, double angle, double second_side = 1)
{
    World world;
    const TetrahedralMesh first = bar({1, 1, 1}, {cells, cells, cells}),
                          second = bar(Vec3::Constant(second_side), {2, 2, 2});
    const Quaternion turn(Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()));
    add_soft(world, first, Vec3::Zero(), angle);
    add_soft(world, second, turn * apart, angle);
    return world;
}

}  // namespace

TEST_CASE(
    "begins inside: what is in touch is not inside, however it lies, and what is in a body is, also where it "
    "touches the wall")
{
    for (const double angle : {0.0, 0.3, 1.0, 2.0, 2.9})
        for (const int cells : {1, 2, 3}) {
            CAPTURE(angle);
            CAPTURE(cells);
            for (const Vec3& apart : {Vec3(0, 1, 0), Vec3(0.1, 1, 0.07), Vec3(-1, 0.2, 0), Vec3(1, 1, 0),
                                      Vec3(1, 1, -1), Vec3(0, 0.3, -1)}) {
                CAPTURE(apart.transpose());
                CHECK(bodies_inside_each_other(two_cubes(apart, cells, angle)).empty());
            }
            for (const Vec3& wall : {Vec3(0, 0, 0), Vec3(0.25, 0, 0), Vec3(-0.25, -0.25, -0.25)})
                CHECK(bodies_inside_each_other(two_cubes(wall, cells, angle, 0.5)).size() == 1);
        }
}
