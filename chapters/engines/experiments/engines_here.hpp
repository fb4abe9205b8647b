#pragma once

#include "chapters/engines/engine.hpp"

#include <vector>

namespace enduring::engines {

/// The engines that can run on this machine; of each other one a line is printed that says why it cannot.
std::vector<Engine> engines_here();

}  // namespace enduring::engines
