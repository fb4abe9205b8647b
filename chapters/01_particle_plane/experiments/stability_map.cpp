#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/settling.hpp"
#include "common/experiments/report/growing_table.hpp"

namespace enduring::chapter01 {

/// Steps from far below to above both critical steps: what the spectral radius says, what the simulation
/// does, and which heights it still visits at the end.
void stability_map(const RunOptions& options, Report& report)
{
    const double shortest = 0.01, longest = 0.18;  // [s]; the critical steps are 0.115 and 0.141
    const int count = options.quick ? 60 : 240;

    GrowingTable map(report, "stability_map",
                     {"method", "dt_s", "spectral_radius", "predicted", "simulated", "swing_m"},
                     2 * static_cast<std::size_t>(count));
    Table visited({"method", "dt_s", "height_m"});
    long agree = 0;
    const auto word = [](bool at_rest) { return at_rest ? "settles" : "keeps bouncing"; };
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous})
        for (int i = 0; i < count; ++i) {
            ParticleProblem problem;
            problem.method = method;
            problem.dt = shortest + (longest - shortest) * i / (count - 1);
            const double radius =
                spectral_radius(amplification(method, problem.mass, problem.stiffness, problem.dt));
            const bool predicted = radius < 1, simulated = settles(problem);
            agree += predicted == simulated;
            map.add({short_name(method), problem.dt, radius, word(predicted), word(simulated),
                     last_swing(problem)});
            const std::vector<double> heights = last_heights(problem);
            for (std::size_t last = heights.size() - 40; last < heights.size(); ++last)
                visited.add({short_name(method), problem.dt, heights[last]});
        }
    report.table("stability_map", map);
    report.table("visited_heights", visited);
    report.fact("stability_map", "steps_tried", 2.0 * count, 4);
    report.fact("stability_map", "agree", static_cast<double>(agree), 4);
    report.plot("chapters/01_particle_plane/plots/stability_map.gp");
    report.plot("chapters/01_particle_plane/plots/visited_heights.gp");
}

}  // namespace enduring::chapter01
