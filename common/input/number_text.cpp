#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace enduring {
namespace {

template <class... Format>
std::string text_of(double value, Format... format)
{
    std::array<char, 400> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
    return {buffer.data(), result.ptr};
}

std::string without_idle_zeros(std::string number)
{
    if (number.find('.') == std::string::npos)
        return number;
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.')
        number.pop_back();
    return number;
}

std::string superscript(int exponent)
{
    static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        text += digits[digit - '0'];
    return text;
}

}  // namespace

std::string shortest(double value) { return text_of(value); }

std::string readable(double value, int digits)
{
    if (value == 0 || !std::isfinite(value))
        return shortest(value);

    // Rounding first settles the power: 9.996 with three digits is 1·10¹, not 10.00·10⁰.
    const std::string scientific = text_of(value, std::chars_format::scientific, digits - 1);
    const std::size_t e = scientific.find('e');
    const int exponent = std::atoi(scientific.c_str() + e + 1);
    if (exponent < -3 || exponent >= 6)
        return without_idle_zeros(scientific.substr(0, e)) + "·10" + superscript(exponent);
    return without_idle_zeros(text_of(value, std::chars_format::fixed, std::max(0, digits - 1 - exponent)));
}

}  // namespace enduring
