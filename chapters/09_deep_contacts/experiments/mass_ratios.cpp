#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/loads.hpp"

#include <algorithm>
#include <functional>

namespace enduring::chapter09 {
namespace {

struct LoadCase {
    std::string name;
    double ratio;
    int cells;
    double gap;                         ///< below each body at first [m]
    std::function<Load(double dt)> at;  ///< a step
};

LoadCase pile_of(const std::string& name, std::vector<double> masses, int cells, double gap)
{
    const double ratio = *std::max_element(masses.begin(), masses.end()) / masses[0];
    return {name, ratio, cells, gap,
            [pile = Pile{std::move(masses), 1, cells, gap}](double dt) { return load_of(pile, dt); }};
}

std::vector<LoadCase> all_loads(bool quick)
{
    std::vector<LoadCase> cases;
    for (const double r : quick ? std::vector<double>{20000} : std::vector<double>{1000, 5000, 20000}) {
        for (const int cells : quick ? std::vector{1, 2} : std::vector{1, 2, 3})
            for (const double gap : quick ? std::vector{1e-3} : std::vector{0.0, 1e-3, 1e-2})
                cases.push_back(pile_of("heavy on light", {1, r}, cells, gap));
        if (!quick)
            cases.push_back(pile_of("light and heavy, three times", {1, r, 1, r, 1, r}, 1, 1e-4));
    }
    cases.push_back(pile_of("1 t on 0.05 kg", {0.05, 1000}, 1, 1e-3));
    for (const int cells : quick ? std::vector{1} : std::vector{1, 2})
        for (const double gap : quick ? std::vector{0.0} : std::vector{0.0, 1e-3})
            cases.push_back({"100 kg on four dice of 1 g", 1e5, cells, gap,
                             [cells, gap](double dt) { return block_on_dice(cells, gap, dt); }});
    return cases;
}

/// Of several runs the worst.
struct Worst {
    long runs = 0, rest = 0, told = 0;
    LoadOutcome of{};

    void take(const LoadOutcome& outcome)
    {
        ++runs;
        rest += outcome.rests();
        told += outcome.told_at > 0;
        of.height_mm = std::max(of.height_mm, outcome.height_mm);
        of.sunk_mm = std::max(of.sunk_mm, outcome.sunk_mm);
        of.sideways_mm = std::max(of.sideways_mm, outcome.sideways_mm);
        of.speed = std::max(of.speed, outcome.speed);
        of.gained = std::max(of.gained, outcome.gained);
        of.max_newton_steps = std::max(of.max_newton_steps, outcome.max_newton_steps);
        of.solves += outcome.solves;
        of.unconverged += outcome.unconverged;
    }
};

}  // namespace

/// Light bodies under heavy ones, over ratios, meshes, gaps and steps: does everything come to rest where it
/// should?
void mass_ratios(const RunOptions& options, Report& report)
{
    Table table({"scene", "ratio", "cells", "gap_mm", "dt_s", "chapter", "height_error_mm", "sunk_mm",
                 "sideways_mm", "speed_m_per_s", "energy_gain_j", "told_at_step", "newton_steps",
                 "max_newton_steps", "unconverged", "solves"});
    Table page({"scene", "ratio", "chapter", "runs", "at_rest", "height_error_mm", "sunk_mm", "sideways_mm",
                "speed_m_per_s", "told_gains", "max_newton_steps", "unconverged"});
    Worst all;
    const std::vector<LoadCase> cases = all_loads(options.quick);
    for (std::size_t first = 0, last = 0; first < cases.size(); first = last) {
        while (last < cases.size() && cases[last].name == cases[first].name &&
               cases[last].ratio == cases[first].ratio)
            ++last;
        for (const int chapter : {8, 9}) {
            Worst worst;
            for (std::size_t i = first; i < last; ++i)
                for (const double dt : options.quick ? std::vector{0.01} : std::vector{0.01, 0.002, 0.001}) {
                    Load load = cases[i].at(dt);
                    const LoadOutcome outcome = watch(load, chapter, options.quick ? 1 : 2);
                    table.add({cases[i].name, cases[i].ratio, static_cast<long>(cases[i].cells),
                               1000 * cases[i].gap, dt, static_cast<long>(chapter), outcome.height_mm,
                               outcome.sunk_mm, outcome.sideways_mm, outcome.speed, outcome.gained,
                               static_cast<long>(outcome.told_at), outcome.newton_steps,
                               outcome.max_newton_steps, outcome.unconverged, outcome.solves});
                    worst.take(outcome);
                    all.take(outcome);
                }
            page.add({cases[first].name, cases[first].ratio, static_cast<long>(chapter), worst.runs,
                      worst.rest, worst.of.height_mm, worst.of.sunk_mm, worst.of.sideways_mm, worst.of.speed,
                      worst.told, worst.of.max_newton_steps, worst.of.unconverged});
        }
    }
    report.table("mass_ratios", table);
    report.page_table("mass_ratios", page, 2);
    report.fact("mass_ratios", "runs", static_cast<double>(all.runs));
    report.fact("mass_ratios", "rest", static_cast<double>(all.rest));
    report.fact("mass_ratios", "told", static_cast<double>(all.told));
    report.fact("mass_ratios", "height_mm", all.of.height_mm, 2);
    report.fact("mass_ratios", "sunk_mm", all.of.sunk_mm, 2);
    report.fact("mass_ratios", "sideways_mm", all.of.sideways_mm, 2);
    report.fact("mass_ratios", "gained_j", all.of.gained, 2);
    report.fact("mass_ratios", "max_newton_steps", static_cast<double>(all.of.max_newton_steps));
    report.fact("mass_ratios", "solves", static_cast<double>(all.of.solves), 6);
    report.fact("mass_ratios", "unconverged", static_cast<double>(all.of.unconverged), 6);
}

}  // namespace enduring::chapter09
