#pragma once

#include "common/experiments/render/picture.hpp"

#include <string>

namespace enduring {

/// How two pictures differ when seen from a little further away.
struct PictureDifference {
    bool same = false;
    int tiles_off = 0;      ///< tiles of 4 x 4 pixels whose mean colour differs visibly
    int tiles_allowed = 0;  ///< so many may
    int largest = 0;        ///< largest difference of a tile's mean, in grey levels of 255
    std::string message;    ///< one line, in words
};

/// Compares tile by tile. Rounding on another CPU changes pixels by a level or two and
/// single pixels on outlines by more; neither moves the mean of a tile by 12 levels. A body
/// that is missing or has moved changes many tiles by more.
PictureDifference compare_pictures(const Picture& got, const Picture& expected);

/// Grey where the two agree, red where they differ.
Picture difference_picture(const Picture& got, const Picture& expected);

}  // namespace enduring
