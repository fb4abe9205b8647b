#include "common/worked_step/worked_step_tables.hpp"

#include "common/input/number_text.hpp"
#include "common/worked_step/step_record.hpp"
#include "common/worked_step/worked_step.hpp"

#include <algorithm>

namespace enduring {
namespace {

using Records = std::vector<StageRecord>;
using Array = std::vector<Vec3> BodyRecord::*;

constexpr int digits = 6;  // enough for every number of the step to stand whole

/// A stage that comes a second time is called so.
std::vector<std::string> stage_names(const Records& records)
{
    std::vector<std::string> names;
    for (const StageRecord& record : records) {
        const bool before = std::find(names.begin(), names.end(), record.stage) != names.end();
        names.push_back(record.stage + (before ? " again" : ""));
    }
    return names;
}

bool same(const StageRecord& a, const StageRecord& b, Array array)
{
    for (std::size_t body = 0; body < a.bodies.size(); ++body)
        if (a.bodies[body].*array != b.bodies[body].*array)
            return false;
    return true;
}

/// Records between which one array does not change, as one column: the first of them, and its heading.
struct Span {
    std::size_t first;
    std::string heading;
};

std::vector<Span> unchanged_spans(const Records& records, Array array)
{
    const std::vector<std::string> names = stage_names(records);
    std::vector<Span> spans;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (i == 0 || !same(records[i - 1], records[i], array))
            spans.push_back({i, names[i]});
        else
            spans.back().heading = names[spans.back().first] + " to " + names[i];
    }
    return spans;
}

/// One row a vertex, a column each time the array changes: the y of one array of the bodies.
Table array_table(const World& world, const Records& records, Array array)
{
    const std::vector<Span> spans = unchanged_spans(records, array);
    std::vector<std::string> columns{"vertex"};
    for (const Span& span : spans)
        columns.push_back(span.heading);
    Table table(columns);
    for (std::size_t body = 0; body < world.bodies.size(); ++body)
        for (std::size_t vertex = 0; vertex < world.bodies[body]->positions_t0().size(); ++vertex) {
            std::vector<Cell> row{world.bodies[body]->name() + " " + std::to_string(vertex)};
            for (const Span& span : spans)
                row.emplace_back((records[span.first].bodies[body].*array)[vertex].y());
            table.add(row);
        }
    return table;
}

std::string list(const std::array<double, 4>& numbers)
{
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ", ") + readable(number, digits);
    return text;
}

std::string list(const std::array<int, 4>& numbers)
{
    std::string text;
    for (const int number : numbers)
        text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

bool same(const Contact& a, const Contact& b)
{
    return a.vertices == b.vertices && a.weights == b.weights && a.start == b.start &&
           a.answered() == b.answered() && a.impulse == b.impulse;
}

/// The one list of contacts; an entry stands again after each stage that changed it.
Table contacts_table(const Records& records)
{
    Table table({"after", "entry", "vertices", "weights", "start", "handled", "impulse y [N s]"});
    const std::vector<std::string> names = stage_names(records);
    Contacts before;
    for (std::size_t stage = 0; stage < records.size(); ++stage) {
        const StageRecord& record = records[stage];
        for (std::size_t i = 0; i < record.contacts.size(); ++i) {
            const Contact& contact = record.contacts[i];
            if (i < before.size() && same(contact, before[i]))
                continue;
            table.add({names[stage], static_cast<long>(i), list(contact.vertices), list(contact.weights),
                       contact.start, contact.answered() ? "yes" : "no", contact.impulse.y()});
        }
        before = record.contacts;
    }
    return table;
}

}  // namespace

void write_worked_step(const Solver& solver, Report& report)
{
    WorkedStep step = worked_step();
    const Records records = record_step(step.world, step.contacts, solver, step.dt);
    report.page_table("worked_step_velocities", array_table(step.world, records, &BodyRecord::velocities),
                      digits);
    report.page_table("worked_step_predictions", array_table(step.world, records, &BodyRecord::positions_t1),
                      digits);
    report.page_table("worked_step_positions", array_table(step.world, records, &BodyRecord::positions_t0),
                      digits);
    report.page_table("worked_step_contacts", contacts_table(records), digits);
}

}  // namespace enduring
