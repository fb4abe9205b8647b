#include "exercises/13_other_solvers/1_sequential_sweep.hpp"

#include <cmath>
#include <numeric>

namespace enduring {
namespace {

double inverse_mass(const Column& column, int body)
{
    return body < 0 ? 0.0 : 1 / column.masses.at(static_cast<std::size_t>(body));
}
double velocity(const Column& column, int body)
{
    return body < 0 ? 0.0 : column.velocities.at(static_cast<std::size_t>(body));
}

}  // namespace

double opening(const Column& column, int i) { return velocity(column, i) - velocity(column, i - 1); }

/// By cases: what a contact can give back at most is what it has pushed.
void solve_contact(Column& column, int i)
{
    double& sum = column.impulses.at(static_cast<std::size_t>(i));
    double push = -opening(column, i) / (inverse_mass(column, i) + inverse_mass(column, i - 1));
    if (push < -sum)
        push = -sum;
    sum += push;
    column.velocities.at(static_cast<std::size_t>(i)) += push * inverse_mass(column, i);
    if (i > 0)
        column.velocities.at(static_cast<std::size_t>(i - 1)) -= push * inverse_mass(column, i - 1);
}

int sweeps_needed(Column& column, double tolerance)
{
    const int contacts = static_cast<int>(column.masses.size());
    const auto approaches = [&] {
        for (int i = 0; i < contacts; ++i)
            if (opening(column, i) < -tolerance)
                return true;
        return false;
    };
    int sweeps = 0;
    while (approaches()) {
        for (int i = 0; i < contacts; ++i)
            solve_contact(column, i);
        ++sweeps;
    }
    return sweeps;
}

/// With all of its impulses a column stands; so with a part of them each cube keeps the other part of its
/// fall.
Column falling_column(const std::vector<double>& masses, double dt, double part)
{
    const double fall = 9.81 * dt;
    Column column{masses, std::vector<double>(masses.size(), -(1 - part) * fall), {}};
    for (auto from = masses.begin(); from != masses.end(); ++from)
        column.impulses.push_back(part * fall * std::accumulate(from, masses.end(), 0.0));
    return column;
}

}  // namespace enduring
