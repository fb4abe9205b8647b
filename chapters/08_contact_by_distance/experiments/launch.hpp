#pragma once

namespace enduring::chapter08 {

/// Chapter 4's cube of 1 m and 100 kg on a slope, launched uphill or laid down.
struct Launch {
    double slope_deg, dt, mu_s, mu_d;
    double speed = 3;  ///< uphill [m/s]
};

/// Does it stay where it turns round: within a millimetre for two seconds, from half a second after on?
bool stays(const Launch& launch);

/// The smallest mu_s over tan with which four corners hold a cube, if a corner that has slipped has falls *
/// mu_s. The weight's lever takes load from the upper two; their friction springs carry as much as the
/// others, and slip first.
double weak_corners(double slope_deg, double falls);

}  // namespace enduring::chapter08
