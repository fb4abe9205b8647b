#include "exercises/01_particle_plane/3_stiffness_for_a_step.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enduring {

/// The largest h = k dt^2 / m that is stable, by the chapter's condition (1 + 2a) h < 4.
static double largest_h(PenaltyMethod method) { return 4 / (1 + 2 * look_ahead(method)); }

double stiffness_for_step(std::span<const double> masses, double dt, PenaltyMethod method, double safety)
{
    not_implemented_yet("1.3");
}

double depth_at_rest(double dt, PenaltyMethod method, double safety, double gravity)
{
    not_implemented_yet("1.3");
}

double step_for_depth(double depth, double safety, double gravity)
{
    not_implemented_yet("1.3");
}

}  // namespace enduring
