#pragma once

#include "common/scenes/scene.hpp"

#include <array>
#include <string>

namespace enduring::chapter08 {

/// In what bodies jam: a cube between two planes, an arch of stones, boxes that a heavy lid presses into a
/// trough, a heap of mixed shapes in a funnel.
enum class Jam { wedge, arch, trough, funnel };
inline constexpr std::array all_jams{Jam::wedge, Jam::arch, Jam::trough, Jam::funnel};
std::string name_of(Jam jam);

/// A jam that nobody has chosen: planes 5 to 30 degrees from the vertical, friction 0.3 to 1.5, steps of 1 ms
/// to 20 ms. What falls meets the planes after about twenty steps.
Scene random_jam(Jam jam, unsigned seed);

}  // namespace enduring::chapter08
