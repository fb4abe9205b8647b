#include "chapters/08_contact_by_distance/experiments/soft_slide.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

namespace enduring::chapter08 {

SoftSlide slide_without_friction(const chapter07::SoftCube& cube, double duration)
{
    Scene scene = chapter07::soft_cube_on_triangles(cube, 0);
    chapter07::watch(scene, duration, chapter08_solver);
    return {-scene.world.bodies.back()->mean_velocity().x(), -scene.world.gravity.x() * scene.world.time};
}

}  // namespace enduring::chapter08
