#include "chapters/03_penalty_impulses/experiments/exact_impulse.hpp"
#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "common/experiments/report/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace enduring::chapter03 {
namespace {

/// A triangle of side about 1 that turns about a random axis through a random point near it
/// and grows in its plane, with a vertex that sinks, rises or stays below it. Vertices move
/// along straight lines in between: that is the model's.
PairStep random_motion(std::mt19937_64& generator, double turn, double growth)
{
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] {
        const double x = unit(generator), y = unit(generator), z = unit(generator);
        return Vec3(x, y, z);
    };
    Vec3 axis = point();
    while (axis.norm() > 1 || axis.norm() < 0.1)
        axis = point();
    const Mat3 rotation = Eigen::AngleAxisd(turn, axis.normalized()).toRotationMatrix();
    const Vec3 centre = 0.5 * point();

    PairVertices t0{Vec3(0, 0, 0), Vec3(-0.5, 0, -0.3), Vec3(0, 0, 0.6), Vec3(0.5, 0, -0.3)}, t1;
    for (std::size_t i = 1; i < 4; ++i) {
        t0[i] += 0.15 * point();
        t1[i] = centre + (1 + growth) * (rotation * (t0[i] - centre));
    }
    const auto at_height = [](const PairVertices& x, double height) {
        const PairInstant pair = vertex_face_instant(x);
        return Vec3((x[1] + x[2] + x[3]) / 3 + height * pair.side_1.cross(pair.side_2).normalized());
    };
    t0[0] = at_height(t0, 0.03 * unit(generator));
    t1[0] = at_height(t1, -0.02 + 0.01 * unit(generator));
    return {vertex_face_instant(t0), vertex_face_instant(t1)};
}

struct Errors {
    std::vector<double> length, angle_deg;
};

Errors errors_at(double turn, double growth, int count)
{
    std::mt19937_64 generator(51);
    Errors errors;
    for (int i = 0; i < count; ++i) {
        const PairStep step = random_motion(generator, turn, growth);
        const Vec3 exact = exact_impulse(step, 0, 1, 1), ours = continuous_impulse(step, 0, 1, 1);
        errors.length.push_back(std::abs(ours.norm() / exact.norm() - 1));
        errors.angle_deg.push_back(std::atan2(exact.cross(ours).norm(), exact.dot(ours)) * 180 /
                                   std::numbers::pi);
    }
    return errors;
}

}  // namespace

/// The constant L_k of (5.14) against the exact unit normal, over random
/// motions: how far the face turns, how much it grows.
void normalisation(const RunOptions& options, Report& report)
{
    const int count = options.quick ? 200 : 2000;
    Table table(
        {"turn_deg", "growth_percent", "median_percent", "p95_percent", "max_percent", "direction_p95_deg"});
    const auto add = [&](double degrees, double growth_percent) {
        const Errors errors = errors_at(degrees * std::numbers::pi / 180, growth_percent / 100, count);
        table.add({degrees, growth_percent, 100 * quantile(errors.length, 0.5),
                   100 * quantile(errors.length, 0.95), 100 * quantile(errors.length, 1),
                   quantile(errors.angle_deg, 0.95)});
        return 100 * quantile(errors.length, 0.95);
    };
    for (const double degrees : {0.3, 1.0, 3.0, 10.0, 20.0, 30.0, 45.0, 60.0, 90.0}) {
        const double p95 = add(degrees, 0);
        if (degrees == 10)
            report.fact("normalisation", "turn_10_deg", p95, 2);
    }
    for (const double growth : {0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0}) {
        const double p95 = add(0, growth);
        if (growth == 10)
            report.fact("normalisation", "growth_10_percent", p95, 2);
    }
    report.table("normalisation", table);
    report.page_table("normalisation", table, 2);
    report.plot("chapters/03_penalty_impulses/plots/normalisation.gp");
}

}  // namespace enduring::chapter03
