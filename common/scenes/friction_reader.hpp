#pragma once

#include "common/input/json_value.hpp"
#include "common/scenes/scene.hpp"

namespace enduring {

/// The object `friction` of a scene's contact.
/// @param stiffness  k of one pair [N/m], for what the scene leaves out
/// @throws InputError  a key that the model does not know, a value out of range, or mu_d above mu_s
FrictionParameters read_friction(const JsonValue& value, double stiffness);

/// The keys "viscous", "rolling" and "patch" of an object.
/// @param otherwise  what it leaves out
SurfaceLaws read_surface_laws(const JsonValue& value, const SurfaceLaws& otherwise);

/// The object `grain` of a body or plane: the direction as the file gives it, and the factor across.
Grain read_grain(const JsonValue& value);

}  // namespace enduring
