#pragma once

#include "common/input/json_value.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// The most joints of a scene.
inline constexpr std::size_t max_joints = 10'000;

/// Builds one entry of a scene's "joints" between bodies of the world as they lie at the start.
/// @throws InputError  anything the format does not allow, with the JSON path
Joint read_joint(const JsonValue& value, const World& world);

}  // namespace enduring
