#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "07_implicit_contact",
            "Chapter 7: implicit contact",
            {
                {"implicit_map",
                 "spectral radius of the implicit step over the stiffness, for several weights",
                 chapter07::implicit_map},
                {"ring",
                 "what is left of a departure from rest after each step: the fastest, and the one that rings",
                 chapter07::ring},
                {"free_bounce", "a bounce that costs nothing, over 100,000 steps", chapter07::free_bounce},
                {"residual",
                 "the hardest steps of three scenes: residual over work, with and without each help",
                 chapter07::residual},
                {"stack", "stacks of cubes, equal and 1000 : 1, with nothing to choose", chapter07::stack},
                {"scales", "a stack of four in sizes from a millimetre to a hundred metres",
                 chapter07::scales},
                {"slope", "a cube on a slope: from which coefficient it holds, and how fast it slides",
                 chapter07::slope},
                {"soft_at_rest", "a ton on a soft block, and soft bunnies in a bowl: do they come to rest?",
                 chapter07::soft_at_rest},
                {"defeated", "spikes in cracks, edges on edges, heaps and laid boxes: how deep they come",
                 chapter07::defeated},
                {"free_collision",
                 "two free blocks slide along each other: what they gain in momentum together",
                 chapter07::free_collision},
                {"levers",
                 "a rolling wheel: where the vertex that carries it is in the step, and what this costs",
                 chapter07::levers},
                {"determinism", "the same boxes in another order in their scene", chapter07::determinism},
            },
        },
        [](const ContactParameters& parameters) { return chapter07_solver(parameters); });
}
