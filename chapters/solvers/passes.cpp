#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"

namespace enduring::solvers {

/// chapter, stage, pass: what every chapter's solver runs, in this order.
/// The pages' "What changed" is read from it.
void passes(const RunOptions&, Report& report)
{
    const std::vector<std::pair<StepStage, std::string>> stages{{StepStage::refresh, "refresh"},
                                                                {StepStage::detect, "detect"},
                                                                {StepStage::respond, "respond"},
                                                                {StepStage::finish, "finish"},
                                                                {StepStage::after_commit, "after_commit"}};
    ContactParameters parameters;
    parameters.friction = MassSplitting{};
    Table table({"chapter", "stage", "pass"});
    for (int chapter = 1; chapter <= chapters; ++chapter) {
        const Solver solver = chapter_solver(chapter, parameters);
        for (const auto& [stage, name] : stages)
            for (const Pass& pass : solver.passes(stage))
                table.add({static_cast<long>(chapter), name, pass.name});
    }
    report.table("passes", table);
}

}  // namespace enduring::solvers
