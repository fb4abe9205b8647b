#include "chapters/solvers/ledger.hpp"

#include "chapters/engines/bullet/bullet_solver.hpp"
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

/// scene, chapter (or Bullet), quantity, unit, bound, value, passes, expected: a row a
/// cell; no value where there was nothing to measure.
Table all_cells(const std::vector<LedgerCell>& cells)
{
    Table table({"scene", "chapter", "quantity", "unit", "bound", "value", "passes", "expected"});
    for (const LedgerCell& cell : cells) {
        const Cell value = cell.outcome.value ? Cell(*cell.outcome.value) : Cell(std::string());
        const Cell chapter = cell.column == bullet_column ? Cell(solver_name(cell.column))
                                                          : Cell(static_cast<long>(cell.column));
        table.add({cell.scene->name, chapter, cell.scene->quantity, cell.scene->unit, bound_text(*cell.scene),
                   value, static_cast<long>(cell.passed()), static_cast<long>(cell.expected_to_pass())});
    }
    return table;
}

/// A row a scene, a column a chapter, and one for Bullet.
Table page_of(const std::vector<LedgerCell>& cells)
{
    std::vector<std::string> head{"scene", "measured", "passes_if"};
    for (int chapter = 1; chapter <= last_chapter; ++chapter)
        head.push_back(std::to_string(chapter));
    head.push_back(solver_name(bullet_column));
    Table table(head);
    std::map<const MotivatingScene*, std::vector<Cell>> rows;
    for (const LedgerCell& cell : cells) {
        std::vector<Cell>& row = rows[cell.scene];
        if (row.empty()) {
            row = {cell.scene->name, cell.scene->quantity, bound_text(*cell.scene)};
            row.resize(head.size(), std::string());
            if (expectation(*cell.scene, bullet_column) == '-')
                row.back() = std::string("does not apply");
        }
        row[2 + cell.column] = number_text(cell) + (cell.passed() ? " ✓" : " ✗");
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
            pictures.push_back({*cell.outcome.picture, cell.scene->name + ", " + solver_name(cell.column) +
                                                           (cell.passed() ? " holds: " : " fails: ") +
                                                           number_text(cell)});
    return pictures;
}

/// What the page says of Bullet: its version, the rows that it has, and how many of them it passes.
void report_bullet(const std::vector<LedgerCell>& cells, Report& report)
{
    const auto of_bullet = [](const LedgerCell& cell) { return cell.column == bullet_column; };
    const auto rows = std::count_if(cells.begin(), cells.end(), of_bullet);
    const auto passed = std::count_if(
        cells.begin(), cells.end(), [&](const LedgerCell& cell) { return of_bullet(cell) && cell.passed(); });
    report.fact("ledger", "bullet_version", bullet_version());
    report.fact("ledger", "bullet_rows", static_cast<double>(rows));
    report.fact("ledger", "bullet_passes", static_cast<double>(passed));
}

}  // namespace

char expectation(const MotivatingScene& scene, int column)
{
    return column == bullet_column ? scene.with_bullet : scene.expected[column - 1];
}

std::string solver_name(int column)
{
    return column == bullet_column ? "Bullet" : "chapter " + std::to_string(column);
}

bool at_border(const MotivatingScene& scene, int chapter)
{
    const auto expected = [&](int c) { return scene.expected[std::clamp(c, 1, last_chapter) - 1]; };
    const bool changes = scene.expected.find_first_not_of(scene.expected[0]) != std::string::npos;
    return changes ? expected(chapter) != expected(chapter - 1) || expected(chapter) != expected(chapter + 1)
                   : chapter == 1 || chapter == last_chapter;
}

std::vector<std::string> surprises(const std::vector<LedgerCell>& cells)
{
    std::vector<std::string> lines;
    for (const LedgerCell& cell : cells)
        if (cell.passed() != cell.expected_to_pass())
            lines.push_back(cell.scene->name + " under " + solver_name(cell.column) +
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

Outcome try_bullet(const MotivatingScene& scene, bool with_picture)
{
    // Bullet lifts bodies out by a way of its own, whose work nobody books.
    return try_scene(scene, bullet_solver, {.may_gain_energy = true}, with_picture);
}

std::vector<LedgerCell> fill_ledger(const std::vector<MotivatingScene>& scenes, bool borders_only,
                                    bool with_pictures)
{
    std::vector<LedgerCell> cells;
    for (const MotivatingScene& scene : scenes) {
        for (int chapter = 1; chapter <= last_chapter; ++chapter) {
            const bool border = at_border(scene, chapter);
            if (border || !borders_only)
                cells.push_back({&scene, chapter, try_chapter(scene, chapter, with_pictures && border)});
        }
        if (scene.with_bullet != '-')
            cells.push_back({&scene, bullet_column, try_bullet(scene, with_pictures)});
    }
    return cells;
}

/// All solvers of the course, and Bullet, under all scenes that called for a new one.
void ledger(const RunOptions& options, Report& report)
{
    const std::vector<LedgerCell> cells = fill_ledger(motivating_scenes(), options.quick, true);
    report.table("ledger", all_cells(cells));
    report.page_table("ledger", page_of(cells));
    write_png(strip(pictures_of(cells), 4), report.file("ledger.png"));
    report.fact("ledger", "scenes", static_cast<double>(motivating_scenes().size()));
    report.fact("ledger", "cells", static_cast<double>(cells.size()));
    report_bullet(cells, report);

    std::string message;
    for (const std::string& line : surprises(cells))
        message += "\n  " + line;
    if (!message.empty())
        throw std::runtime_error("the failure ledger is not as expected:" + message);
}

}  // namespace enduring::solvers
