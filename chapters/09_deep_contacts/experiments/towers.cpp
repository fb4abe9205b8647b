#include "chapters/09_deep_contacts/experiments/towers.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

namespace enduring::chapter09 {

World tower(int cubes, double turned, double gap)
{
    World world;
    const Mat3 turn = Eigen::AngleAxisd(turned, Vec3::UnitY()).toRotationMatrix();
    for (int i = 0; i <= cubes; ++i) {
        SurfaceMesh cube = box({0.5, 0.5, 0.5});
        for (Vec3& x : cube.vertices)
            x = turn * x + Vec3(0, (0.5 + gap) * i, 0);
        if (i == 0)
            world.bodies.push_back(std::make_unique<StaticBody>(
                "block", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
        else
            world.bodies.push_back(std::make_unique<RigidBody>("cube " + std::to_string(i), cube,
                                                               with_mass(mass_properties(cube, 1000), 20)));
    }
    return world;
}

}  // namespace enduring::chapter09
