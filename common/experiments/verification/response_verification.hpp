#pragma once

#include "common/experiments/report/report.hpp"

/// An experiment on how deformable bodies answer impulses. The tests
/// assert its outcome, and the book shows the table.
namespace enduring::verification {

/// A free bar of 3 x 0.4 x 0.4 m is pushed once, sideways at the middle of a long edge: what it
/// gains of the push's angular momentum about its own axis and of the push's work, as kinetic
/// energy at once, and as all energy at the end of the step. Columns response, basis,
/// cells_across, angular_percent, kinetic_percent, energy_percent.
Table pushed_bar();

}  // namespace enduring::verification
