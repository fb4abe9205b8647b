#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter07 {
namespace {

constexpr double drop_height = 0.1;  // [m]

/// What 100,000 steps do to the energy, and how hard they are to solve.
struct Endurance {
    double worst = 0;              ///< largest departure from the first energy, as a part of it
    long newton_steps = 0;         ///< most of any step
    long contacts = 0;             ///< steps in which the ground pushed
    double mean_newton_steps = 0;  ///< of those
};

Endurance endure(const ImplicitParticle& problem, int steps)
{
    Endurance endurance;
    ParticleState state{drop_height, 0};
    const double first = energy(state, problem);
    long all = 0;
    for (int i = 0; i < steps; ++i) {
        int newton_steps = 0;
        state = step(state, problem, &newton_steps);
        endurance.worst = std::max(endurance.worst, std::abs(energy(state, problem) / first - 1));
        endurance.newton_steps = std::max<long>(endurance.newton_steps, newton_steps);
        endurance.contacts += newton_steps > 0;
        all += newton_steps;
    }
    endurance.mean_newton_steps = static_cast<double>(all) /
                                  static_cast<double>(std::max(1L, endurance.contacts));
    return endurance;
}

/// The part of its height that the first bounce keeps; `top` knows the parabola of a flight.
template <class Problem, class Top>
double kept(const Problem& problem, double height, const Top& top)
{
    ParticleState state{height, 0};
    const double before = top(state);
    bool touched = false;
    for (int i = 0; i < 1000 && !(touched && state.height > 0); ++i) {
        state = step(state, problem);
        touched = touched || state.height < 0 || state.velocity > 0;
    }
    return state.height > 0 && state.velocity > 0 ? top(state) / before : 0;
}

/// The parabola through the heights of a flight: by end velocities it
/// runs half a step ahead of its velocities.
double top_of(const ParticleState& state, double gravity, double velocity)
{
    return state.height + velocity * velocity / (2 * gravity);
}

/// Least and most over heights that differ by less than the way of one step:
/// where in a step the ground is met is chance.
template <class Problem, class Top>
std::pair<double, double> kept_range(const Problem& problem, const Top& top)
{
    double least = 1e9, most = 0;
    for (int i = 0; i < 40; ++i) {
        const double part = kept(problem, drop_height * (1 + 0.005 * i), top);
        least = std::min(least, part);
        most = std::max(most, part);
    }
    return {100 * least, 100 * most};
}

void add_bounces(Table& table, double h)
{
    const ImplicitParticle by_end = particle_with(h, 0.5),
                           by_mean = particle_with(h, 0.5, PositionUpdate::mean_velocity);
    const double g = by_end.gravity, half_a_step = 0.5 * g * by_end.dt;
    const auto top_by_end = [=](const ParticleState& s) { return top_of(s, g, s.velocity - half_a_step); };
    const auto top_by_mean = [=](const ParticleState& s) { return top_of(s, g, s.velocity); };
    const ParticleProblem explicit_cpf{by_end.mass, by_end.stiffness, g, PenaltyMethod::continuous,
                                       by_end.dt};
    const auto [explicit_least, explicit_most] = kept_range(explicit_cpf, top_by_end);
    const auto [end_least, end_most] = kept_range(by_end, top_by_end);
    const auto [mean_least, mean_most] = kept_range(by_mean, top_by_mean);
    table.add({h, explicit_least, explicit_most, end_least, end_most, mean_least, mean_most});
}

void add_heights(Table& table, const char* method, const auto& problem)
{
    ParticleState state{drop_height, 0};
    for (int i = 0; i <= 200; ++i, state = step(state, problem))
        table.add({method, i * problem.dt, state.height});
}

}  // namespace

/// Moved by the mean velocity, a bounce costs nothing: energies over 100,000 steps; what the other two steps
/// keep; and chapter 1's drop (k = 1000 N/m, dt = 0.01 s) with all three.
void free_bounce(const RunOptions& options, Report& report)
{
    const int steps = options.quick ? 10000 : 100000;
    Table energies({"h", "energy_error", "contact_steps", "max_newton_steps", "mean_newton_steps"});
    Table bounces({"h", "explicit_least_percent", "explicit_most_percent", "end_least_percent",
                   "end_most_percent", "mean_least_percent", "mean_most_percent"});
    double worst = 0;
    for (const double h : {0.01, 0.1, 1.0, 10.0, 100.0}) {
        const Endurance endurance = endure(particle_with(h, 0.5, PositionUpdate::mean_velocity), steps);
        energies.add(
            {h, endurance.worst, endurance.contacts, endurance.newton_steps, endurance.mean_newton_steps});
        worst = std::max(worst, endurance.worst);
        add_bounces(bounces, h);
    }
    Table heights({"method", "time_s", "height_m"});
    const double h = 0.1;
    const ImplicitParticle by_end = particle_with(h, 0.5);
    add_heights(
        heights, "explicit",
        ParticleProblem{by_end.mass, by_end.stiffness, by_end.gravity, PenaltyMethod::continuous, by_end.dt});
    add_heights(heights, "end velocity", by_end);
    add_heights(heights, "mean velocity", particle_with(h, 0.5, PositionUpdate::mean_velocity));

    report.table("free_bounce", heights);
    report.table("free_bounce_energy", energies);
    report.page_table("free_bounce_energy", energies, 2);
    report.table("free_bounce_kept", bounces);
    report.page_table("free_bounce_kept", bounces, 3);
    report.fact("free_bounce", "worst_energy_error", worst, 1);
    report.fact("free_bounce", "steps", steps, 6);
    report.plot("chapters/07_implicit_contact/plots/free_bounce.gp");
}

}  // namespace enduring::chapter07
