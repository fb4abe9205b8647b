#pragma once

#include "common/geometry/vector.hpp"

#include <random>

namespace enduring {

/// Inputs of checks that look random, and are the same with every compiler and library: the engine is
/// standard, but the library's distributions are not, nor is the order in which arguments are computed.
class RandomInputs {
public:
    explicit RandomInputs(unsigned seed) : engine_(seed) {}

    /// From `low` to `high`.
    double number(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_()) / values;
    }

    /// A whole number from `low` to `high`, both among them.
    int whole(int low, int high)
    {
        return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
    }

    /// A point in the cube from `low` to `high`.
    Vec3 point(double low, double high)
    {
        const double x = number(low, high), y = number(low, high), z = number(low, high);
        return {x, y, z};
    }

private:
    static constexpr double values = 4294967296;  // of the engine: 2^32
    std::mt19937 engine_;
};

}  // namespace enduring
