#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

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
                {"way_out", "a cube over the rim of a block: the curve, what it bounds, and the way out",
                 chapter08::way_out},
                {"tracing", "random overlaps, with ties and without: are all curves closed?",
                 chapter08::tracing},
                {"born_inside", "bodies that begin inside something else: how they come out",
                 chapter08::born_inside},
                {"crossed_beams", "two beams that begin in each other, with no vertex inside",
                 chapter08::crossed_beams},
                {"born_loaded", "scenes in which pairs are born at a depth: the energy that they bring",
                 chapter08::born_loaded},
                {"mass_ratios", "light bodies under heavy ones, up to 25,000 times: do they come to rest?",
                 chapter08::mass_ratios},
                {"ways_compared", "three choices of the way out: wrong directions, and what they cost",
                 chapter08::ways_compared},
                {"thin", "shots at thin bodies: how many come out on the wrong side", chapter08::thin},
                {"unpaired", "the course's scenes: is any vertex inside without a pair?",
                 chapter08::unpaired},
                {"folding", "soft bodies that fold onto themselves", chapter08::folding},
                {"knot", "a rope with a knot is pulled tight and let go, with friction and nearly without",
                 chapter08::knot},
                {"round_turns", "a rope with one turn around its own end: how hard it has to be held back",
                 chapter08::round_turns},
                {"cost", "what tracing takes of a step", chapter08::cost},
            },
        },
        [](const ContactParameters& parameters) { return chapter08_solver(parameters); });
}
