#pragma once

#include <vector>

namespace enduring::chapter03 {

/// How much of a force changes its mind from step to step, as a share of a weight.
///
/// The second difference F(i-1) - 2 F(i) + F(i+1) of a force that alternates by +-a is 4a, of a smooth one it
/// is nearly nothing; a quarter of its root mean square is therefore the height of the alternation.
/// @param forces  one a step [N], at least three
/// @param weight  [N], positive
double jitter(const std::vector<double>& forces, double weight);

double median(std::vector<double> values);

}  // namespace enduring::chapter03
