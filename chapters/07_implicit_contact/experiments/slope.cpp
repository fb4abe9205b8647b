#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace enduring::chapter07 {
namespace {

/// Where a cube is that was laid on a slope [m], down the slope, and how fast.
struct Slide {
    double way, speed;
};

Slide slide(double slope_deg, double mu_s, double mu_d, double dt, double duration)
{
    Scene scene = scene_of({{10, Vec3(0, 0.5, 0), 0}}, dt, slope_deg, mu_s, mu_d);
    const Solver solver = chapter07_solver(scene.contact);
    Contacts contacts;
    for (int i = 0; i < std::lround(duration / dt); ++i)
        advance(scene.world, contacts, solver, dt);
    return {-scene.world.bodies[0]->centre().x(), -scene.world.bodies[0]->mean_velocity().x()};
}

/// Whether it stays within a tenth of a millimetre.
bool holds(double slope_deg, double mu, double dt) { return slide(slope_deg, mu, mu, dt, 1).way < 1e-4; }

/// Smallest and largest mu, over tan, of a scan that is not as it should be; 1 and 1
/// where all that are below tan slide and all above hold.
struct Threshold {
    double first_that_holds = 2, last_that_slides = 0;
};

Threshold scan(double slope_deg, double dt, int count)
{
    Threshold threshold;
    for (int i = 0; i < count; ++i) {
        const double part = 0.95 + 0.1 * i / (count - 1);
        if (holds(slope_deg, part * std::tan(slope_deg * std::numbers::pi / 180), dt))
            threshold.first_that_holds = std::min(threshold.first_that_holds, part);
        else
            threshold.last_that_slides = std::max(threshold.last_that_slides, part);
    }
    return threshold;
}

}  // namespace

/// A cube on a slope: the coefficient at which it begins to hold, by a scan, and how fast it slides below it.
void slope(const RunOptions& options, Report& report)
{
    Table thresholds({"slope_deg", "dt_s", "first_that_holds", "last_that_slides"});
    double worst = 0;
    for (const double angle : {5.0, 10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            const Threshold found = scan(angle, dt, options.quick ? 11 : 41);
            thresholds.add({angle, dt, found.first_that_holds, found.last_that_slides});
            worst =
                std::max({worst, std::abs(found.first_that_holds - 1), std::abs(found.last_that_slides - 1)});
        }
    Table slides({"slope_deg", "dt_s", "acceleration", "exact", "error_percent"});
    double worst_slide = 0;
    for (const double angle : {10.0, 20.0, 30.0})
        for (const double dt : {0.01, 0.002}) {
            const double a = angle * std::numbers::pi / 180, mu = 0.5 * std::tan(a),
                         exact = 9.81 * (std::sin(a) - mu * std::cos(a));
            const double measured = slide(angle, mu, mu, dt, 2).speed - slide(angle, mu, mu, dt, 1).speed;
            slides.add({angle, dt, measured, exact, 100 * (measured / exact - 1)});
            worst_slide = std::max(worst_slide, std::abs(100 * (measured / exact - 1)));
        }
    report.table("slope_threshold", thresholds);
    report.page_table("slope_threshold", thresholds, 4);
    report.table("slope_slide", slides);
    report.page_table("slope_slide", slides, 5);
    report.fact("slope", "worst_threshold_percent", 100 * worst, 2);
    report.fact("slope", "worst_slide_percent", worst_slide, 1);
}

}  // namespace enduring::chapter07
