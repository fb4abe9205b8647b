#pragma once

#include "common/geometry/vector.hpp"
#include "common/input/json_value.hpp"
#include "common/scenes/material_reader.hpp"

#include <vector>

namespace enduring {

/// Where a body of a scene starts: x = rotation * X + position for a point X of its shape.
struct Placement {
    Vec3 position = Vec3::Zero();  ///< [m]
    Quaternion rotation = Quaternion::Identity();

    Vec3 place(const Vec3& point) const { return rotation * point + position; }
    std::vector<Vec3> place(const std::vector<Vec3>& points) const;
};

/// How it moves at time 0.
struct InitialMotion {
    Vec3 velocity = Vec3::Zero();          ///< of the centre of mass [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< about the centre of mass, world axes [rad/s]
};

/// The keys "position" and "rotation" of a body, both optional.
Placement read_placement(const JsonValue& body);

/// The keys "velocity" and "angular_velocity" of a body, both optional.
InitialMotion read_motion(const JsonValue& body);

/// Of the key "mass".
inline const NumberRange mass_range{1e-9, 1e9, true, true, "kg"};

/// The body's mass [kg] from one of the keys "density" and "mass", else from the density of its material.
/// @param volume  of its shape [m^3], positive
double read_mass(const JsonValue& body, double volume, const SceneMaterials& materials);

}  // namespace enduring
