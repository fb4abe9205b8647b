#include "chapters/08_contact_by_distance/experiments/forces.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/solver.hpp"

#include <memory>

namespace enduring::chapter09 {

/// Forces of pairs on what given motion squeezes: no step is short enough to keep such bodies apart.
void squeezed(const RunOptions& options, Report& report)
{
    using namespace chapter08::force_rows;
    const MakeSolver make = [](const ContactParameters& parameters) {
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};  // a row tells what is not solved
        return chapter09_solver(parameters, settings, std::make_shared<DeepSearch>());
    };
    report_rows(report, "squeezed", squeezed_kinds(), make, !options.quick);
}

}  // namespace enduring::chapter09
