#pragma once

#include "chapters/03_penalty_impulses/penetration.hpp"

namespace enduring {

/// The same impulse as continuous_impulse, with the unit normal at every time instead of the
/// constant length L_k: the rational integrand of thesis (5.12), by Gauss quadrature in
/// pieces. Slow; it is what the closed form is measured by.
///
/// @param pieces  of each penetration interval, with 15 points each
Vec3 exact_impulse(const PairStep& step, double start, double k, double dt, int pieces = 8);

}  // namespace enduring
