#pragma once

#include "common/experiments/report/report.hpp"

namespace enduring::chapter04 {

/// A block of 0.2 m slides on a level plane while a sideways gravity turns round, once in `period` seconds.
struct Turn {
    double dt = 0.01, period = 4, seconds = 8;
    double sideways = 2;  ///< [m/s^2]
};

struct TurnRecord {
    Table table{{"time_s", "x_m", "z_m", "vx_m_per_s", "vz_m_per_s", "fx_n", "fz_n", "angle_error_deg"}};
    /// between friction and the opposite of the slip, over all pairs that slip and all steps
    double worst_angle_deg = 0;
};

TurnRecord drive_in_circles(const Turn& turn);

}  // namespace enduring::chapter04
