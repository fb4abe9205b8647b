#include "chapters/05_categorisation/experiments/corner.hpp"
#include "chapters/05_categorisation/experiments/direction_sphere.hpp"
#include "chapters/05_categorisation/experiments/experiments.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter05 {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Wedge {
    std::string name;
    double opening_deg;
};

const std::vector<Wedge> wedges{{"acute", 40}, {"right", 90}, {"obtuse", 160}, {"flat", 180}};

Corner corner_of(const Wedge& wedge) { return wedge_corner(wedge.name, wedge.opening_deg * degree); }

/// The normal of a floor that leans by an angle against the corner's averaged normal, which looks down.
Vec3 floor_normal(double lean_deg) { return {-std::sin(lean_deg * degree), std::cos(lean_deg * degree), 0}; }

/// Around each wedge, for every direction that the corner could be pushed from: what is
/// possible, and what the rules say. The direction stands as x and y of the reversed contact
/// normal, so that it points from the corner at the obstacle.
Table circles()
{
    Table table({"corner", "opening_deg", "lean_deg", "x", "y", "possible", "average", "span"});
    for (const Wedge& wedge : wedges) {
        const Corner corner = corner_of(wedge);
        // where alone a floor can touch the flat one; the others stay clear of every border
        std::vector<double> leans{0};
        for (double lean = -179.5; lean < 180; lean += 1)
            leans.push_back(lean);
        for (const double lean : leans) {
            const Vec3 normal = floor_normal(lean);
            table.add({wedge.name, wedge.opening_deg, lean, -normal.x(), -normal.y(),
                       long(can_touch(corner, normal)), long(average_says_regular(corner, normal)),
                       long(span_says_regular(corner, normal))});
        }
    }
    return table;
}

std::string word(bool regular) { return regular ? "regular" : "hooked"; }

/// Thesis figures 6.6 and 6.8 as a table: corners on floors that lean.
Table verdicts()
{
    Table table({"corner", "opening_deg", "floor leans by [°]", "it can touch there", "averaged normal says",
                 "span says"});
    for (const Wedge& wedge : wedges) {
        const Corner corner = corner_of(wedge);
        for (const double lean : {0.0, 40.0, 60.0}) {
            const Vec3 normal = floor_normal(lean);
            table.add({wedge.name, wedge.opening_deg, lean,
                       std::string(can_touch(corner, normal) ? "yes" : "no"),
                       word(average_says_regular(corner, normal)), word(span_says_regular(corner, normal))});
        }
    }
    return table;
}

}  // namespace

void spans(const RunOptions& options, Report& report)
{
    report.table("circles", circles());
    report.plot("chapters/05_categorisation/plots/circles.gp");
    report.table("verdicts", verdicts());
    report.page_table("verdicts", verdicts());

    const int subdivisions = options.quick ? 4 : 6;
    Table shares({"corner", "can touch [% of directions]", "of these regular by average [%]",
                  "of these regular by span [%]", "of the others regular by span [%]"});
    std::vector<DirectionSphere> spheres;
    for (const Corner& corner : sphere_corners()) {
        spheres.push_back(directions_around(corner, subdivisions));
        const DirectionShares& found = spheres.back().shares;
        const bool any = found.possible > 0;
        const auto percent = [&](double share) { return any ? Cell(100 * share) : Cell(std::string("-")); };
        shares.add({corner.name, 100 * found.possible, percent(found.average_finds),
                    percent(found.span_finds), 100 * found.span_allows});
    }
    report.table("direction_shares", shares);
    report.page_table("direction_shares", shares);
    report.fact("spans", "tip_missed", 100 * (1 - spheres.front().shares.span_finds), 2);
    report.fact("spans", "tip_missed_by_average", 100 * (1 - spheres.front().shares.average_finds), 2);
    write_png(draw(spheres, sphere_corners()), report.file("directions.png"));
}

}  // namespace enduring::chapter05
