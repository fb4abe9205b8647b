#pragma once

#include "common/experiments/report/progress.hpp"
#include "common/experiments/report/report.hpp"

#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace enduring {

/// The table of many runs, a row each: every row is on the disk when it is added, and the reader is told how
/// many there are. At the end it goes to the report as any table does.
class GrowingTable {
public:
    /// @param rows  that there will be; 0 if nobody knows
    GrowingTable(Report& report, std::string name, std::vector<std::string> columns, std::size_t rows = 0)
        : GrowingTable(report, std::move(name), std::move(columns), std::vector<double>(rows, 1.0))
    {}
    /// @param costs  of all rows to come, in any unit: what is left is reckoned from it
    GrowingTable(Report& report, std::string name, std::vector<std::string> columns,
                 std::vector<double> costs)
        : report_(report), name_(std::move(name)), table_(std::move(columns)), costs_(std::move(costs)),
          all_costs_(std::accumulate(costs_.begin(), costs_.end(), 0.0)),
          progress_("", static_cast<long>(costs_.size()), " rows of " + name_)
    {
        report_.rows_so_far(name_, table_);
    }
    void add(std::vector<Cell> row)
    {
        table_.add(std::move(row));
        report_.rows_so_far(name_, table_);
        const std::size_t rows = table_.rows().size();
        spent_ += rows <= costs_.size() ? costs_[rows - 1] : 0;
        progress_.update(static_cast<long>(rows), spent_ / all_costs_);
    }
    operator const Table&() const { return table_; }
    const std::vector<std::string>& columns() const { return table_.columns(); }
    const std::vector<std::vector<Cell>>& rows() const { return table_.rows(); }

private:
    Report& report_;
    std::string name_;
    Table table_;
    std::vector<double> costs_;
    double all_costs_, spent_ = 0;
    Progress progress_;
};

}  // namespace enduring
