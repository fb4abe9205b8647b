#include "chapters/engines/bullet/bullet_solver.hpp"

#include "chapters/engines/bullet/bullet_world.hpp"

#include <LinearMath/btScalar.h>

namespace enduring {

Solver bullet_solver(Scene& scene) { return iterated_bullet_solver(scene, bullet::default_iterations); }

Solver iterated_bullet_solver(Scene& scene, int iterations)
{
    const auto bullet = std::make_shared<bullet::BulletWorld>(scene, iterations);
    Solver solver;
    solver.name = "Bullet " + bullet_version();
    solver.finds_stiffness = true;
    solver.append(StepStage::refresh, "Bullet's step", [bullet](World& world, Contacts& contacts, double dt) {
        bullet->step(world, contacts, dt);
    });
    return solver;
}

std::string bullet_version()
{
    return std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

}  // namespace enduring
