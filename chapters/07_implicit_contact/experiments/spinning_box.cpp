#include "chapters/07_implicit_contact/experiments/spinning_box.hpp"

#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace enduring::chapter07 {

Scene spinning_box(double turn, double dt, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) / std::mt19937::max(); };  // 0 to 1
    const auto direction = [&] {
        const double x = number(), y = number(), z = number();
        return Vec3(Vec3(x, y, z) - Vec3::Constant(0.5)).normalized();
    };
    const double flat = 0.2 + 0.8 * number(), narrow = 0.2 + 0.8 * number(), mass = 1 + 99 * number();
    Box below{10, Vec3(0, 0.5, 0)}, spinning{mass, Vec3(0.2, 1.9, 0.1), 90 * number(), direction()};
    spinning.size = Vec3(1, flat, narrow);
    spinning.spin = turn / dt * direction();
    return scene_of({below, spinning}, dt, 0, 0.5, 0.5);
}

double max_energy(Scene scene, MakeSolver make, double max_turn, SolveStatistics& solves)
{
    Solver solver = counting_solver(make, solves)(scene.contact);
    solver.max_turn = max_turn;
    if (std::isinf(max_turn))
        solver.max_halvings = 0;  // every step as it comes
    Contacts contacts;
    const double first = total_energy(scene.world).total();
    double most = 0;
    for (int i = 0; i < 50; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        most = std::max(most, total_energy(scene.world).total() / first);
    }
    return most;
}

}  // namespace enduring::chapter07
