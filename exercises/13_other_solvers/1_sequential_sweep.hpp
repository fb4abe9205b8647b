#pragma once

#include <vector>

namespace enduring {

/// A column of cubes that move only up and down. Contact i is below cube i; contact 0 is on the ground, which
/// does not move. All three lists have the same length.
struct Column {
    std::vector<double> masses;      ///< [kg], from bottom to top
    std::vector<double> velocities;  ///< [m/s], positive upwards
    std::vector<double> impulses;    ///< of the contacts in this step so far [N s], none negative
};

/// The velocity with which contact i opens [m/s]; negative while its two sides approach.
double opening(const Column& column, int i);

/// Makes the velocity of contact i zero if possible, as if all other contacts stayed fixed: changes its
/// impulse and the velocities of both its cubes. The sum of the impulses of a contact never pulls; a contact
/// that opens takes back at most its earlier impulses.
void solve_contact(Column& column, int i);

/// The number of sweeps over all contacts, from bottom to top, until no contact approaches faster than
/// `tolerance` [m/s]; 0 if no contact does so before the first sweep.
/// @param column  changed by the sweeps
int sweeps_needed(Column& column, double tolerance);

/// The column after gravity of 9.81 m/s^2 has acted for dt [s]. The contacts have applied a part of the
/// impulses that carry the column at rest: none for part = 0, all for part = 1.
Column falling_column(const std::vector<double>& masses, double dt, double part);

}  // namespace enduring
