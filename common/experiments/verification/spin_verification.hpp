#pragma once

#include "common/experiments/report/table.hpp"

namespace enduring::verification {

/// A free bar that starts as a rigid body spinning about its middle axis.
struct SpinningBar {
    bool freeze_rotations = false;
    double young = 1e6;      ///< [Pa]
    double omega_dt = 0.05;  ///< angle of one step [rad]
    double dt = 0.01;        ///< [s]
    int steps = 200;
};
struct SpinGrowth {
    double first_step = 0;          ///< relative growth of the energy in the first step
    double first_step_formula = 0;  ///< and what the stretch of a linearised rotation explains
    double largest = 0;             ///< of the energy over its start, over all steps
    double final_energy = 0;        ///< relative to the start
    double linear_momentum = 0;     ///< largest change, relative to mass times tip speed
    double angular_momentum = 0;    ///< final change, relative
};
SpinGrowth spin(const SpinningBar& bar);

/// The above over stiffnesses and angles. Columns young_pa, omega_dt, first_step_percent, formula_percent,
/// largest_percent, final_percent, angular_percent.
Table spinning_bar_growth();

}  // namespace enduring::verification
