#pragma once

#include <cmath>
#include <numeric>
#include <span>

namespace enduring {

/// Of at least one number.
inline double mean(std::span<const double> numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

/// The power with which a cost grows with a count: the slope of the logarithms between two measurements. All
/// four are positive.
inline double growth_power(double count_0, double cost_0, double count_1, double cost_1)
{
    return std::log(cost_1 / cost_0) / std::log(count_1 / count_0);
}

}  // namespace enduring
