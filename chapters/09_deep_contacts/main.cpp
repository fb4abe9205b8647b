#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

int main(int argc, char** argv)
{
    using namespace enduring;
    return run_chapter(
        argc, argv,
        {
            "09_deep_contacts",
            "Chapter 9: deep contacts",
            {
                {"deep", "a cube rams a block: its energy with four chapters' solvers", chapter09::deep},
                {"bunny_curve", "the curves in which a bunny and a bowl cross", chapter09::bunny_curve},
                {"separation_direction",
                 "a cube over the rim of a block: the curve, what it bounds, and the separation direction",
                 chapter09::separation_direction},
                {"tracing", "random overlaps, with ties and without: are all curves closed?",
                 chapter09::tracing},
                {"initial_overlap", "bodies that begin inside something else: how they come out",
                 chapter09::initial_overlap},
                {"crossed_beams", "two beams that begin in each other, with no vertex inside",
                 chapter09::crossed_beams},
                {"born_loaded", "scenes in which pairs begin at a depth: the energy that they bring",
                 chapter09::born_loaded},
                {"squeezed", "forces on what vices and grippers squeeze", chapter09::squeezed},
                {"mass_ratios", "light bodies under heavy ones, up to 25,000 times: do they come to rest?",
                 chapter09::mass_ratios},
                {"separation_methods",
                 "three choices of the separation direction: how many vertices get a wrong one",
                 chapter09::separation_methods},
                {"thin", "shots at thin bodies: how many come out on the wrong side", chapter09::thin},
                {"missed_vertices", "the course's scenes: is any vertex inside without a pair?",
                 chapter09::missed_vertices},
                {"cost", "what tracing takes of a step", chapter09::cost},
            },
        },
        [](const ContactParameters& parameters) { return chapter09_solver(parameters); });
}
