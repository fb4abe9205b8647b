#pragma once

#include "common/experiments/report/report.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

#include <array>
#include <string>

namespace enduring::chapter06 {

/// Those of the two curves.
inline constexpr std::array<FrictionCoefficients, 2> bar_coefficients{{{0.4, 0.3}, {0.2, 0.15}}};

/// Scene bar_friction with these coefficients.
/// @param basis  of the bar's elements, "linear" or "quadratic"
Scene scene_of(const FrictionCoefficients& mu, const std::string& basis = "quadratic");

/// How the cube comes to rest on the bar.
struct RestOnBar {
    double way = 0;    ///< from its start to its place at the end [m]
    double drift = 0;  ///< largest distance from its place after `settled` steps, in the steps after [m]
};

/// Runs the scene.
/// @param settled, steps  the drift is counted from the one on; the run has the other
/// @param moments         gets mu_static, time_s, x_m, speed_m_per_s, drift_m; may be null
/// @param other           one more probe; may be null
RestOnBar rest_on_bar(Scene& scene, int settled, int steps, Table* moments = nullptr, Probe* other = nullptr);

}  // namespace enduring::chapter06
