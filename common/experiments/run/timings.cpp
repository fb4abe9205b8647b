#include "common/experiments/run/timings.hpp"

#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>

namespace enduring {

void Timings::start() { last_ = processor_seconds(); }

void Timings::lap(const std::string& pass)
{
    const double now = processor_seconds();
    add(pass, now - last_);
    last_ = now;
}

void Timings::add(const std::string& pass, double seconds)
{
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.pass == pass; });
    if (row == rows_.end())
        row = rows_.insert(rows_.end(), Row{pass});
    ++row->calls;
    row->seconds += seconds;
}

double Timings::total() const
{
    double sum = 0;
    for (const Row& row : rows_)
        sum += row.seconds;
    return sum;
}

double Timings::of(const std::string& pass) const
{
    const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.pass == pass; });
    return row == rows_.end() ? 0 : row->seconds;
}

Table Timings::table(double simulated_seconds, int steps) const
{
    const double all = std::max(total(), 1e-12), per_step = 1000.0 / std::max(1, steps);
    Table table({"pass", "calls", "seconds", "share", "ms_per_step"});
    for (const Row& row : rows_)
        table.add({row.pass, row.calls, row.seconds, row.seconds / all, row.seconds * per_step});
    table.add({"total", static_cast<long>(steps), total(), 1.0, total() * per_step});
    table.add(
        {"real-time factor", static_cast<long>(steps), simulated_seconds, simulated_seconds / all, 0.0});
    return table;
}

}  // namespace enduring
