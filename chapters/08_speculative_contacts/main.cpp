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
            },
        },
        [](const ContactParameters& parameters) { return chapter08_solver(parameters); });
}
