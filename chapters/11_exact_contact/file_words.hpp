#pragma once

#include "common/input/text_lines.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace enduring {

/// The words of a text, one after the other whatever line they stand on, with their lines for messages.
class FileWords {
public:
    /// @throws InputError  the text is empty or binary
    FileWords(const std::string& text, const std::string& file);

    /// Those that are left.
    std::size_t left() const { return words_.size() - place_; }
    /// A word that is still to come, or an empty one behind the last.
    std::string_view peek(std::size_t ahead = 0) const;
    /// @throws InputError  names what is missing or wrong, with its line
    std::string_view next(const char* what);
    int next_integer(const char* what, int least, int most);
    double next_number(const char* what);
    void skip_line();
    [[noreturn]] void fail(const std::string& message) const;

private:
    struct Word {
        std::string_view text;
        int line;
    };
    TextLines lines_;
    std::vector<Word> words_;
    std::size_t place_ = 0;
};

}  // namespace enduring
