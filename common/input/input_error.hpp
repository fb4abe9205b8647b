#pragma once

#include <stdexcept>

namespace enduring {

/// What the user gave cannot be used: a file, a scene, an argument. The message names the file and line, or
/// the argument and its allowed range; the programs print it and exit with code 2.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace enduring
