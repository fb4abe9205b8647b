#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/own_scene/own_scene.hpp"

#include <string>

namespace {

std::function<void(const enduring::RunOptions&, enduring::Report&)> artefact(const std::string& name)
{
    return [name](const enduring::RunOptions& options, enduring::Report& report) {
        enduring::chapter06::artefact(name, options, report);
    };
}

}  // namespace

int main(int argc, char** argv)
{
    using namespace enduring;
    const ChapterProgram program{
        "06_redefinition",
        "Chapter 6: redefinition",
        {
            {"through_the_side",
             "a wedge leaves a table by its side, and the top still holds it (thesis figure 6.1)",
             artefact("through_the_side")},
            {"hooked", "a cube that slides over triangles hooks in their edges (thesis figure 6.2)",
             artefact("hooked")},
            {"shifted", "a spike is pushed where it came in, not where it is (thesis figure 6.3)",
             artefact("shifted")},
            {"false_resolution", "a triangle turns a little, and its pair is lost (thesis figure 6.4)",
             artefact("false_resolution")},
            {"step_by_step", "how a pair gets another face, step by step (thesis figures 6.10-6.13)",
             chapter06::step_by_step},
            {"sliding",
             "a cube slides over triangles and over a soft bar without friction (thesis figures 7.8-7.12)",
             chapter06::sliding, takes_scene},
            {"mesh_slope",
             "friction on triangles: when the block of chapter 4 holds, and how it slides (thesis 7.3)",
             chapter06::mesh_slope},
            {"bunny_bowl", "a soft bunny falls into a bowl and comes to rest (thesis figures 7.13 and 7.14)",
             chapter06::bunny_bowl, takes_scene},
            {"cost",
             "what one pair takes, stage by stage, and what whole steps take (thesis figure 7.17, section 7.4)",
             chapter06::cost, takes_scene},
            {"bar_friction", "a cube comes to rest on the soft bar and stays (thesis figure 7.16)",
             chapter06::bar_friction},
            {"turntable", "loads that are held on what turns: how far they creep", chapter06::turntable},
            {"rolling",
             "a ball that rolls down a slope or turns on its spot: how much the lever of the start brakes it",
             chapter06::rolling},
            {"laid_block", "a limit: a block that is laid exactly on triangles", chapter06::laid_block},
            {"deep", "a limit: a contact too deep for its category to mean anything (thesis figure 6.9)",
             chapter06::deep},
        },
    };
    return run_chapter(argc, argv, program, chapter06_solver);
}
