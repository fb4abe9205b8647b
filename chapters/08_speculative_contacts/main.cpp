#include "chapters/08_speculative_contacts/experiments/experiments.hpp"
#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "08_speculative_contacts",
            "Chapter 8: speculative contacts",
            {
                {"heap", "cubes dropped on a heap", chapter08::heap},
                {"families",
                 "heaps at random of eight families of shapes: how deep they come into each other",
                 chapter08::families},
                {"ridges",
                 "ridges, corners and borders that come down on each other, from a centimetre above",
                 chapter08::ridges},
                {"fast", "shots of 1 m/s to 1,000 m/s at a plate of 2 mm: how many come through",
                 chapter08::fast},
                {"edge_on_edge", "cubes, bricks and beams laid exactly edge on edge: do they stand still?",
                 chapter08::edge_on_edge},
                {"at_rest", "a card house, an arch, spikes and wedges in cracks: do they come to rest?",
                 chapter08::at_rest},
                {"wedged", "a cube between two planes: from which angle on it wedges itself in",
                 chapter08::wedged},
                {"creep", "a soft cube on a slope of triangles, over its mesh, stiffness, step and mass",
                 chapter08::creep},
                {"wanted_depth",
                 "asked for a depth of a millimetre: is it reached, over masses, meshes and steps?",
                 chapter08::wanted_depth},
                {"rolling", "a ball on a slope: how fast it rolls", chapter08::rolling},
                {"facets", "prisms and balls: what flat sides cost a body that rolls", chapter08::facets},
                {"flat_triangles",
                 "triangles as flat as a plane: a slide without friction, and a block that is laid exactly",
                 chapter08::flat_triangles},
                {"frictionless",
                 "a block in a half pipe, a ball in a bowl, a soft cube on a slope: what a slide without friction costs",
                 chapter08::frictionless},
                {"screw", "a bolt without friction falls through its nut", chapter08::screw},
                {"tops", "tops that spin on their tips: how fast their axes go round", chapter08::tops},
                {"soft_piles", "sheets of soft elements over a ball, and stacks of soft blocks",
                 chapter08::soft_piles},
                {"turntable", "what rides on a table that turns: how far it creeps in a turn",
                 chapter08::turntable},
                {"spinning", "boxes that turn far in a step land: with whole steps, and with steps in parts",
                 chapter08::spinning},
                {"launch",
                 "a cube is launched up a slope: with which coefficient it stays where it turns round",
                 chapter08::launch},
                {"driven",
                 "bodies that are driven: given motion, a conveyor, forces, locked directions, materials",
                 chapter08::driven},
                {"bouncing",
                 "bodies that bounce: height kept, a cradle, a cube on its corner, soft cubes, a stack at rest",
                 chapter08::bouncing},
                {"harsh", "random scenes as harsh as a stranger's: energy, depth and solves of every step",
                 chapter08::harsh},
            },
        },
        [](const ContactParameters& parameters) { return chapter08_solver(parameters); });
}
