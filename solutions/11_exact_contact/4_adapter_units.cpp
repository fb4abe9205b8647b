#include "exercises/11_exact_contact/4_adapter_units.hpp"

#include <cmath>

namespace enduring {

TheirBox box_for(const EngineUnits& units, const OurBox& box)
{
    const double speed = units.length / units.time;
    const double inertia = units.mass * units.length * units.length;
    TheirBox theirs{};
    theirs.half_size = 0.5 * box.size / units.length;
    theirs.mass = box.mass / units.mass;
    theirs.inertia = box.inertia / inertia;
    theirs.velocity = box.velocity / speed;
    theirs.angular_velocity = box.angular_velocity * units.time;
    const auto [w, x, y, z] = box.orientation;
    theirs.orientation = {x, y, z, w};
    theirs.friction = std::sqrt(box.mu);
    return theirs;
}

WorldSettings settings_for(const EngineUnits& units, const WorldSettings& ours)
{
    const double acceleration = units.length / (units.time * units.time);
    WorldSettings theirs{};
    theirs.gravity = ours.gravity / acceleration;
    theirs.dt = ours.dt / units.time;
    theirs.slop = ours.slop / units.length;
    return theirs;
}

Vec3 impulse_from(const EngineUnits& units, const Vec3& theirs)
{
    return units.mass * units.length / units.time * theirs;
}

}  // namespace enduring
