#include "common/input/text_lines.hpp"

#include "common/input/input_error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace enduring {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

/// std::from_chars over the whole word; a leading plus, which it refuses, is allowed.
template <class Number>
std::errc parse(std::string_view word, Number& value)
{
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc() && end != word.data() + word.size())
        return std::errc::invalid_argument;
    return error;
}

}  // namespace

TextLines::TextLines(std::istream& stream, std::string name) : name_(std::move(name))
{
    text_.assign(std::istreambuf_iterator<char>(stream), {});
    if (stream.bad())
        throw InputError(name_ + ": cannot be read");
    if (text_.find_first_not_of(" \t\r\n") == std::string::npos)
        throw InputError(name_ + ": the file is empty");
    if (const auto at = text_.find('\0'); at != std::string::npos) {
        const auto line = 1 +
                          std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        fail_at(static_cast<int>(line), "binary data; only text files can be read");
    }
    unread_ = text_;
}

bool TextLines::next()
{
    while (!unread_.empty()) {
        const auto end = unread_.find('\n');
        line_ = unread_.substr(0, end);
        unread_ = end == std::string_view::npos ? std::string_view{} : unread_.substr(end + 1);
        ++number_;
        const auto first = line_.find_first_not_of(blanks);
        if (first == std::string_view::npos)
            continue;
        line_ = line_.substr(first, line_.find_last_not_of(blanks) + 1 - first);
        rest_ = line_;
        return true;
    }
    line_ = rest_ = {};
    return false;
}

std::string_view TextLines::next_word()
{
    const auto first = rest_.find_first_not_of(blanks);
    rest_ = first == std::string_view::npos ? std::string_view{} : rest_.substr(first);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_ = rest_.substr(word.size());
    return word;
}

long TextLines::next_integer(const char* what)
{
    const std::string_view word = next_word();
    long value = 0;
    if (word.empty())
        fail(std::string(what) + " is missing");
    if (parse(word, value) != std::errc())
        fail(std::string(what) + " is " + quoted(word) + ", not a whole number");
    return value;
}

double TextLines::next_finite_number(const char* what)
{
    const std::string_view word = next_word();
    double value = 0;
    if (word.empty())
        fail(std::string(what) + " is missing");
    const std::errc error = parse(word, value);
    if (error == std::errc::invalid_argument)
        fail(std::string(what) + " is " + quoted(word) + ", not a number");
    if (error != std::errc() || !std::isfinite(value))
        fail(std::string(what) + " is " + quoted(word) + ", not a finite number");
    return value;
}

std::string TextLines::quoted(std::string_view word)
{
    return std::string(1, '\'').append(word.substr(0, 40)).append(1, '\'');
}

void TextLines::fail(const std::string& message) const { fail_at(number_, message); }

void TextLines::fail_at(int line, const std::string& message) const
{
    throw InputError(name_ + ":" + std::to_string(line) + ": " + message);
}

}  // namespace enduring
