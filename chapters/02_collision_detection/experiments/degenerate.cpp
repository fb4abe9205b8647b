#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "chapters/02_collision_detection/experiments/hard_cases.hpp"
#include "chapters/02_collision_detection/query_files.hpp"
#include "chapters/02_collision_detection/textbook.hpp"
#include "common/input/number_text.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace enduring::chapter02 {
namespace {

using Answer = std::optional<double>;

std::string in_words(const Answer& answer) { return answer ? readable(*answer, 9) : "none"; }

/// How an answer compares with the truth; a time within a millionth of the step is as good as right.
std::string verdict(const Answer& answer, const Answer& truth)
{
    if (answer.has_value() != truth.has_value())
        return truth ? "missed" : "false alarm";
    if (!truth || std::abs(*answer - *truth) <= 1e-6)
        return "right";
    return *answer > *truth ? "late" : "early";
}

Table answers_to(const std::vector<HardCase>& cases)
{
    Table table({"case", "truth", "textbook", "textbook_is", "certified", "certified_is"});
    for (const HardCase& c : cases) {
        const Answer textbook = std::visit([](const auto& step) { return textbook_time_of_impact(step); },
                                           c.step);
        const Answer certified = std::visit([](const auto& step) { return time_of_impact(step); }, c.step);
        table.add({c.name, in_words(c.truth), in_words(textbook), verdict(textbook, c.truth),
                   in_words(certified), verdict(certified, c.truth)});
    }
    return table;
}

/// Wrong answers of one way to query, over some queries.
struct Wrong {
    long missed = 0, false_alarms = 0;

    void add(const Answer& answer, bool collides)
    {
        missed += collides && !answer;
        false_alarms += answer && !collides;
    }
    std::string in_words() const { return std::to_string(missed) + " + " + std::to_string(false_alarms); }
};

/// The textbook with no tolerance and with two tolerances, and the certified query.
struct Comparison {
    static constexpr std::array<double, 3> tolerances{0, 1e-9, 1e-6};
    long queries = 0, collide = 0;
    std::array<Wrong, tolerances.size()> textbook;
    Wrong certified;
    std::array<long, 3> settled{};  ///< by the stages of the certified query

    template <class Step>
    void add(const Step& step, bool collides)
    {
        ++queries;
        collide += collides;
        for (std::size_t i = 0; i < tolerances.size(); ++i)
            textbook[i].add(textbook_time_of_impact(step, {1e-12, tolerances[i], tolerances[i]}), collides);
        const CertifiedAnswer answer = certified_answer(step);
        certified.add(answer.time, collides);
        ++settled[static_cast<std::size_t>(answer.stage)];
    }
};

/// Adds the queries of data/NAME.csv, e.g. near_double_root_vf: faces or edges, by the end of its name.
void add_file(Comparison& comparison, const std::filesystem::path& file)
{
    const bool edges = file.stem().string().ends_with("_ee");
    for (const FileQuery& query : read_queries(file))
        edges ? comparison.add(query.edge_edge(), query.collides.value())
              : comparison.add(query.vertex_face(), query.collides.value());
}

/// Comparisons by category, both kinds together, in alphabetical order.
std::map<std::string, Comparison> compare_by_category()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(source_directory() / "chapters/02_collision_detection/data"))
        if (entry.path().extension() == ".csv")
            files.push_back(entry.path());
    std::map<std::string, Comparison> categories;
    for (const auto& file : files) {
        const std::string name = file.stem().string();
        add_file(categories[name.substr(0, name.size() - 3)], file);
    }
    return categories;
}

Table wrong_answers(const std::map<std::string, Comparison>& categories)
{
    Table table({"category", "queries", "collide", "textbook_tol_0", "textbook_tol_1e-9", "textbook_tol_1e-6",
                 "certified", "by_height", "by_doubles", "by_106_bits"});
    for (const auto& [name, c] : categories)
        table.add({name, c.queries, c.collide, c.textbook[0].in_words(), c.textbook[1].in_words(),
                   c.textbook[2].in_words(), c.certified.in_words(), c.settled[0], c.settled[1],
                   c.settled[2]});
    return table;
}

void tell_totals(Report& report, const std::map<std::string, Comparison>& categories)
{
    const auto fact = [&](const std::string& name, const auto& member) {
        long sum = 0;
        for (const auto& [category, comparison] : categories)
            sum += member(comparison);
        report.fact("degenerate", name, static_cast<double>(sum), 6);
    };
    fact("queries", [](const Comparison& c) { return c.queries; });
    fact("collide", [](const Comparison& c) { return c.collide; });
    fact("textbook_missed", [](const Comparison& c) { return c.textbook[0].missed; });
    fact("textbook_false", [](const Comparison& c) { return c.textbook[0].false_alarms; });
    fact("tolerant_missed", [](const Comparison& c) { return c.textbook[2].missed; });
    fact("tolerant_false", [](const Comparison& c) { return c.textbook[2].false_alarms; });
    fact("certified_missed", [](const Comparison& c) { return c.certified.missed; });
    fact("certified_false", [](const Comparison& c) { return c.certified.false_alarms; });
}

}  // namespace

void degenerate(const RunOptions&, Report& report)
{
    const Table cases = answers_to(hard_cases());
    report.table("degenerate", cases);
    report.page_table("degenerate", cases);
    const auto right = [&](std::size_t column) {
        return static_cast<double>(
            std::count_if(cases.rows().begin(), cases.rows().end(),
                          [&](const auto& row) { return std::get<std::string>(row[column]) == "right"; }));
    };
    report.fact("degenerate", "cases", static_cast<double>(cases.rows().size()));
    report.fact("degenerate", "textbook_right", right(3));
    report.fact("degenerate", "certified_right", right(5));

    const auto categories = compare_by_category();
    const Table wrong = wrong_answers(categories);
    report.table("degenerate_categories", wrong);
    report.page_table("degenerate_categories", wrong);
    report.plot("chapters/02_collision_detection/plots/degenerate.gp");
    tell_totals(report, categories);
}

}  // namespace enduring::chapter02
