#include "exercises/11_exact_contact/4_adapter_units.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <cmath>

namespace enduring {

TheirBox box_for(const EngineUnits& units, const OurBox& box)
{
    not_implemented_yet("11.4");
}

WorldSettings settings_for(const EngineUnits& units, const WorldSettings& ours)
{
    not_implemented_yet("11.4");
}

Vec3 impulse_from(const EngineUnits& units, const Vec3& theirs)
{
    not_implemented_yet("11.4");
}

}  // namespace enduring
