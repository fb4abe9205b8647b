#include "chapters/12_joints/experiments/experiments.hpp"
#include "chapters/12_joints/experiments/rope_over_edge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {

/// A rope of links over a round edge: which pull at one end holds a pull at the other, by friction.
void rope(const RunOptions& options, Report& report)
{
    const double margin = options.quick ? 0.02 : 0.005, duration = options.quick ? 0.3 : 2;
    Table table({"angle_deg", "links", "friction", "exact_ratio", "capstan_ratio", "held_um", "slid_mm",
                 "joint_error_m"});
    double held = 0, slid = 1e9, error = 0, coarse = 0;
    for (const auto& [degrees, links, mu] :
         {std::tuple(180, 12, 0.1), std::tuple(180, 12, 0.3), std::tuple(180, 6, 0.3), std::tuple(90, 6, 0.3),
          std::tuple(90, 6, 0.5)}) {
        const RopeOverEdge shape{.angle = degrees * std::numbers::pi / 180, .links = links, .mu = mu};
        const double exact = largest_ratio(shape), smooth = std::exp(mu * shape.angle);
        const RopePull below = pull_rope(shape, exact * (1 - margin), duration),
                       above = pull_rope(shape, exact * (1 + margin), duration);
        table.add({static_cast<long>(degrees), static_cast<long>(links), mu, exact, smooth,
                   1e6 * below.displacement, 1e3 * above.displacement, std::max(below.error, above.error)});
        held = std::max(held, below.displacement);
        slid = std::min(slid, above.displacement);
        error = std::max({error, below.error, above.error});
        coarse = std::max(coarse, exact / smooth - 1);
    }
    report.table("rope", table);
    report.page_table("rope", table, 3);
    report.fact("rope", "margin_percent", 100 * margin, 2);
    report.fact("rope", "held_um", 1e6 * held, 2);
    report.fact("rope", "slid_mm", 1e3 * slid, 2);
    report.fact("rope", "joint_error_m", error, 2);
    report.fact("rope", "over_capstan_percent", 100 * coarse, 2);
}

}  // namespace enduring::chapter12
