#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/fast_shots.hpp"
#include "common/experiments/report/sweep.hpp"

namespace enduring::chapter08 {

/// Shots of 1 m/s to 1,000 m/s at a plate of 2 mm, held and free: how many come out on the other side.
void fast(const RunOptions& options, Report& report)
{
    const std::vector<FastVolley> volleys = fast_volleys();
    const unsigned shots = options.quick ? 2 : 20;
    const auto found = sweep<FastOutcome>(options, "fast", volleys.size(), [&](std::size_t i) {
        FastOutcome outcome;
        for (unsigned seed = 1; seed <= shots; ++seed)
            for (const double dt : {0.01, 0.002})
                outcome.add(shoot(volleys[i], dt, seed));
        return outcome;
    });
    if (!found)
        return;
    Table table(
        {"plate", "speed_m_per_s", "shots", "through", "deepest_mm", "max_energy_percent", "unsolved"});
    FastOutcome all, at_speed;  // from 100 m/s on
    for (std::size_t i = 0; i < volleys.size();) {
        FastOutcome row;
        const FastVolley& first = volleys[i];
        for (; i < volleys.size() && volleys[i].free_plate == first.free_plate &&
               volleys[i].speed == first.speed;
             ++i)
            row.add((*found)[i]);
        table.add({std::string(first.free_plate ? "free" : "held"), first.speed, row.shots, row.through,
                   1e3 * row.deepest_m, 100 * row.max_energy, row.unsolved});
        all.add(row);
        if (first.speed >= 100)
            at_speed.add(row);
    }
    report.table("fast", table);
    report.page_table("fast", table, 3);
    report.fact("fast", "shots", static_cast<double>(all.shots), 6);
    report.fact("fast", "shots_fast", static_cast<double>(at_speed.shots), 6);
    report.fact("fast", "through_fast", static_cast<double>(at_speed.through), 6);
    report.fact("fast", "through", static_cast<double>(all.through), 6);
    report.fact("fast", "deepest_mm", 1e3 * all.deepest_m, 2);
    report.fact("fast", "max_energy_percent", 100 * all.max_energy, 4);
    report.fact("fast", "unsolved", static_cast<double>(all.unsolved), 6);
}

}  // namespace enduring::chapter08
