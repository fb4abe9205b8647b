#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "chapters/02_collision_detection/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    chapter02::QueryMode queries;
    return run_chapter(
        argc, argv,
        {
            .folder = "02_collision_detection",
            .title = "Chapter 2: finding collisions",
            .experiments =
                {
                    {"gallery", "each elementary case before, at and after the touch, as pictures",
                     chapter02::gallery},
                    {"degenerate", "hard cases: what the textbook answers, what the certified query does",
                     chapter02::degenerate},
                    {"pruning", "pairs and time of all pairs, of boxes and of the tree, against mesh size",
                     chapter02::pruning},
                    {"cost", "what a query costs over the pairs that survive the boxes in two scenes",
                     chapter02::cost},
                },
            .add_options = [&](CLI::App& app) { queries.add_options(app); },
            .instead_of_experiments = [&](const RunOptions&) { return queries.run(); },
        },
        chapter02_solver);
}
