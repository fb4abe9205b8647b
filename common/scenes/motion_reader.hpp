#pragma once

#include "common/input/json_value.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/scenes/placement.hpp"
#include "common/simulation/given_motion.hpp"
#include "common/simulation/outside_load.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// The object "motion" of a static body: what displaces it, and about which point it turns.
struct ReadMotion {
    GivenMotion motion;
    Vec3 centre;  ///< placed [m]
};
ReadMotion read_given_motion(const JsonValue& value, const Placement& placement);

/// The list "forces" of a rigid body; its points and the axes that turn along are those of the shape.
std::vector<OutsideLoad> read_loads(const JsonValue& body, const Placement& placement);

/// The list "forces" of a deformable body, which are spread over it.
std::vector<TimedVector> read_spread_forces(const JsonValue& body);

/// The object "locked" of a rigid body.
struct ReadLocks {
    FreeDirections free;
    std::optional<Vec3> pin{};  ///< a point that is held, placed [m]; it holds all translations
};
ReadLocks read_locks(const JsonValue& body, const Placement& placement);

}  // namespace enduring
