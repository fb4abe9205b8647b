#include "common/experiments/run/centre_of_mass.hpp"

#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

namespace enduring {

Vec3 centre_of_mass(const Body& body)
{
    if (const auto* rigid = dynamic_cast<const RigidBody*>(&body))
        return rigid->motion().centre();
    if (const auto* soft = dynamic_cast<const DeformableBody*>(&body))
        return soft->elastic().centre_of_mass();
    return body.centre();
}

}  // namespace enduring
