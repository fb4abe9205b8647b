#pragma once

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

/// Doubles as text and back, which the C++ library of Debian's Emscripten does not have yet. Read before each
/// of our files.
namespace std {

inline to_chars_result to_chars(char* first, char* last, double value, chars_format format, int digits)
{
    const int length = snprintf(first, static_cast<size_t>(last - first),
                                format == chars_format::fixed ? "%.*f" : "%.*e", digits, value);
    return {first + length, errc()};
}

/// The fewest digits that read back as the same double.
inline to_chars_result to_chars(char* first, char* last, double value)
{
    int length = 0;
    for (int digits = 1; digits <= 17; ++digits) {
        length = snprintf(first, static_cast<size_t>(last - first), "%.*g", digits, value);
        if (strtod(first, nullptr) == value)
            break;
    }
    return {first + length, errc()};
}

inline from_chars_result from_chars(const char* first, const char* last, double& value)
{
    const string word(first, last);
    char* end = nullptr;
    const double read = strtod(word.c_str(), &end);
    if (end == word.c_str() || strpbrk(word.c_str(), "xX+") == word.c_str())
        return {first, errc::invalid_argument};
    value = read;
    return {first + (end - word.c_str()), errc()};
}

}  // namespace std
