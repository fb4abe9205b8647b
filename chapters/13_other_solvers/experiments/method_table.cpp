#include "chapters/13_other_solvers/experiments/method_table.hpp"

#include "chapters/10_self_contact/solver.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/engines/experiments/measured_rows.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace enduring::chapter13 {
namespace {

/// Plain numbers and letters, to be kept by sweep().
struct KeptAnswer {
    Answer answer;
    std::array<char, 200> reason{};  ///< empty if there is an answer
};

void append(std::string& list, const std::string& word)
{
    if ((", " + list + ", ").find(", " + word + ", ") == std::string::npos)
        list += (list.empty() ? "" : ", ") + word;
}

}  // namespace

Solver quiet_chapter10(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    settings.threads = 1;
    return chapter10_solver(parameters, settings);
}

const std::vector<Answering>& all_answering()
{
    static const std::vector<Answering> all = [] {
        std::vector<Answering> columns;
        for (const OtherMethod& method : other_methods())
            columns.push_back({method.title, method.make});
        columns.push_back({"chapter 10", quiet_chapter10});
        return columns;
    }();
    return all;
}

std::string with_unit(std::string quantity)
{
    constexpr std::array<std::pair<const char*, const char*>, 5> units{{{"_um_per_s", " [µm/s]"},
                                                                        {"_m_per_s", " [m/s]"},
                                                                        {"_um", " [µm]"},
                                                                        {"_mm", " [mm]"},
                                                                        {"_percent", " [%]"}}};
    for (const auto& [word, unit] : units)
        if (quantity.ends_with(word)) {
            quantity.replace(quantity.size() - std::string(word).size(), std::string::npos, unit);
            break;
        }
    std::replace(quantity.begin(), quantity.end(), '_', ' ');
    return quantity;
}

std::string cell_of(double value, bool right)
{
    return (std::isfinite(value) ? readable(value, 3) : "lost") + (right ? " ✓" : " ✗");
}

void report_refusals(Report& report, const std::string& name, const std::vector<Refusal>& refusals)
{
    struct Line {
        std::string reason, scenes, methods;
    };
    std::vector<Line> lines;
    for (const Refusal& refusal : refusals) {
        auto line = std::find_if(lines.begin(), lines.end(),
                                 [&](const Line& one) { return one.reason == refusal.reason; });
        if (line == lines.end())
            line = lines.insert(line, Line{refusal.reason, "", ""});
        append(line->scenes, refusal.scene);
        append(line->methods, refusal.method);
    }
    Table table({"reason", "scenes", "methods"});
    for (const Line& line : lines)
        table.add({line.reason, line.scenes, line.methods});
    report.table(name + "_not_defined", table);
    report.page_table(name + "_not_defined", table);
}

bool report_answers(const RunOptions& options, Report& report, const std::string& name,
                    const std::vector<Question>& questions)
{
    const std::vector<Answering>& columns = all_answering();
    const auto found = sweep<KeptAnswer>(
        options, name, questions.size() * columns.size(), [&](std::size_t i) {
            KeptAnswer kept;
            try {
                kept.answer = questions[i / columns.size()].ask(columns[i % columns.size()].make);
            } catch (const InputError& refusal) {
                const std::string why = refusal.what();
                std::copy_n(why.begin(), std::min(why.size(), kept.reason.size() - 1), kept.reason.begin());
            }
            return kept;
        });
    if (!found)
        return false;
    std::vector<std::string> head{"scene", "measured"};
    for (const Answering& column : columns)
        head.push_back(column.title);
    Table page(head), table({"scene", "method", "quantity", "value", "right"});
    std::vector<Refusal> refusals;
    for (std::size_t q = 0; q < questions.size(); ++q) {
        const Question& question = questions[q];
        std::vector<Cell> line{question.scene, question.quantity};
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const KeptAnswer& kept = (*found)[q * columns.size() + c];
            if (kept.reason[0] != '\0') {
                line.emplace_back("not defined");
                refusals.push_back({question.scene, columns[c].title, kept.reason.data()});
                continue;
            }
            const auto& [value, right] = kept.answer;
            line.emplace_back(cell_of(value, right));
            table.add({question.scene, columns[c].title, question.quantity, value, right ? "yes" : "no"});
            report.fact(name, engines::fact_word(question.scene) + "_" + engines::fact_word(columns[c].title),
                        value);
        }
        page.add(line);
    }
    report.table(name, table);
    report.page_table(name, page);
    if (!refusals.empty())
        report_refusals(report, name, refusals);
    return true;
}

}  // namespace enduring::chapter13
