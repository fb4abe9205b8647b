#include "chapters/03_penalty_impulses/experiments/jitter.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter03 {

//! [jitter]
double jitter(const std::vector<double>& forces, double weight)
{
    double sum = 0;
    for (std::size_t i = 1; i + 1 < forces.size(); ++i) {
        const double second_difference = forces[i - 1] - 2 * forces[i] + forces[i + 1];
        sum += second_difference * second_difference;
    }
    return std::sqrt(sum / static_cast<double>(forces.size() - 2)) / 4 / weight;
}
//! [jitter]

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace enduring::chapter03
