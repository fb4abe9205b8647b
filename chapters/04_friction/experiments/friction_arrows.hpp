#pragma once

#include "common/experiments/render/film_probes.hpp"

namespace enduring::chapter04 {

/// At every pair with friction, the mean friction on body A over the step just done, in red.
/// @param metres_per_newton  of the arrows
/// @param dt                 [s]
MarkContacts friction_arrows(double metres_per_newton, double dt);

}  // namespace enduring::chapter04
