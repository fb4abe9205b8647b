#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

namespace enduring::chapter07 {

/// A particle is moved a little from its rest and let go: how much of the departure is left after each step.
void ring(const RunOptions&, Report& report)
{
    struct Case {
        double h, centre;
    };
    Table table({"h", "centre", "step", "left"});
    for (const auto& [h, centre] : {Case{1, 0.5}, Case{16, 0.5}, Case{100, 0.5}, Case{100, 1}}) {
        const ImplicitParticle problem = particle_with(h, centre);
        const double rest = -problem.mass * problem.gravity / problem.stiffness, departure = -0.01 * rest;
        ParticleState state{rest + departure, 0};
        for (long n = 0; n <= 20; ++n, state = step(state, problem))
            table.add({h, centre, n, (state.height - rest) / departure});
    }
    report.table("ring", table);
    report.plot("chapters/07_implicit_contact/plots/ring.gp");
}

}  // namespace enduring::chapter07
