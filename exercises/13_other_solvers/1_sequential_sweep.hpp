#pragma once

#include <vector>

namespace enduring {

/// Cubes on one another in a column, which move up and down alone. Contact i lies below cube i: contact 0 on
/// the ground, which does not move. All three lists are equally long.
struct Column {
    std::vector<double> masses;      ///< [kg], from below
    std::vector<double> velocities;  ///< [m/s], positive upwards
    std::vector<double> impulses;    ///< of the contacts in this step so far [N s], none negative
};

/// The velocity with which contact i opens [m/s]; negative while its two sides approach.
double opening(const Column& column, int i);

/// Makes the velocity of contact i zero where it can, as if all other contacts stayed: changes its impulse,
/// and the velocities of both its cubes. The sum of impulses of a contact never pulls; a contact that opens
/// gives back what it has pushed, and no more.
void solve_contact(Column& column, int i);

/// How many sweeps over all contacts, from below, it takes until no contact approaches faster than
/// `tolerance` [m/s]; 0 if none does before.
/// @param column  changed by the sweeps
int sweeps_needed(Column& column, double tolerance);

/// The column in which each cube has the velocity that gravity of 9.81 m/s^2 has given it in dt [s], and the
/// contacts begin with a part of the impulses that carry the column at rest: none for part = 0, all for 1.
Column falling_column(const std::vector<double>& masses, double dt, double part);

}  // namespace enduring
