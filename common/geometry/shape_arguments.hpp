#pragma once

#include "common/input/input_error.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace enduring {

/// What the generators of shapes refuse.
/// @throws InputError  unless the length is positive and finite
inline void require_length(const std::string& argument, double value)
{
    if (std::isfinite(value) && value > 0)
        return;
    std::ostringstream message;
    message << argument << " is " << value << "; it must be a positive, finite length in metres";
    throw InputError(message.str());
}

/// @throws InputError  unless lowest <= value <= highest
inline void require_count(const std::string& argument, int value, int lowest, int highest)
{
    if (value < lowest || value > highest)
        throw InputError(argument + " is " + std::to_string(value) + "; it must lie in [" +
                         std::to_string(lowest) + ", " + std::to_string(highest) + "]");
}

/// Cells along each direction: at least one, and few enough that the mesh fits into memory.
template <std::size_t N>
void require_cells(const std::array<int, N>& cells)
{
    double total = 1;
    for (int count : cells) {
        require_count("cells", count, 1, 100000);
        total *= count;
    }
    if (total > 1e7)
        throw InputError("cells: more than 1e7 of them");
}

}  // namespace enduring
