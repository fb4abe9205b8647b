#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

namespace enduring::chapter08 {
namespace {

std::string in_words(chapter07::Tip tip, int tip_deg, int crack_deg)
{
    return std::string(tip == chapter07::Tip::spike ? "spike" : "wedge") + " of " + std::to_string(tip_deg) +
           "° in a crack of " + std::to_string(crack_deg) + "°";
}

std::vector<chapter07::RestRuns::Case> all_cases(double dt, bool quick)
{
    constexpr double stands_mm = 10;
    const double duration = quick ? 4 : 8;
    std::vector<chapter07::RestRuns::Case> cases;
    for (const int lean_deg : {15, 10, 20})
        if (!quick || lean_deg == 15)
            cases.push_back({"card house, cards at " + std::to_string(lean_deg) + "°",
                             chapter07::scene_of(chapter07::card_house(3, lean_deg), dt), duration,
                             lean_deg == 15, stands_mm});
    cases.push_back({"arch of 20 stones", chapter07::arch(20, 5, dt), duration, true, stands_mm});
    cases.push_back({"the same, every other stone 0.9 m deep", chapter07::arch(20, 5, dt, 0.9), duration,
                     false, stands_mm});
    for (const chapter07::Tip tip : {chapter07::Tip::spike, chapter07::Tip::wedge})
        for (const auto& [tip_deg, crack_deg] : {std::pair(70, 40), {70, 20}, {80, 60}, {33, 20}, {33, 60}}) {
            const bool pictured = tip == chapter07::Tip::spike ? tip_deg == 70 && crack_deg == 40
                                                               : tip_deg == 33;
            cases.push_back({in_words(tip, tip_deg, crack_deg),
                             chapter07::tip_in_crack(tip, tip_deg, crack_deg, dt), duration, pictured});
        }
    cases.push_back({"wedge on an edge", chapter07::wedge_on_edge(dt), 6, true});
    return cases;
}

}  // namespace

/// Buildings that should stand, and tips that should come to rest in cracks and on edges.
void at_rest(const RunOptions& options, Report& report)
{
    std::vector<double> steps{0.01, 1.0 / 60};
    if (options.quick)
        steps = {1.0 / 60};
    chapter07::RestRuns runs(report, "at_rest", chapter08_solver,
                             steps.size() * all_cases(steps.front(), options.quick).size());
    for (const double dt : steps)
        for (chapter07::RestRuns::Case& c : all_cases(dt, options.quick)) {
            c.pictured = c.pictured && dt == steps.front();
            runs.run(c);
        }
    runs.report("at_rest", report, 3);
}

}  // namespace enduring::chapter08
