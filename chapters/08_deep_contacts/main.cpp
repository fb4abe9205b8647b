#include "chapters/08_deep_contacts/experiments/experiments.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "08_deep_contacts",
            "Chapter 8: deep contacts",
            {
                {"deep", "a cube rams a block: its energy with and without asking the neighbours",
                 chapter08::deep},
                {"bunny_curve", "the curves in which a bunny and a bowl cross", chapter08::bunny_curve},
                {"tracing", "random overlaps, with ties and without: are all curves closed?",
                 chapter08::tracing},
                {"born_inside", "bodies that begin inside a floor: how they come out",
                 chapter08::born_inside},
                {"born_loaded", "scenes in which pairs are born at a depth: the energy that they bring",
                 chapter08::born_loaded},
                {"unpaired", "the course's scenes: is any vertex inside without a pair?",
                 chapter08::unpaired},
                {"cost", "what tracing takes of a step", chapter08::cost},
            },
        });
}
