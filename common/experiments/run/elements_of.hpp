#pragma once

#include "common/simulation/step.hpp"

#include <string>

namespace enduring {

/// How many elements of which kind a body has, for pages and tables:
/// "48 quadratic elements", or "no elements".
/// @throws InputError  there is no such body
std::string elements_of(const World& world, const std::string& body);

}  // namespace enduring
