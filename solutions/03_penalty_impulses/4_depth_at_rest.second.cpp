// By the world's own count of steps, and by the depth that the springs see.
#include "exercises/03_penalty_impulses/4_depth_at_rest.hpp"

#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <vector>

namespace enduring {

double predicted_factor() { return 4; }

double depth_at_rest(const RestingCube& cube)
{
    Scene scene = cube_on_floor(cube);
    World& world = scene.world;
    const Solver solver = chapter03_solver(scene.contact);
    Contacts contacts;
    while (world.step < step_count(scene))
        advance(world, contacts, solver, scene.dt);
    std::vector<double> depths;
    for (const Vec3& x : world.bodies.back()->positions_t0())
        depths.push_back(-x.y());
    return *std::max_element(depths.begin(), depths.end());
}

double measured_factor(RestingCube cube, int other_cells)
{
    RestingCube other = cube;
    other.cells = other_cells;
    return depth_at_rest(cube) / depth_at_rest(other);
}

double law_of_depth(const RestingCube& cube)
{
    // All springs together carry the weight, at the mean depth that the method looks at.
    const double side = cube.cells + 1, fall = cube_gravity * cube.dt * cube.dt;
    const double seen = cube.mass * cube_gravity / (cube.stiffness * side * side);
    return cube.method == PenaltyMethod::continuous ? seen - fall / 2 : seen - fall;
}

}  // namespace enduring
