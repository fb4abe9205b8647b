#include "chapters/bullet_baseline/bullet_solver.hpp"

#include "chapters/bullet_baseline/bullet_world.hpp"

#include <LinearMath/btScalar.h>

namespace enduring {

Solver bullet_solver(Scene& scene)
{
    const auto bullet = std::make_shared<bullet::BulletWorld>(scene);
    const int version = btGetVersion();
    Solver solver;
    solver.name = "Bullet " + std::to_string(version / 100) + "." + std::to_string(version % 100);
    solver.append(StepStage::refresh, "Bullet's step", [bullet](World& world, Contacts& contacts, double dt) {
        bullet->step(world, contacts, dt);
    });
    return solver;
}

}  // namespace enduring
