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
                {"stack", "stacks of cubes, equal and 1000 : 1, with nothing to choose", chapter07::stack},
                {"scales", "a stack of four in sizes from a millimetre to a hundred metres",
                 chapter07::scales},
                {"edge_on_edge", "cubes, bricks and beams laid exactly edge on edge: do they stand still?",
                 chapter07::edge_on_edge},
                {"slope", "a cube on a slope: from which coefficient it holds, and how fast it slides",
                 chapter07::slope},
                {"rolling", "a ball on a slope: how fast it rolls", chapter07::rolling},
                {"heap", "cubes dropped on a heap", chapter07::heap},
                {"at_rest", "a card house, an arch, spikes and wedges in cracks: do they come to rest?",
                 chapter07::at_rest},
                {"soft_at_rest", "a ton on a soft block, and soft bunnies in a bowl: do they come to rest?",
                 chapter07::soft_at_rest},
                {"wedged", "a cube between two planes: from which angle on it wedges itself in",
                 chapter07::wedged},
                {"creep", "a soft cube on a slope of triangles, over its mesh, stiffness, step and mass",
                 chapter07::creep},
                {"wanted_depth",
                 "asked for a depth of a millimetre: is it reached, over masses, meshes and steps?",
                 chapter07::wanted_depth},
                {"flat_triangles",
                 "triangles as flat as a plane: a slide without friction, and a block that is laid exactly",
                 chapter07::flat_triangles},
                {"frictionless",
                 "a block in a half pipe, a ball in a bowl, a soft cube on a slope: what a slide without friction costs",
                 chapter07::frictionless},
                {"screw", "a bolt without friction falls through its nut", chapter07::screw},
                {"turntable", "what rides on a table that turns: how far it creeps in a turn",
                 chapter07::turntable},
                {"free_collision",
                 "two free blocks slide along each other: what they gain in momentum together",
                 chapter07::free_collision},
                {"spinning", "boxes that turn far in a step land: with whole steps, and with steps in parts",
                 chapter07::spinning},
                {"same_bytes", "the same boxes in another order in their scene", chapter07::same_bytes},
                {"launch",
                 "a cube is launched up a slope: with which coefficient it stays where it turns round",
                 chapter07::launch},
                {"facets", "prisms and balls: what flat sides cost a body that rolls", chapter07::facets},
            },
        },
        [](const ContactParameters& parameters) { return chapter07_solver(parameters); });
}
