#pragma once

#include "common/geometry/vector.hpp"

#include <random>
#include <utility>
#include <vector>

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

    /// Of a bell curve about 0 with width 1: the sum of twelve numbers, which no library rounds otherwise.
    double normal()
    {
        double sum = -6;
        for (int i = 0; i < 12; ++i)
            sum += number(0, 1);
        return sum;
    }

    /// Three of a bell curve.
    Vec3 normal_vector()
    {
        const double x = normal(), y = normal(), z = normal();
        return {x, y, z};
    }

    /// A unit vector; no direction is likelier than another.
    Vec3 direction()
    {
        for (;;)
            if (const Vec3 within = point(-1, 1); within.norm() < 1 && within.norm() > 0.1)
                return within.normalized();
    }

    /// Brings values into another order.
    template <class Value>
    void shuffle(std::vector<Value>& values_in_a_row)
    {
        for (int i = static_cast<int>(values_in_a_row.size()) - 1; i > 0; --i)
            std::swap(values_in_a_row[static_cast<std::size_t>(i)],
                      values_in_a_row[static_cast<std::size_t>(whole(0, i))]);
    }

private:
    static constexpr double values = 4294967296;  // of the engine: 2^32
    std::mt19937 engine_;
};

}  // namespace enduring
