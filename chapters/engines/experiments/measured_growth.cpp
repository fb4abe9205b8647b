#include "chapters/engines/experiments/measured_growth.hpp"

#include "chapters/engines/experiments/measured_rows.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace enduring::engines {
namespace {

/// One engine with one of its settings and so many bodies.
struct GrownRow {
    std::string engine, way;
    long bodies = 0;
    double moved_mm = 0;
    bool right = false;
    double time = 0;  ///< of a frame, over that of the first row of the file
};

std::vector<GrownRow> grown_rows()
{
    std::vector<GrownRow> rows;
    for (const MeasuredRow& row : measured_rows("growth.csv"))
        if (row.at("quantity") == "moved_mm")
            rows.push_back({row.at("engine"), row.at("way"), std::stol(row.at("bodies")),
                            measured_number(row.at("value")), row.at("right") == "yes",
                            measured_number(row.at("time_over_ours_by_clock"))});
    return rows;
}

/// The time of a frame over that of our first engine with its default settings and as many bodies.
double time_over_ours(const std::vector<GrownRow>& rows, const GrownRow& row)
{
    const auto ours = std::find_if(rows.begin(), rows.end(), [&](const GrownRow& one) {
        return one.engine == rows.front().engine && one.way == rows.front().way && one.bodies == row.bodies;
    });
    return ours == rows.end() ? NAN : row.time / ours->time;
}

std::string two_digits(double value)
{
    if (std::isnan(value))
        return "-";
    return std::isinf(value) ? "lost" : readable(value, 2);
}

}  // namespace

void measured_growth(Report& report)
{
    const std::vector<GrownRow> rows = grown_rows();
    constexpr std::array<long, 3> shown{105, 990, 5050};  // bodies
    std::vector<std::string> heads{"engine", "settings"};
    for (const char* what : {": moved [mm]", ": time over ours"})
        for (const long bodies : shown)
            heads.push_back(std::to_string(bodies) + what);
    Table page(heads), points({"engine", "way", "bodies", "moved_mm", "time_over_first_by_clock"});
    std::vector<std::pair<std::string, std::vector<Cell>>> lines;
    for (const GrownRow& row : rows) {
        points.add({row.engine, row.way, row.bodies, row.moved_mm, row.time});
        const std::string name = fact_word(row.engine) + "_" + row.way + "_" + std::to_string(row.bodies);
        report.fact("measured", "pyramid_" + name + "_moved_mm", two_digits(row.moved_mm));
        report.fact("measured", "pyramid_" + name + "_time", two_digits(time_over_ours(rows, row)));
        if (lines.empty() || lines.back().first != row.engine + row.way) {
            lines.push_back({row.engine + row.way, {row.engine, row.way}});
            lines.back().second.resize(heads.size(), std::string("-"));
        }
        const auto place = std::find(shown.begin(), shown.end(), row.bodies) - shown.begin();
        if (place == static_cast<std::ptrdiff_t>(shown.size()))
            continue;
        auto& line = lines.back().second;
        line[static_cast<std::size_t>(2 + place)] = (row.right ? "" : "✗ ") + two_digits(row.moved_mm);
        line[static_cast<std::size_t>(2 + place) + shown.size()] = two_digits(time_over_ours(rows, row));
    }
    for (const auto& line : lines)
        page.add(line.second);
    report.table("growing", points);
    report.page_table("growing", page, 2);
    report.plot("chapters/engines/plots/growing.gp");
}

}  // namespace enduring::engines
