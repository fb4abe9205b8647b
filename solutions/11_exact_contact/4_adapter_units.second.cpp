#include "exercises/11_exact_contact/4_adapter_units.hpp"

#include <cmath>

namespace enduring {
namespace {

/// The powers of a quantity's unit.
struct Dimension {
    int length, mass, time;
};
constexpr Dimension a_length{1, 0, 0}, a_mass{0, 1, 0}, a_time{0, 0, 1}, an_inertia{2, 1, 0},
    a_velocity{1, 0, -1}, a_rate{0, 0, -1}, an_acceleration{1, 0, -2}, an_impulse{1, 1, -1};

/// The engine's unit of it, in ours: every quantity takes this one line.
double unit_of(const EngineUnits& units, const Dimension& of)
{
    return std::pow(units.length, of.length) * std::pow(units.mass, of.mass) * std::pow(units.time, of.time);
}

}  // namespace

TheirBox box_for(const EngineUnits& units, const OurBox& box)
{
    return {box.size / (2 * unit_of(units, a_length)),
            box.mass / unit_of(units, a_mass),
            box.inertia / unit_of(units, an_inertia),
            box.velocity / unit_of(units, a_velocity),
            box.angular_velocity / unit_of(units, a_rate),
            {box.orientation[1], box.orientation[2], box.orientation[3], box.orientation[0]},
            std::pow(box.mu, 0.5)};
}

WorldSettings settings_for(const EngineUnits& units, const WorldSettings& ours)
{
    return {ours.gravity / unit_of(units, an_acceleration), ours.dt / unit_of(units, a_time),
            ours.slop / unit_of(units, a_length)};
}

Vec3 impulse_from(const EngineUnits& units, const Vec3& theirs)
{
    return unit_of(units, an_impulse) * theirs;
}

}  // namespace enduring
