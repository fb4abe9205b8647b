#include "common/experiments/run/step_costs.hpp"

#include "common/experiments/report/quantile.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <numeric>

namespace enduring {
namespace {

/// The pass before detection that finds no pairs: it brings elastic forces to the end of the step.
constexpr const char* elastic_pass = "find elastic ends";

std::vector<std::string> cost_columns()
{
    std::vector<std::string> names{"time_s", "pairs"};
    visit_work(StepWork{}, [&](const char* name, auto) { names.emplace_back(name); });
    names.emplace_back("inverted_elements");
    return names;
}

double number(const Cell& cell)
{
    return std::holds_alternative<long>(cell) ? static_cast<double>(std::get<long>(cell))
                                              : std::get<double>(cell);
}

}  // namespace

StepCosts::StepCosts() : TableProbe(cost_columns()) {}

void StepCosts::observe(const World& world, const Contacts& contacts, double)
{
    if (!std::exchange(began_, true))
        return;
    std::vector<Cell> row{world.time, static_cast<long>(contacts.size())};
    visit_work(world.work, [&](const char*, auto value) { row.emplace_back(value); });
    long inverted = 0;
    for (const auto& body : world.bodies)
        inverted += body->inverted_elements();
    row.emplace_back(inverted);
    table_.add(std::move(row));
}

std::vector<double> StepCosts::column(const std::string& name) const
{
    const auto& columns = table_.columns();
    const auto place =
        static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin());
    std::vector<double> numbers;
    for (const std::vector<Cell>& row : table_.rows())
        numbers.push_back(number(row.at(place)));
    return numbers;
}

StepTimes::StepTimes(const Solver& solver)
    : TableProbe({"time_s", "search_ms", "query_ms", "solve_ms", "rest_ms"})
{
    for (const auto& [stage, kind] :
         {std::pair{StepStage::refresh, search}, std::pair{StepStage::detect, query},
          std::pair{StepStage::respond, solve}, std::pair{StepStage::finish, solve},
          std::pair{StepStage::after_commit, solve}})
        for (const Pass& pass : solver.passes(stage))
            kind_of_.emplace_back(pass.name, pass.name == elastic_pass ? solve : kind);
}

void StepTimes::begin()
{
    last_ = processor_seconds_of_all_threads();
    spent_ = {};
    runs_ = true;
}

void StepTimes::lap(const std::string& pass)
{
    const double now = processor_seconds_of_all_threads();
    const auto known = std::find_if(kind_of_.begin(), kind_of_.end(),
                                    [&](const auto& one) { return one.first == pass; });
    spent_[known == kind_of_.end() ? rest : known->second] += now - last_;
    last_ = now;
}

void StepTimes::observe(const World& world, const Contacts&, double)
{
    if (!runs_)
        return;
    std::vector<Cell> row{world.time};
    for (const double seconds : spent_)
        row.emplace_back(1000 * seconds);
    table_.add(std::move(row));
}

std::vector<double> StepTimes::totals() const
{
    std::vector<double> sums;
    for (const std::vector<Cell>& row : table_.rows())
        sums.push_back(std::accumulate(row.begin() + 1, row.end(), 0.0,
                                       [](double sum, const Cell& cell) { return sum + number(cell); }));
    return sums;
}

std::string mean_and_worst(const std::vector<double>& of_step, const std::string& unit, int first)
{
    const double mean = std::accumulate(of_step.begin(), of_step.end(), 0.0) /
                        static_cast<double>(of_step.size());
    const auto worst = std::max_element(of_step.begin(), of_step.end());
    return readable(mean, 3) + unit + " in the mean, " + readable(quantile(of_step, 0.99), 3) + unit +
           " in 99 % of them, " + readable(*worst, 3) + unit + " at most (step " +
           std::to_string(first + (worst - of_step.begin())) + ")";
}

}  // namespace enduring
