#include "chapters/engines/experiments/experiments.hpp"
#include "chapters/engines/experiments/measured_growth.hpp"
#include "chapters/engines/experiments/measured_rows.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace enduring::engines {
namespace {

using Row = MeasuredRow;

std::string short_number(double value)
{
    if (std::isinf(value))
        return "lost";
    std::ostringstream text;
    if (std::abs(value) >= 99.5)
        text << std::lround(value);
    else {
        text.precision(2);
        text << value;
    }
    return text.str();
}

/// The columns of one table of the book: a scene's quantity, and its head.
struct Column {
    std::string scene, quantity, head;
};

/// A row an engine and its settings, a column a question; what is wrong is marked.
void pivot(const std::vector<Row>& rows, const std::string& name, const std::vector<Column>& columns,
           Report& report)
{
    std::vector<std::string> heads{"engine", "settings"};
    for (const Column& column : columns)
        heads.push_back(column.head);
    Table table(heads);
    std::vector<std::string> order;
    std::map<std::string, std::vector<Cell>> lines;
    for (const Row& row : rows) {
        const std::string key = row.at("engine") + "," + row.at("way");
        const auto place = std::find_if(columns.begin(), columns.end(), [&](const Column& column) {
            return column.scene == row.at("scene") &&
                   (column.quantity == row.at("quantity") || column.quantity == "time");
        });
        if (place == columns.end())
            continue;
        if (!lines.contains(key)) {
            order.push_back(key);
            lines[key] = {row.at("engine"), row.at("way")};
            lines[key].resize(heads.size(), std::string("-"));
        }
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (columns[i].scene != row.at("scene"))
                continue;
            if (columns[i].quantity == row.at("quantity"))
                lines[key][i + 2] = (row.at("right") == "no" ? "✗ " : "") +
                                    short_number(measured_number(row.at("value")));
            else if (columns[i].quantity == "time")
                lines[key][i + 2] = short_number(measured_number(row.at("time_over_ours_by_clock")));
        }
    }
    for (const std::string& key : order)
        table.add(lines[key]);
    report.table(name, table);
    report.page_table(name, table, 2);
}

/// Every number, by its scene, engine, settings and quantity, for the text; and what each engine was.
void report_facts(const std::vector<Row>& rows, Report& report)
{
    for (const Row& row : rows) {
        const std::string who = fact_word(row.at("engine"));
        const std::string name = fact_word(row.at("scene")) + "_" + who + "_" + row.at("way") + "_" +
                                 row.at("quantity");
        report.fact("measured", name, short_number(measured_number(row.at("value"))));
        report.fact("measured", "version_" + who, row.at("version"));
    }
}

/// Of how many scenes everything is right.
void report_verdicts(const std::vector<Row>& rows, Report& report)
{
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, std::map<std::string, bool>> right;
    for (const Row& row : rows) {
        const std::pair who{row.at("engine"), row.at("way")};
        if (!right.contains(who))
            order.push_back(who);
        const auto place = right[who].try_emplace(row.at("scene"), true).first;
        place->second = place->second && row.at("right") == "yes";
    }
    Table table({"engine", "version", "default", "best", "of"});
    for (const auto& who : order) {
        if (who.second != "default")
            continue;
        const auto count = [&](const std::string& way) {
            const auto& scenes = right[{who.first, way}];
            return static_cast<long>(
                std::count_if(scenes.begin(), scenes.end(), [](const auto& scene) { return scene.second; }));
        };
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const Row& one) { return one.at("engine") == who.first; });
        table.add({who.first, row->at("version"), count("default"), count("best"),
                   static_cast<long>(right[who].size())});
        report.fact("measured", "right_" + fact_word(who.first), static_cast<double>(count("best")));
        report.fact("measured", "scenes", static_cast<double>(right[who].size()));
    }
    report.table("engine_verdicts", table);
    report.page_table("engine_verdicts", table);
}

}  // namespace

void measured(const RunOptions&, Report& report)
{
    const std::vector<Row> rows = measured_rows("rows.csv");
    pivot(rows, "rest",
          {{"stack", "depth_um", "stack, depth [µm]"},
           {"stack", "drift_um_per_s", "stack, drift [µm/s]"},
           {"stack", "time", "time over ours, stack"},
           {"ratio_1000", "sunk_mm", "1000 : 1, sunk [mm]"},
           {"ratio_5000", "sunk_mm", "5000 : 1, sunk [mm]"},
           {"heap", "depth_um", "heap, depth [µm]"},
           {"heap", "drift_um_per_s", "heap, drift [µm/s]"},
           {"heap", "time", "time over ours, heap"}},
          report);
    pivot(rows, "shapes",
          {{"pipe_120", "kept", "pipe of 120, kept"},
           {"pipe_480", "kept", "pipe of 480, kept"},
           {"torus", "kept", "torus, kept"},
           {"arch", "moved_mm", "arch, moved [mm]"},
           {"wall", "moved_mm", "wall, moved [mm]"},
           {"slopes", "error_percent", "slopes, error [% of g]"},
           {"overlap", "thrown_m_per_s", "overlap, thrown [m/s]"},
           {"overlap", "depth_um", "overlap, depth [µm]"},
           {"thin", "through_count", "shots through, of 12"}},
          report);
    report_facts(rows, report);
    report_verdicts(rows, report);
    std::ifstream file(source_directory() / "chapters/engines/measured/date.txt");
    std::string date;
    std::getline(file, date);
    report.fact("measured", "date", date);

    Table table({"scene", "engine", "way", "substeps", "error", "time_over_ours_by_clock"});
    for (const Row& row : measured_rows("curves.csv")) {
        const double value = measured_number(row.at("value"));
        if (row.at("scene") == "stack" && row.at("right") == "no")
            continue;  // a stack that falls or sinks: the depth of its parts says nothing
        table.add({row.at("scene"), row.at("engine"), row.at("way"),
                   static_cast<long>(measured_number(row.at("substeps"))),
                   row.at("quantity") == "kept" ? std::abs(1 - value) : value,
                   measured_number(row.at("time_over_ours_by_clock"))});
    }
    report.table("error_over_time", table);
    report.plot("chapters/engines/plots/error_over_time.gp");
    measured_growth(report);
}

}  // namespace enduring::engines
