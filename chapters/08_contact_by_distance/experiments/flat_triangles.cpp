#include "chapters/06_redefinition/experiments/laid_block.hpp"
#include "chapters/06_redefinition/experiments/plane_slide.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

using chapter06::PlaneSlide;

/// How a cube came over triangles without friction.
struct Slid {
    chapter06::SlideOutcome outcome;
    double largest_leap = 0;  ///< of the floor's force from one step to the next, over the weight
};

/// The leaps begin after a tenth of the run, when the landing is over.
Slid slide_over(const PlaneSlide& slide, const Solver& solver)
{
    ForceProbe force("cube", "floor");
    Slid slid{chapter06::slide_over_plane(slide, solver, &force)};
    const auto& rows = force.table().rows();
    const double weight = 20 * 9.81;
    for (std::size_t i = rows.size() / 10; i + 1 < rows.size(); ++i)
        slid.largest_leap = std::max(
            slid.largest_leap,
            std::abs(std::get<double>(rows[i + 1][2]) - std::get<double>(rows[i][2])) / weight);
    return slid;
}

/// Chapter 6's 48 slides: three triangulations, eight directions, on the lines of the grid and between them.
/// One direction is also taken in chapter 6's small steps.
std::vector<PlaneSlide> all_slides(bool quick)
{
    std::vector<PlaneSlide> slides;
    for (const GridDiagonals diagonals : chapter06::all_diagonals)
        for (int direction = 0; direction < 8; ++direction)
            for (const bool on_lattice : {false, true})
                for (const double dt : {0.01, 0.001})
                    if (direction == 1 ? dt == 0.01 || !quick : dt == 0.01 && !quick)
                        slides.push_back({diagonals, direction, on_lattice, 30000, dt});
    return slides;
}

void slide_over_floors(bool quick, Report& report)
{
    GrowingTable table(report, "flat_slides",
                       {"diagonals", "direction_deg", "on_lattice", "dt_s", "pairs", "speed_change_percent",
                        "sideways_percent", "largest_leap_percent", "unconverged", "solves"},
                       all_slides(quick).size());
    double speed = 0, sideways = 0, leap = 0;
    long unconverged = 0, solves = 0;
    for (const PlaneSlide& slide : all_slides(quick)) {
        chapter07::SolveStatistics counted;
        const Slid slid = slide_over(
            slide, chapter07::counting_solver(chapter08_solver, counted)(chapter06::scene_of(slide).contact));
        table.add({chapter06::name_of(slide.diagonals), 45L * slide.direction,
                   slide.on_lattice ? "yes" : "no", slide.dt, slid.outcome.mean_pairs,
                   100 * slid.outcome.speed_change, 100 * slid.outcome.sideways_speed,
                   100 * slid.largest_leap, counted.unconverged, counted.solves});
        speed = std::max(speed, std::abs(slid.outcome.speed_change));
        sideways = std::max(sideways, slid.outcome.sideways_speed);
        leap = std::max(leap, slid.largest_leap);
        unconverged += counted.unconverged;
        solves += counted.solves;
    }
    report.table("flat_slides", table);
    report.fact("flat_triangles", "slides", static_cast<double>(table.rows().size()));
    report.fact("flat_triangles", "speed_percent", 100 * speed, 2);
    report.fact("flat_triangles", "sideways_percent", 100 * sideways, 2);
    report.fact("flat_triangles", "leap_percent", 100 * leap, 2);
    report.fact("flat_triangles", "unconverged", static_cast<double>(unconverged));
    report.fact("flat_triangles", "solves", static_cast<double>(solves));
}

/// What chapter 6's force did in one of these slides.
void slide_as_before(Report& report)
{
    const PlaneSlide slide{.direction = 1};
    const Slid before = slide_over(slide, chapter06_solver(chapter06::scene_of(slide).contact));
    report.fact("flat_triangles", "chapter_6_leap_percent", 100 * before.largest_leap, 2);
}

/// Chapter 6's block that rounding puts partly inside its slab.
void lay_exactly(bool quick, Report& report)
{
    Table table({"gap_m", "placements", "with_a_corner_missed", "max_energy_gained_j", "chapter_6_j"});
    for (const double gap : {0.0, 1e-12, 1e-6}) {
        long placements = 0, missed = 0;
        double most = 0, before = 0;
        chapter07::SolveStatistics counted;
        for (const double slope :
             quick ? std::vector<double>{10, 15} : std::vector<double>{5, 10, 15, 20, 25, 30})
            for (const double turned : {0.0, 0.3, 0.6, std::numbers::pi / 4}) {
                const chapter06::LaidOutcome outcome = chapter06::lay(
                    {gap, slope, turned}, chapter07::counting_solver(chapter08_solver, counted));
                ++placements;
                missed += outcome.corners_missed > 0;
                most = std::max(most, outcome.energy_gained);
                before = std::max(before, chapter06::lay({gap, slope, turned}).energy_gained);
            }
        table.add({gap, placements, missed, most, before});
        if (gap == 0)
            report.fact("flat_triangles", "laid_gain_j", most, 2);
    }
    report.table("flat_laid", table);
    report.page_table("flat_laid", table, 2);
}

}  // namespace

/// Triangles that are as flat as a plane: nothing may slow what slides on them, or lift what lies on them.
void flat_triangles(const RunOptions& options, Report& report)
{
    slide_over_floors(options.quick, report);
    slide_as_before(report);
    lay_exactly(options.quick, report);
}

}  // namespace enduring::chapter08
