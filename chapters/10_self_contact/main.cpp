#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "10_self_contact",
            "Chapter 10: self-contact",
            {
                {"folding", "soft bodies that fold onto themselves", chapter10::folding},
                {"knot", "a rope with a knot is pulled tight and let go, with friction and nearly without",
                 chapter10::knot},
                {"capstan", "a rope with one turn around its own end: how hard it has to be held back",
                 chapter10::capstan},
                {"cost", "what looking for a body's contact with itself takes of a step", chapter10::cost},
            },
        },
        [](const ContactParameters& parameters) { return chapter10_solver(parameters); });
}
