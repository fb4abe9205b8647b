#pragma once

#include "common/simulation/body.hpp"

namespace enduring {

/// Of the committed state [m]; of a body without mass, the mean of its surface vertices.
Vec3 centre_of_mass(const Body& body);

}  // namespace enduring
