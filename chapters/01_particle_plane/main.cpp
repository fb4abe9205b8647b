#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "01_particle_plane",
            "Chapter 1: a particle and a plane",
            {
                {"two_looks", "three steps of a particle, and what each method makes of them",
                 chapter01::two_looks},
                {"drop", "a particle dropped below and above the stable step (thesis figure 7.1)",
                 chapter01::drop},
                {"stability_map", "spectral radius and simulation over the step, for both methods",
                 chapter01::stability_map},
                {"critical_step", "the largest step that settles: derived, and found by bisection",
                 chapter01::critical_step},
                {"damping",
                 "how much of each bounce is kept, and where the particle rests (thesis figure 7.2)",
                 chapter01::damping},
                {"ground", "a deformable bar and a rigid cube dropped on the plane (thesis equation 5.20)",
                 chapter01::ground, takes_scene},
            },
        },
        chapter01_solver);
}
