#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace enduring {

/// A number from its bytes in a binary file.
/// @param at  its first byte; as many as it has must be there
template <class Number>
Number raw_number(const char* at, std::endian order)
{
    std::array<char, sizeof(Number)> bytes;
    std::copy_n(at, bytes.size(), bytes.begin());
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
}

}  // namespace enduring
