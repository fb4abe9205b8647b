#pragma once

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/contact_by_distance/tests/small_world.hpp"

#include <random>

namespace enduring::distance_tests {

/// What a random scene is like.
struct RandomScene {
    World world;
    double dt = 0.01;
    int steps = 15;
};

/// Boxes, plates, needles and balls that fall and are thrown onto a floor and into each other: dt from 1 to 40 ms, sizes from a millimetre
/// to a kilometre, speeds up to 200 sizes a second. Every third scene has no floor, and every fourth one no gravity.
inline RandomScene random_scene(unsigned seed)
{
    std::mt19937 engine(seed);
    const auto draw = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine()) / static_cast<double>(engine.max());
    };
    const auto direction = [&] { return Vec3(draw(-1, 1), draw(-1, 1), draw(-1, 1)).stableNormalized(); };
    RandomScene scene;
    const double size = std::pow(10, draw(-3, 3)), speed = std::pow(10, draw(-1, std::log10(200.0)));
    scene.dt = std::pow(10, draw(-3, std::log10(0.04)));
    scene.world.gravity = seed % 4 == 3 ? Vec3::Zero() : Vec3(0, -9.81 * std::min(1.0, size / scene.dt), 0);
    if (seed % 3 != 2)
        add_static(scene.world, moved(box(size * Vec3(6, 1, 6), {3, 1, 3}), {0, -0.5 * size, 0}));
    const int bodies = 2 + static_cast<int>(seed % 4);
    for (int i = 0; i < bodies; ++i) {
        const int kind = static_cast<int>(engine() % 4);
        const SurfaceMesh mesh = kind == 0   ? box(size * Vec3(1, 1, 1), {1, 2, 1})
                                 : kind == 1 ? box(size * Vec3(1.2, 0.02, 1.2), {2, 1, 2})
                                 : kind == 2 ? box(size * Vec3(0.05, 1.5, 0.05))
                                             : sphere(0.5 * size, 1);
        const Quaternion turn(Eigen::AngleAxisd(draw(0, 3), direction()));
        const Vec3 place = size * Vec3(draw(-0.6, 0.6), 1.3 + 1.9 * i, draw(-0.6, 0.6));
        add_rigid(scene.world, moved(mesh, place, turn),
                  speed * size * Vec3(draw(-0.3, 0.3), -draw(0, 1), draw(-0.3, 0.3)),
                  std::min(1.0, speed) * draw(0, 3) * direction());
    }
    return scene;
}

/// Whether an edge of one body goes through a face of another one.
inline bool any_edge_through_face(const World& world)
{
    for (const auto& a : world.bodies)
        for (const auto& b : world.bodies) {
            if (a == b)
                continue;
            for (const Edge& edge : a->surface().edges())
                for (const Face& f : b->surface().faces())
                    if (find_edge_triangle_hit(a->position(edge[0], 0), a->position(edge[1], 0),
                                               b->position(f[0], 0), b->position(f[1], 0),
                                               b->position(f[2], 0)))
                        return true;
        }
    return false;
}

/// Steps of a run after which something crosses, by two programs that share nothing with the search.
inline int crossed_steps(RandomScene& scene, const Solver& solver)
{
    Contacts contacts;
    int crossed = 0;
    for (int i = 0; i < scene.steps; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        crossed += any_edge_through_face(scene.world) || any_inside(scene.world);
    }
    return crossed;
}

}  // namespace enduring::distance_tests
