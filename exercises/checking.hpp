#pragma once

#include "common/geometry/vector.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <type_traits>

/// The input of the expectations that follow in this scope; shown when
/// one of them fails. Takes values and texts.
#define given(...) INFO(enduring::in_words(__VA_ARGS__))

namespace enduring {

/// Values and texts in a row, as a student reads them.
template <class... Parts>
std::string in_words(const Parts&... parts)
{
    std::ostringstream words;
    (words << ... << parts);
    return words.str();
}

/// A value as a student reads it: six digits, vectors in brackets, and no zero with a sign.
template <class Value>
std::string readable(const Value& value, int digits = 6)
{
    std::ostringstream text;
    text.precision(digits);
    if constexpr (std::is_arithmetic_v<Value>)
        text << value + Value{};
    else
        text << '('
             << (value.array() + 0.0)
                    .matrix()
                    .transpose()
                    .format(Eigen::IOFormat(digits, Eigen::DontAlignCols, ", ", "; "))
             << ')';
    return text.str();
}

/// "expected 0.9 m, got 0.8 m", with more digits where six do not tell the two apart.
template <class Got, class Expected>
std::string told_apart(const Got& got, const Expected& expected, const std::string& unit)
{
    int digits = 6;
    while (digits < 17 && readable(got, digits) == readable(expected, digits))
        ++digits;
    return "expected " + readable(expected, digits) + unit + ", got " + readable(got, digits) + unit;
}

/// Checks one number or vector, and says what it is when it is wrong:
/// "impulse on p: expected 0.24 N s, got -0.24 N s".
///
/// @param what       the property or quantity
/// @param got        what the exercise returned
/// @param expected   what it should be, from a formula, a quadrature or a symmetry
/// @param tolerance  largest distance of the two, in the same unit
/// @param unit       as in "N s"; empty for a pure number
template <class Got, class Expected>
void expect(const std::string& what, const Got& got, const Expected& expected, double tolerance,
            const std::string& unit = "")
{
    bool right;
    std::string message = what + ": ";
    const std::string behind = unit.empty() ? "" : " " + unit;
    if constexpr (std::is_arithmetic_v<Expected>) {
        right = std::abs(static_cast<double>(got) - static_cast<double>(expected)) <= tolerance;
        message += told_apart(got, expected, behind);
    } else {
        const auto got_plain = got.eval();
        const auto expected_plain = expected.eval();
        right = (got_plain - expected_plain).norm() <= tolerance;
        message += told_apart(got_plain, expected_plain, behind);
    }
    CHECK_MESSAGE(right, message);
}

/// Checks a property that is true or false.
/// @param what  the property, as a sentence that should hold
inline void expect_that(const std::string& what, bool right)
{
    const std::string message = "this should hold: " + what;
    CHECK_MESSAGE(right, message);
}

/// Prints one line of the output that the exercise's page promises: values and texts, three digits each.
template <class... Parts>
void say(const Parts&... parts)
{
    std::ostringstream line;
    line.precision(3);
    (line << ... << parts);
    std::cout << line.str() << std::endl;
}

}  // namespace enduring
