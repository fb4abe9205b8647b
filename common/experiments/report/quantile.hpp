#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace enduring {

/// The value that this part of all values does not exceed; at least one value, part in [0, 1].
template <class Value>
Value quantile(std::vector<Value> values, double part)
{
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

}  // namespace enduring
