#pragma once

#include <string>

namespace enduring {

/// The shortest decimal text that reads back as the same double: 0.1, 1e-15, nan, inf.
std::string shortest(double value);

/// A number for reading, rounded to significant digits without idle zeros: 0.14, 1235, 3.2·10⁻⁷.
/// Powers of ten appear below 10⁻³ and from 10⁶ on; digits before the point are never rounded away.
/// @param digits  significant digits, 1 to 17
std::string readable(double value, int digits);

}  // namespace enduring
