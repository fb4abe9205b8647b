#pragma once

#include "common/experiments/render/picture.hpp"

#include <string>
#include <vector>

namespace enduring {

/// One picture of a strip and the line below it, empty for none.
struct StripPicture {
    Picture picture;
    std::string caption;
};

/// Several moments in one picture, side by side in rows.
/// @param pictures  all of one size
/// @param columns   pictures in a row, 0 for all in one row
Picture strip(const std::vector<StripPicture>& pictures, int columns = 0);

}  // namespace enduring
