#pragma once

#include "common/experiments/report/table.hpp"

namespace enduring::verification {

/// First bending frequency of a slender clamped bar against Euler and Bernoulli; lumped_ratio is that of the
/// same body with the row sums of its mass matrix at the nodes. Columns basis, cells_along, unknowns,
/// frequency_hz, theory_hz, ratio, lumped_ratio.
Table bending_frequency();

/// First torsional frequency of a square clamped bar against Saint-Venant's torsion.
/// Columns basis, cells_across, unknowns, frequency_hz, theory_hz, ratio, lumped_ratio.
Table torsion_frequency();

/// Error after half a period of the bar's first mode against cos(omega t).
/// Columns steps_per_period, error, order.
Table convergence_in_time();

}  // namespace enduring::verification
