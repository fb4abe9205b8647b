#pragma once

#include "common/experiments/report/report.hpp"

#include <string>
#include <vector>

namespace enduring {

/// How far a free top's energy and angular momentum stray, relative to their first values.
struct TopDrift {
    double energy = 0;    ///< largest |E - E0| / E0 over the run
    double momentum = 0;  ///< largest |L - L0| / |L0|
};

/// Ways to step the rotation: the four that Bullet has, and ours.
enum class TopMethod { bullet_kept, bullet_explicit, bullet_implicit_world, bullet_implicit_body, ours };
const std::vector<TopMethod>& all_top_methods();
std::string name_of(TopMethod method);

/// Spins a box of 0.4 x 0.2 x 0.1 m and 1 kg at 5 rad/s about its middle axis, one per cent beside it. That
/// axis is unstable: the box tumbles over every few seconds, which is where steps show what they lose.
/// @param seconds  duration [s]
/// @param rate     steps a second [Hz]
TopDrift top_drift(TopMethod method, double seconds, double rate);

/// Every method at 60, 240 and 960 Hz over 10 s: method, rate_hz, energy_drift, momentum_drift.
Table top_drift_table();

/// Leaves that table as `top_drift`, and the drifts at 240 Hz as facts of `rigid`.
void report_top_drift(Report& report);

}  // namespace enduring
