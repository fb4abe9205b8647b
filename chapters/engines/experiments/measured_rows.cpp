#include "chapters/engines/experiments/measured_rows.hpp"

#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

namespace enduring::engines {

std::vector<MeasuredRow> measured_rows(const std::string& name)
{
    const auto path = source_directory() / "chapters/engines/measured" / name;
    std::ifstream file(path);
    std::string line, cell;
    std::vector<std::string> columns;
    std::vector<MeasuredRow> rows;
    while (std::getline(file, line)) {
        std::istringstream cells(line);
        if (columns.empty()) {
            while (std::getline(cells, cell, ','))
                columns.push_back(cell);
            continue;
        }
        MeasuredRow row;
        for (const std::string& column : columns) {
            std::getline(cells, cell, ',');
            row[column] = cell;
        }
        rows.push_back(std::move(row));
    }
    if (rows.empty())
        throw InputError(path.string() + ": no measurements");
    return rows;
}

double measured_number(const std::string& text) { return text == "inf" ? INFINITY : std::stod(text); }

std::string fact_word(std::string title)
{
    std::replace(title.begin(), title.end(), ' ', '_');
    return title;
}

}  // namespace enduring::engines
