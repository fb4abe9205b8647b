#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace enduring {

/// A text file read line by line, which knows where it is when something is wrong.
class TextLines {
public:
    /// @param name  of the file, for messages
    /// @throws InputError  the stream is unreadable or empty, or holds binary data (a NUL byte)
    TextLines(std::istream& stream, std::string name);

    /// Goes to the next line that holds more than blanks; false at the end.
    bool next();
    /// What is left of the line, read word by word; empty at its end.
    std::string_view next_word();
    /// @throws InputError  it is missing, is not a number, or lies outside what the type can hold
    long next_integer(const char* what);
    double next_finite_number(const char* what);

    std::string_view line() const { return line_; }
    const std::string& text() const { return text_; }
    int number() const { return number_; }
    /// A word as it appears in messages: in quotes, cut after 40 characters.
    static std::string quoted(std::string_view word);
    /// @throws InputError  always: "name:line: message"
    [[noreturn]] void fail(const std::string& message) const;
    [[noreturn]] void fail_at(int line, const std::string& message) const;

private:
    std::string name_, text_;
    std::string_view unread_, line_, rest_;
    int number_ = 0;
};

}  // namespace enduring
