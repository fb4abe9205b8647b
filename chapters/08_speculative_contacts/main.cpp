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
                {"heap", "cubes that fall on a heap: pairs, depths and rest, beside chapter 7's solver",
                 chapter08::heap},
                {"families",
                 "heaps at random of eight families of shapes: how deep they come into each other",
                 chapter08::families},
                {"ridges",
                 "ridges, corners and borders that come down on each other, from a centimetre above",
                 chapter08::ridges},
                {"fast", "shots of 1 m/s to 1,000 m/s at a plate of 2 mm: how many come through",
                 chapter08::fast},
            },
        },
        [](const ContactParameters& parameters) { return chapter08_solver(parameters); });
}
