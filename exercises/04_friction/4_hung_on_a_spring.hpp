#pragma once

namespace enduring {

/// Your prediction, written down before anything is measured: how many times the tangent of the slope mu_s
/// has to be, so that an anchor without a damper holds a block that is set down on it.
double predicted_ratio();

/// Does the thesis' friction hold a block that is set down on a slope, at rest and with an unstretched
/// spring? The block is one pair: mass 1 kg, normal force m g cos(alpha), spring 1000 N/m, mu_d = mu_s.
///
/// @param ratio    mu_s over the tangent of the slope
/// @param damping  zeta, the damper over the critical one 2 sqrt(k m)
/// @return         whether the pair never lets go during 2 s in steps of 0.1 ms
bool holds_the_block(double ratio, double damping);

/// The smallest ratio that holds, between 1 and 3, by bisection to 0.001.
double smallest_ratio(double damping);

/// The law: the peak of spring and damper together, over the weight along the slope.
/// @param damping  in [0, 1)
double overshoot_law(double damping);

}  // namespace enduring
