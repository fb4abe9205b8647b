#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/implicit_amplification.hpp"
#include "chapters/07_implicit_contact/experiments/measured_radius.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace enduring::chapter07 {
namespace {

/// h from 0.01 to 10,000, the same number for each power of ten.
std::vector<double> stiffnesses(int count)
{
    std::vector<double> all;
    for (int i = 0; i < count; ++i)
        all.push_back(0.01 * std::pow(10, 6.0 * i / (count - 1)));
    return all;
}

/// The largest h with which a drop settles, by bisection of the simulation.
double measured_limit(double centre)
{
    double low = 1, high = 1000;
    while (high - low > 1e-4 * low) {
        const double middle = std::sqrt(low * high);
        (settles(particle_with(middle, centre), 0.1) ? low : high) = middle;
    }
    return low;
}

/// For weights that look back, with the centre before the middle of the
/// step: the formula's limit, and the simulation's.
Table limits()
{
    Table table({"centre", "limit", "measured"});
    for (const double centre : {0.1, 0.2, 0.3, 0.4})
        table.add({centre, stable_below(centre), measured_limit(centre)});
    return table;
}

/// For the others: where they are fastest, and what is left there and far beyond.
Table fastest()
{
    Table table(
        {"centre", "fastest_h", "factor", "measured_factor", "factor_of_a_stiff_ground", "measured_at_1e6"});
    for (const double centre : {0.5, 2.0 / 3, 0.8, 0.9}) {
        const double h = fastest_stiffness(centre);
        table.add({centre, h, std::abs(fastest_factor(centre)), measured_radius(particle_with(h, centre)),
                   std::abs(ringing_factor(centre)), measured_radius(particle_with(1e6, centre))});
    }
    return table;
}

}  // namespace

/// The spectral radius of the implicit step over h, for several weights, from the matrix and from the
/// simulation; and whether a dropped particle settles.
void implicit_map(const RunOptions& options, Report& report)
{
    Table map({"centre", "h", "spectral_radius", "measured", "settles"});
    double worst = 0;
    long drops = 0, settled = 0;
    for (const double centre : {0.25, 0.4, 0.5, 2.0 / 3, 0.8, 1.0})
        for (const double h : stiffnesses(options.quick ? 25 : 97)) {
            const ImplicitParticle problem = particle_with(h, centre);
            const double radius = spectral_radius(amplification(problem)),
                         measured = measured_radius(problem);
            const bool at_rest = settles(problem, 0.1);
            worst = std::max(worst, std::abs(radius - measured));
            drops += centre >= 0.5;
            settled += centre >= 0.5 && at_rest;
            map.add({centre, h, radius, measured, at_rest ? "settles" : "keeps bouncing"});
        }
    report.table("implicit_map", map);
    report.table("implicit_limits", limits());
    report.page_table("implicit_limits", limits(), 4);
    report.table("implicit_fastest", fastest());
    report.page_table("implicit_fastest", fastest(), 4);
    report.fact("implicit_map", "drops", static_cast<double>(drops), 4);
    report.fact("implicit_map", "settled", static_cast<double>(settled), 4);
    report.fact("implicit_map", "worst_radius_error", worst, 1);
    report.plot("chapters/07_implicit_contact/plots/implicit_map.gp");
}

}  // namespace enduring::chapter07
