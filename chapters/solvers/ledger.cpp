#include "chapters/solvers/ledger.hpp"

#include "chapters/solvers/chapter_solver.hpp"
#include "chapters/solvers/experiments.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace enduring::solvers {
namespace {

std::string number_text(const LedgerCell& cell)
{
    const std::string& unit = cell.scene->unit;
    if (!cell.outcome.broken.empty())
        return "breaks";
    return cell.outcome.value ? readable(*cell.outcome.value, 3) + (unit.empty() ? "" : " " + unit)
                              : "nothing";
}

/// scene, chapter, quantity, unit, bound, value, passes, expected: a row a
/// cell; no value where there was nothing to measure.
Table all_cells(const std::vector<LedgerCell>& cells)
{
    Table table({"scene", "chapter", "quantity", "unit", "bound", "value", "passes", "expected"});
    for (const LedgerCell& cell : cells) {
        const Cell value = cell.outcome.value ? Cell(*cell.outcome.value) : Cell(std::string());
        table.add({cell.scene->name, static_cast<long>(cell.chapter), cell.scene->quantity, cell.scene->unit,
                   bound_text(*cell.scene), value, static_cast<long>(cell.passed()),
                   static_cast<long>(cell.expected_to_pass())});
    }
    return table;
}

/// A row a scene, a column a chapter.
Table page_of(const std::vector<LedgerCell>& cells)
{
    Table table({"scene", "measured", "passes_if", "1", "2", "3", "4", "5", "6", "7"});
    std::map<const MotivatingScene*, std::vector<Cell>> rows;
    for (const LedgerCell& cell : cells) {
        std::vector<Cell>& row = rows[cell.scene];
        if (row.empty()) {
            row = {cell.scene->name, cell.scene->quantity, bound_text(*cell.scene)};
            row.resize(3 + chapters, std::string());
        }
        row[2 + cell.chapter] = number_text(cell) + (cell.passed() ? " ✓" : " ✗");
    }
    for (const LedgerCell& cell : cells)
        // in the cells' order, not in that of addresses
        if (auto row = rows.find(cell.scene); row != rows.end()) {
            table.add(row->second);
            rows.erase(row);
        }
    return table;
}

std::vector<StripPicture> pictures_of(const std::vector<LedgerCell>& cells)
{
    std::vector<StripPicture> pictures;
    for (const LedgerCell& cell : cells)
        if (cell.outcome.picture)
            pictures.push_back(
                {*cell.outcome.picture, cell.scene->name + ", chapter " + std::to_string(cell.chapter) +
                                            (cell.passed() ? " holds: " : " fails: ") + number_text(cell)});
    return pictures;
}

}  // namespace

bool at_border(const MotivatingScene& scene, int chapter)
{
    const auto expected = [&](int c) { return scene.expected[std::clamp(c, 1, chapters) - 1]; };
    const bool changes = scene.expected.find_first_not_of(scene.expected[0]) != std::string::npos;
    return changes ? expected(chapter) != expected(chapter - 1) || expected(chapter) != expected(chapter + 1)
                   : chapter == 1 || chapter == chapters;
}

std::vector<std::string> surprises(const std::vector<LedgerCell>& cells)
{
    std::vector<std::string> lines;
    for (const LedgerCell& cell : cells)
        if (cell.passed() != cell.expected_to_pass())
            lines.push_back(cell.scene->name + " under chapter " + std::to_string(cell.chapter) +
                            (cell.passed() ? " passes" : " fails") + " with " + number_text(cell) + " (" +
                            bound_text(*cell.scene) + "), and was expected to " +
                            (cell.expected_to_pass() ? "pass" : "fail") +
                            (cell.outcome.broken.empty() ? "" : ": " + cell.outcome.broken));
    return lines;
}

Outcome try_chapter(const MotivatingScene& scene, int chapter, bool with_picture)
{
    const auto solver = [chapter](const ContactParameters& parameters) {
        return chapter_solver(chapter, parameters);
    };
    return try_scene(scene, solver, limits_of(scene, chapter), with_picture);
}

std::vector<LedgerCell> fill_ledger(const std::vector<MotivatingScene>& scenes, bool borders_only,
                                    bool with_pictures)
{
    std::vector<LedgerCell> cells;
    for (const MotivatingScene& scene : scenes)
        for (int chapter = 1; chapter <= chapters; ++chapter) {
            const bool border = at_border(scene, chapter);
            if (border || !borders_only)
                cells.push_back({&scene, chapter, try_chapter(scene, chapter, with_pictures && border)});
        }
    return cells;
}

/// All solvers of the course under all scenes that called for them.
void ledger(const RunOptions& options, Report& report)
{
    const std::vector<LedgerCell> cells = fill_ledger(motivating_scenes(), options.quick, true);
    report.table("ledger", all_cells(cells));
    report.page_table("ledger", page_of(cells));
    write_png(strip(pictures_of(cells), 4), report.file("ledger.png"));
    report.fact("ledger", "scenes", static_cast<double>(motivating_scenes().size()));
    report.fact("ledger", "cells", static_cast<double>(cells.size()));

    std::string message;
    for (const std::string& line : surprises(cells))
        message += "\n  " + line;
    if (!message.empty())
        throw std::runtime_error("the failure ledger is not as expected:" + message);
}

}  // namespace enduring::solvers
