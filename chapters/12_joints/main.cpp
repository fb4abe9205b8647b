#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "12_joints",
            "Chapter 12: joints",
            {
                {"pendulum", "a cube on a hinge: its period against the elliptic integral",
                 chapter12::pendulum},
                {"double_pendulum", "two bars: what becomes of their energy, over the step",
                 chapter12::double_pendulum},
                {"top", "Lagrange's top on a ball joint: its precession", chapter12::top},
                {"linkages", "slider-crank, four-bar, Watt's linkage and Cardan's joint: their paths",
                 chapter12::linkages},
                {"motor", "a motor with a largest force against a load", chapter12::motor},
                {"chain", "chains that hang and swing: their forces, and a heavy body at the end",
                 chapter12::chain},
                {"door", "a door with more hinges than it needs, and a weld that breaks", chapter12::door},
                {"rope", "a rope of links over a drum: which pull holds which by friction", chapter12::rope},
                {"crane", "a crane sets a load down on a soft slab: forces and sag by statics",
                 chapter12::crane},
                {"walker", "a machine of 12 bodies walks by a plan of its turns", chapter12::walker},
                {"gripper", "two fingers lift a box by friction alone", chapter12::gripper},
            },
        },
        [](const ContactParameters& parameters) { return chapter12_solver(parameters); });
}
