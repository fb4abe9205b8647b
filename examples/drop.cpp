// A ball falls to the ground: load a scene, take a chapter's solver,
// step it, and print the height of the ball.
#include "chapters/10_self_contact/solver.hpp"
#include "common/scenes/scene.hpp"

#include <algorithm>
#include <cstdio>

int main()
{
    using namespace enduring;
    Scene scene = load_scene(scene_file("falling_sphere"));
    const Solver solver = chapter10_solver(scene.contact);
    const Body& ball = *scene.world.bodies.front();

    Contacts contacts;
    while (scene.world.time < scene.duration) {
        advance(scene.world, contacts, solver, scene.dt);
        double height = INFINITY;
        for (const Vec3& vertex : ball.positions_t0())
            height = std::min(height, vertex.y());
        std::printf("%.3f s: %+.4f m, %zu contacts\n", scene.world.time, height, contacts.size());
    }
}
