#pragma once

#include "common/experiments/report/report.hpp"

namespace enduring::engines {

/// A part of measured(): the pyramid of more and more cubes, from growth.csv in chapters/engines/measured.
/// Leaves the tables growing and a plot.
void measured_growth(Report& report);

}  // namespace enduring::engines
