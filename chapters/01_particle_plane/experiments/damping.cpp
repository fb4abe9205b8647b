#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "chapters/01_particle_plane/particle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter01 {
namespace {

/// Tops of the flights [m]: the drop, then one for each bounce that leaves the ground.
std::vector<double> tops_of_flights(const ParticleProblem& problem, double drop_height, int steps)
{
    std::vector<double> tops;
    ParticleState state{drop_height, 0};
    bool flying = false;
    for (int i = 0; i < steps; ++i) {
        const bool out = state.height > 0 && state.velocity > 0;
        if (i == 0 || (out && !flying))
            tops.push_back(top_of_flight(state, problem));
        flying = state.height > 0;
        state = step(state, problem);
    }
    return tops;
}

/// After this time [s] the height never strays further than `tolerance` [m] from rest.
double time_to_rest(const ParticleProblem& problem, double drop_height, double tolerance, int steps)
{
    const double rest = resting_height(problem);
    ParticleState state{drop_height, 0};
    int last_away = 0;
    for (int i = 1; i <= steps; ++i) {
        state = step(state, problem);
        if (std::abs(state.height - rest) > tolerance)
            last_away = i;
    }
    return last_away * problem.dt;
}

/// One row a step of the first visit to the ground: where the particle was in the middle of it,
/// and its mean force. Symplectic Euler's height runs half a step ahead of its velocity. Over
/// the height taken back by half a step the area inside the loop is the energy that the visit
/// costs, exactly: its change in a step is dt (v + v_next) / 2.
void add_first_contact(Table& table, const ParticleProblem& problem, double drop_height)
{
    ParticleState state{drop_height, 0};
    for (bool touched = false; !touched || state.height < 0;) {
        const ParticleState next = step(state, problem);
        const double force = problem.mass * ((next.velocity - state.velocity) / problem.dt + problem.gravity);
        touched = touched || next.height < 0;
        const double middle = 0.5 * (state.height + next.height) -
                              0.25 * problem.dt * (state.velocity + next.velocity);
        if (touched)
            table.add({short_name(problem.method), middle, force});
        state = next;
    }
}

//! [measured_decay]
/// The factor on the amplitude a step, read off the simulation alone: four heights of
/// a swing about rest tell the trace and the determinant in y2 = trace y1 -
/// determinant y0, and the determinant is the factor squared.
double measured_decay(const ParticleProblem& problem, double drop_height)
{
    const double rest = resting_height(problem);
    ParticleState state = simulate({drop_height, 0}, problem, 400);  // past the last bounce, before rounding
    double y[4];
    for (double& offset : y) {
        offset = state.height - rest;
        state = step(state, problem);
    }
    const double determinant = (y[2] * y[2] - y[1] * y[3]) / (y[1] * y[1] - y[0] * y[2]);
    return std::sqrt(determinant);
}
//! [measured_decay]

void report_facts(Report& report, const ParticleProblem& problem, const std::vector<double>& tops,
                  double rest)
{
    const std::string name = problem.method == PenaltyMethod::discrete ? "dpf" : "cpf";
    report.fact("damping", name + "_kept_percent", 100 * tops[1] / tops[0]);
    report.fact("damping", name + "_bounces", static_cast<double>(tops.size() - 1), 3);
    report.fact("damping", name + "_rest_mm", 1000 * rest, 4);
    report.fact("damping", name + "_time_to_rest", time_to_rest(problem, 0.1, 1e-4, 2000));
}

}  // namespace

/// Thesis figure 7.2: k = 1000 N/m, dt = 0.01 s, a step four times below the stable ones.
void damping(const RunOptions&, Report& report)
{
    Table trajectories({"method", "time_s", "height_m"});
    Table loops({"method", "height_m", "force_n"});
    Table bounces({"method", "bounce", "top_mm", "kept_percent"});
    Table decays({"method", "rho", "measured_rho", "damping_ratio", "swing_kept_percent"});
    Table rest_table({"method", "rest_mm", "predicted_mm", "minus_mg_over_k_mm"});
    for (const PenaltyMethod method : {PenaltyMethod::discrete, PenaltyMethod::continuous}) {
        ParticleProblem problem;
        problem.method = method;
        problem.stiffness = 1000;
        ParticleState state{0.1, 0};
        for (int i = 0; i <= 300; ++i, state = step(state, problem))
            trajectories.add({short_name(method), i * problem.dt, state.height});

        add_first_contact(loops, problem, 0.1);
        const std::vector<double> tops = tops_of_flights(problem, 0.1, 2000);
        for (std::size_t bounce = 1; bounce < std::min<std::size_t>(tops.size(), 6); ++bounce)
            bounces.add({short_name(method), static_cast<long>(bounce), 1000 * tops[bounce],
                         100 * tops[bounce] / tops[bounce - 1]});

        const double rest = simulate({0.1, 0}, problem, 5000).height;
        rest_table.add({short_name(method), 1000 * rest, 1000 * resting_height(problem),
                        -1000 * problem.mass * problem.gravity / problem.stiffness});
        const Decay swing = decay(amplification(method, problem.mass, problem.stiffness, problem.dt));
        decays.add({short_name(method), swing.per_step, measured_decay(problem, 0.1),
                    -std::log(swing.per_contact) / std::numbers::pi, 100 * swing.per_contact});
        report_facts(report, problem, tops, rest);
    }
    report.table("damping", trajectories);
    report.table("force_loop", loops);
    report.table("damping_bounces", bounces);
    report.page_table("damping_bounces", bounces);
    report.table("damping_decay", decays);
    report.page_table("damping_decay", decays, 4);
    report.table("damping_rest", rest_table);
    report.page_table("damping_rest", rest_table, 4);
    report.plot("chapters/01_particle_plane/plots/damping.gp");
    report.plot("chapters/01_particle_plane/plots/force_loop.gp");
}

}  // namespace enduring::chapter01
