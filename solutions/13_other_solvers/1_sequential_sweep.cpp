#include "exercises/13_other_solvers/1_sequential_sweep.hpp"

#include <algorithm>
#include <cstddef>

namespace enduring {

double opening(const Column& column, int i)
{
    const auto n = static_cast<std::size_t>(i);
    const double below = n > 0 ? column.velocities[n - 1] : 0;
    return column.velocities[n] - below;
}

void solve_contact(Column& column, int i)
{
    const auto n = static_cast<std::size_t>(i);
    double response = 1 / column.masses[n];
    if (n > 0)
        response += 1 / column.masses[n - 1];
    const double before = column.impulses[n];
    column.impulses[n] = std::max(0.0, before - opening(column, i) / response);
    const double change = column.impulses[n] - before;
    column.velocities[n] += change / column.masses[n];
    if (n > 0)
        column.velocities[n - 1] -= change / column.masses[n - 1];
}

int sweeps_needed(Column& column, double tolerance)
{
    const int contacts = static_cast<int>(column.masses.size());
    for (int sweeps = 0;; ++sweeps) {
        double fastest = 0;
        for (int i = 0; i < contacts; ++i)
            fastest = std::max(fastest, -opening(column, i));
        if (fastest <= tolerance)
            return sweeps;
        for (int i = 0; i < contacts; ++i)
            solve_contact(column, i);
    }
}

Column falling_column(const std::vector<double>& masses, double dt, double part)
{
    Column column{masses, std::vector<double>(masses.size(), -9.81 * dt), std::vector<double>(masses.size())};
    double load = 0;
    for (std::size_t n = masses.size(); n-- > 0;) {
        load += masses[n];
        column.impulses[n] = part * load * 9.81 * dt;
        column.velocities[n] += column.impulses[n] / masses[n];
        if (n + 1 < masses.size())
            column.velocities[n] -= column.impulses[n + 1] / masses[n];
    }
    return column;
}

}  // namespace enduring
