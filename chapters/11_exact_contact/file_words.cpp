#include "chapters/11_exact_contact/file_words.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

namespace enduring {
namespace {

TextLines lines_of(const std::string& text, const std::string& file)
{
    std::istringstream stream(text);
    return TextLines(stream, file);
}

/// Whether the whole word is a number.
template <class Number>
bool parse(std::string_view word, Number& value)
{
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

}  // namespace

FileWords::FileWords(const std::string& text, const std::string& file) : lines_(lines_of(text, file))
{
    while (lines_.next())
        for (std::string_view word = lines_.next_word(); !word.empty(); word = lines_.next_word())
            words_.push_back({word, lines_.number()});
}

std::string_view FileWords::peek(std::size_t ahead) const
{
    return place_ + ahead < words_.size() ? words_[place_ + ahead].text : std::string_view{};
}

std::string_view FileWords::next(const char* what)
{
    if (place_ == words_.size())
        lines_.fail_at(words_.back().line, std::string("the file ends here: ") + what + " is missing");
    return words_[place_++].text;
}

int FileWords::next_integer(const char* what, int least, int most)
{
    const std::string_view word = next(what);
    int value = 0;
    if (!parse(word, value) || value < least || value > most)
        fail(std::string(what) + " is " + TextLines::quoted(word) + ", not a whole number from " +
             std::to_string(least) + " to " + std::to_string(most));
    return value;
}

double FileWords::next_number(const char* what)
{
    const std::string_view word = next(what);
    double value = 0;
    if (!parse(word, value) || !std::isfinite(value))
        fail(std::string(what) + " has " + TextLines::quoted(word) + ", not a finite number");
    return value;
}

void FileWords::skip_line()
{
    const int line = place_ < words_.size() ? words_[place_].line : 0;
    while (place_ < words_.size() && words_[place_].line == line)
        ++place_;
}

void FileWords::fail(const std::string& message) const
{
    lines_.fail_at(place_ > 0 ? words_[place_ - 1].line : 1, message);
}

}  // namespace enduring
