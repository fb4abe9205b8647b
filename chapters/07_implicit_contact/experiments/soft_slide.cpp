#include "chapters/07_implicit_contact/experiments/soft_slide.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"

namespace enduring::chapter07 {

SoftSlide slide_without_friction(const SoftCube& cube, double duration)
{
    Scene scene = soft_cube_on_triangles(cube, 0);
    watch(scene, duration);
    return {-scene.world.bodies.back()->mean_velocity().x(), -scene.world.gravity.x() * scene.world.time};
}

}  // namespace enduring::chapter07
