#include "exercises/03_penalty_impulses/4_depth_at_rest.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>

namespace enduring {

double predicted_factor() { return 4; }

double depth_at_rest(const RestingCube& cube)
{
    Scene scene = cube_on_floor(cube);
    const Solver solver = chapter03_solver(scene.contact);
    Contacts contacts;
    for (int i = 0; i < step_count(scene); ++i)
        advance(scene.world, contacts, solver, scene.dt);
    double lowest = 0;
    for (const Vec3& x : scene.world.bodies[1]->positions_t0())
        lowest = std::min(lowest, x.y());
    return -lowest;
}

double measured_factor(RestingCube cube, int other_cells)
{
    const double depth = depth_at_rest(cube);
    cube.cells = other_cells;
    return depth / depth_at_rest(cube);
}

double law_of_depth(const RestingCube& cube)
{
    const int pairs = (cube.cells + 1) * (cube.cells + 1);
    const double looked_ahead = look_ahead(cube.method) * cube_gravity * cube.dt * cube.dt;
    return cube.mass * cube_gravity / (pairs * cube.stiffness) - looked_ahead;
}

}  // namespace enduring
