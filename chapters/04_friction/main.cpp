#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "04_friction",
            "Chapter 4: friction",
            {
                {"slope", "a cube is pushed up a slope, and slides back or stays (thesis figure 7.15)",
                 chapter04::slope, takes_scene},
                {"printed_constants", "what the thesis' k_fp = 100 and k_fd = 25 do, read in six ways",
                 chapter04::printed_constants},
                {"threshold",
                 "the smallest mu_s that holds a block, over angle, step and damping (thesis 7.3)",
                 chapter04::threshold},
                {"tilting", "the angle at which a block and a cube slide on a ramp that tilts",
                 chapter04::tilting},
                {"rocking", "why a launched cube needs more friction than a block", chapter04::rocking},
                {"turning", "friction against slip whose direction turns", chapter04::turning},
                {"mesh_slope", "the block on a slope of triangles: pairs that hook (thesis 6.1.2)",
                 chapter04::mesh_slope, takes_scene},
            },
        },
        chapter04_solver);
}
