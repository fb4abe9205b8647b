#pragma once

#include "common/input/json_value.hpp"
#include "common/rigid/rigid_motion.hpp"
#include "common/scenes/placement.hpp"
#include "common/simulation/given_motion.hpp"
#include "common/simulation/outside_load.hpp"
#include "common/simulation/rigid_body.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// The object "motion" of a static body: what displaces it, and about which point it turns.
struct ReadMotion {
    GivenMotion motion;
    Vec3 centre;  ///< placed [m]
};
ReadMotion read_given_motion(const JsonValue& value, const Placement& placement);

/// The key "time" of a row of a table [s], a microsecond or more later than that of the row before.
/// @param before  none for the first row
double read_time(const JsonValue& row, const double* before);

/// Until when nodes are held, or a motion lasts [s]: the key "until", or for ever.
double read_until(const JsonValue& value);

/// The list "forces" of a rigid body; its points and the axes that turn along are those of the shape.
std::vector<OutsideLoad> read_loads(const JsonValue& body, const Placement& placement);

/// The force of an entry of "forces" [N], constant or a table of forces alone.
TimedVector read_force(const JsonValue& entry);

/// Springs between a body and the world, whose forces are those of the start of a step, have to be slow
/// beside it.
/// @throws InputError  one of the body's springs is too stiff for steps of dt [s]
void require_slow_springs(const JsonValue& body, const RigidBody& of, double dt);

/// The object "locked" of a rigid body.
struct ReadLocks {
    FreeDirections free;
    std::optional<Vec3> pin{};  ///< a point that is held, placed [m]; it holds all translations
};
ReadLocks read_locks(const JsonValue& body, const Placement& placement);

}  // namespace enduring
