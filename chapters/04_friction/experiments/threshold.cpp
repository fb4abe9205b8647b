#include "chapters/04_friction/experiments/experiments.hpp"
#include "chapters/04_friction/experiments/launch.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter04 {
namespace {

constexpr double block_mass = 100, block_pairs = 4, stiffness = 20000;

double tangent(double angle_deg) { return std::tan(angle_deg * std::numbers::pi / 180); }

/// The thesis' model with a spring that the steps below resolve, and the
/// damper of a given ratio n k_FD / (2 sqrt(n k_FP m)).
FrictionParameters printed_model(double damping_ratio)
{
    constexpr double spring = 5000;
    return YamaneNakamura{
        .spring = spring,
        .damper = damping_ratio * 2 * std::sqrt(block_pairs * spring * block_mass) / block_pairs};
}

/// The largest force of a spring and damper that catch a weight, relative to that weight: they start
/// unstretched, and overshoot by exp(-2 z acos(z) / sqrt(1 - z^2)).
//! [overshoot]
double peak_over_weight(double damping_ratio)
{
    const double z = damping_ratio, root = std::sqrt(std::abs(1 - z * z));
    const double turn = root < 1e-6 ? 1 : (z < 1 ? std::acos(z) : std::acosh(z)) / root;
    return 1 + std::exp(-2 * z * turn);
}
//! [overshoot]

struct ThresholdSeries {
    std::string model;
    double damping_ratio;
    FrictionParameters friction;
};

std::vector<ThresholdSeries> all_series(bool quick)
{
    std::vector<ThresholdSeries> all;
    for (const double ratio : quick ? std::vector{0.25, 1.0} : std::vector{0.05, 0.25, 0.5, 1.0, 2.0})
        all.push_back({"yamane_nakamura", ratio, printed_model(ratio)});
    const MassSplitting mass_splitting{.spring = stiffness};
    all.push_back({"mass_splitting", mass_splitting.damping_ratio, mass_splitting});
    return all;
}

void report_slides(const std::vector<double>& angles, Report& report)
{
    Table table({"angle_deg", "dt_s", "up_error_percent", "down_error_percent"});
    double worst = 0;
    for (const double angle : angles)
        for (const double dt : {0.01, 0.002}) {
            Launch launch;
            launch.angle_deg = angle;
            launch.dt = dt;
            launch.friction = with_mu_s(MassSplitting{.spring = stiffness}, 0.8 * tangent(angle));
            const Vec3 up = uphill(angle);
            const double mu_d = std::get<MassSplitting>(launch.friction).mu_d;
            const double up_error = mean_acceleration(launch, 2.5, 0.5) / (-9.81 * (up.y() + mu_d * up.x())) -
                                    1;
            const double down_error =
                mean_acceleration(launch, -0.5, -2.5) / (-9.81 * (up.y() - mu_d * up.x())) - 1;
            table.add({angle, dt, 100 * up_error, 100 * down_error});
            worst = std::max({worst, std::abs(up_error), std::abs(down_error)});
        }
    report.table("slides", table);
    report.page_table("slides", table, 2);
    report.fact("threshold", "worst_acceleration_error_percent", 100 * worst, 2);
}

}  // namespace

/// Thesis 7.3: the smallest mu_s that holds the block at all, over slopes, steps and damping.
void threshold(const RunOptions& options, Report& report)
{
    const std::vector<double> angles = options.quick ? std::vector{10.0, 30.0}
                                                     : std::vector{5.0, 10.0, 20.0, 30.0};
    const std::vector<double> steps = options.quick ? std::vector{0.01} : std::vector{0.01, 0.002};
    const std::vector<ThresholdSeries> all = all_series(options.quick);
    GrowingTable table(report, "threshold", {"model", "angle_deg", "dt", "damping_ratio", "mu_s"},
                       all.size() * angles.size() * steps.size());
    Table ten({"model", "damping ratio", "Δt [s]", "smallest", "over tan 10°", "one degree of freedom"});
    Table mass_splitting({"angle [°]", "tan", "Δt [s]", "smallest", "over tan"});
    double worst = 0;
    for (const ThresholdSeries& series : all)
        for (const double angle : angles)
            for (const double dt : steps) {
                Launch launch;
                launch.angle_deg = angle;
                launch.dt = dt;
                launch.friction = series.friction;
                const double mu_s = smallest_mu_s(launch), ratio = mu_s / tangent(angle);
                table.add({series.model, angle, dt, series.damping_ratio, mu_s});
                const bool is_mass_splitting = series.model == "mass_splitting";
                if (is_mass_splitting) {
                    mass_splitting.add({angle, tangent(angle), dt, mu_s, ratio});
                    worst = std::max(worst, std::abs(ratio - 1));
                }
                if (angle == 10)
                    ten.add({series.model, series.damping_ratio, dt, mu_s, ratio,
                             is_mass_splitting ? Cell("-") : Cell(peak_over_weight(series.damping_ratio))});
            }
    report.table("threshold", table);
    report.page_table("threshold_ten_degrees", ten, 3);
    report.page_table("threshold_mass_splitting", mass_splitting, 3);
    report.fact("threshold", "worst_mass_splitting_percent", 100 * worst, 2);
    report.fact("threshold", "undamped_mu_s", peak_over_weight(0) * tangent(10), 3);
    report.plot("chapters/04_friction/plots/threshold.gp");
    report_slides(angles, report);
}

}  // namespace enduring::chapter04
