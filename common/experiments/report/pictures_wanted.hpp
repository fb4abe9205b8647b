#pragma once

namespace enduring {

/// Whether this program draws. What is not wanted has no pixels, and writing it takes an old file away.
bool pictures_wanted();

/// With false, this program draws no pictures, plots or films from now on (--no-pictures).
void want_pictures(bool wanted);

}  // namespace enduring
