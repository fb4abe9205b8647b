#pragma once

#include "common/experiments/run/run.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace enduring::chapter03 {

/// One drop of the bar on the cube: what is varied, the rest is the scene's.
struct BarDrop {
    PenaltyMethod method = PenaltyMethod::continuous;
    double dt = 0.008;        ///< [s]
    double stiffness = 5000;  ///< k of one pair [N/m]
    double turn_deg = 45;     ///< of the bar about the vertical
    std::string basis{};      ///< of the bar's elements, "linear" or "quadratic"; empty: the scene's
};

/// The thesis' elements, and those that many take for lighter work.
inline const std::array<std::string, 2> both_bases{"quadratic", "linear"};

/// What was seen in each step, between bar and cube alone.
struct BarRecord {
    std::vector<double> time;   ///< [s]
    std::vector<double> force;  ///< vertical, on the bar [N]
    std::vector<double> depth;  ///< sum over the pairs inside, positive [m]
    std::vector<int> pairs;     ///< inside
    double weight = 0;          ///< of the bar [N]
};

/// From here on the bar lies on the cube, and what still changes fast is jitter [s].
constexpr double at_rest_from = 2.5;

Scene load_bar_scene(const std::filesystem::path& file, const BarDrop& drop);
BarRecord drop_bar(const std::filesystem::path& file, const BarDrop& drop,
                   const std::vector<Probe*>& more_probes = {});

/// The stiffness [N/m] that keeps k dt^2 where quadratic elements tremble with DPF and lie still with CPF.
/// @param dt  [s]
double stiffness_between_limits(double dt);

/// Mean summed depths [m] of one drop with each method, at the stiffness between their limits.
struct DepthRatio {
    double discrete, continuous;
    double ratio() const { return continuous / discrete; }
};
DepthRatio depths_between_limits(const std::filesystem::path& file, double dt, const std::string& basis = {});

/// Jitter of the contact force at rest, as a share of the bar's weight. A bar that nothing carries, since it
/// fell off or sank through, does not lie still: it counts as 1.
double jitter_at_rest(const BarRecord& record);
/// Mean over the steps at rest.
double depth_at_rest(const BarRecord& record);
double pairs_at_rest(const BarRecord& record);
/// Mean over all steps with contact (as the thesis' figure 7.6 averages) [m].
double depth_in_contact(const BarRecord& record);

/// What the drops of nine turns came to at rest: medians, but for the least and the most.
struct NineDrops {
    double jitter, least_jitter, max_jitter;  ///< as a share of the weight
    double depth, pairs;                      ///< summed depth [m]
    long smooth, drops;                       ///< how many had a jitter below 1 %, of how many
};
/// Which pairs meet first depends on the last digit of everything, so one drop alone measures luck.
/// @param drop   its own turn does not count
/// @param quick  three turns only
NineDrops drop_nine_times(const std::filesystem::path& file, BarDrop drop, bool quick);

}  // namespace enduring::chapter03
