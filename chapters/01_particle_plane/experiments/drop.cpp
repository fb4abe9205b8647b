#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/01_particle_plane/settling.hpp"

namespace enduring::chapter01 {

/// Thesis figure 7.1: each method once below and once above its stable step.
void drop(const RunOptions&, Report& report)
{
    struct Case {
        std::string panel;
        PenaltyMethod method;
        double dt;
    };
    const std::vector<Case> cases{{"a", PenaltyMethod::continuous, 0.14},
                                  {"b", PenaltyMethod::continuous, 0.17},
                                  {"c", PenaltyMethod::discrete, 0.11},
                                  {"d", PenaltyMethod::discrete, 0.13}};
    const double duration = 10;  // [s]

    Table trajectories({"panel", "method", "dt_s", "time_s", "height_m"});
    Table outcome({"panel", "method", "dt_s", "outcome", "rest_m", "swing_m"});
    for (const Case& c : cases) {
        ParticleProblem problem;
        problem.method = c.method;
        problem.dt = c.dt;
        ParticleState state{0.1, 0};
        for (int i = 0; i * c.dt <= duration; ++i, state = step(state, problem))
            trajectories.add({c.panel, short_name(c.method), c.dt, i * c.dt, state.height});

        const bool at_rest = settles(problem);
        outcome.add({c.panel, short_name(c.method), c.dt, at_rest ? "settles" : "keeps bouncing",
                     at_rest ? Cell(resting_height(problem)) : Cell("-"), last_swing(problem)});
    }
    report.table("drop", trajectories);
    report.table("drop_outcome", outcome);
    report.page_table("drop_outcome", outcome);
    report.plot("chapters/01_particle_plane/plots/drop.gp");
}

}  // namespace enduring::chapter01
