#pragma once

namespace enduring::chapter07 {

/// A wheel of 0.1 m that rolls to the right at 2 m/s: how far the lever of the vertex that carries it at the
/// end of a step is ahead of the centre, as a mean over all turns of the wheel [m].
/// @param tau  moment of the step whose levers are taken: 0 start, 1 end
double mean_ahead(double tau, double dt);

}  // namespace enduring::chapter07
