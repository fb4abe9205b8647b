#pragma once

#include "common/input/input_error.hpp"

#include <string>

namespace enduring {

/// Gathers what several readers complain about, so that one look at a file tells all that is wrong with it.
class Mistakes {
public:
    /// Runs one reader; what it complains about waits for complain().
    template <class Reader>
    void gather(const Reader& read)
    {
        try {
            read();
        } catch (const InputError& error) {
            const std::string mistake = error.what();
            if (text_.find(mistake) == std::string::npos)  // two readers may stumble over the same thing
                text_ += (text_.empty() ? "" : "\n") + mistake;
        }
    }

    /// @throws InputError  every mistake so far, one a line; nothing when there was none
    void complain() const
    {
        if (!text_.empty())
            throw InputError(text_);
    }

private:
    std::string text_;
};

}  // namespace enduring
