#include "exercises/13_other_solvers/1_sequential_sweep.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cstddef>

namespace enduring {

double opening(const Column& column, int i)
{
    not_implemented_yet("13.1");
}

void solve_contact(Column& column, int i)
{
    not_implemented_yet("13.1");
}

int sweeps_needed(Column& column, double tolerance)
{
    not_implemented_yet("13.1");
}

Column falling_column(const std::vector<double>& masses, double dt, double part)
{
    not_implemented_yet("13.1");
}

}  // namespace enduring
