#include "chapters/07_implicit_contact/elastic_ends.hpp"

#include "common/simulation/deformable_body.hpp"

#include <algorithm>

namespace enduring {

//! [settle]
void settle_soft_bodies(World& world, double dt)
{
    for (const auto& body : world.bodies)
        if (auto* soft = dynamic_cast<DeformableBody*>(body.get()))
            if (!(soft->settle(dt) <= small_imbalance))
                world.attempt.trouble = StepTrouble::unsolved;
}
//! [settle]

std::vector<DeformableBody*> soft_bodies(World& world, const Island& island)
{
    std::vector<DeformableBody*> soft;
    for (const int body : island.bodies)
        if (auto* found = dynamic_cast<DeformableBody*>(world.bodies[static_cast<std::size_t>(body)].get());
            found && found->elastic().approaches_end())
            soft.push_back(found);
    return soft;
}

double approach_ends(const std::vector<DeformableBody*>& soft, double dt)
{
    double most = 0;
    for (DeformableBody* body : soft)
        most = std::max(most, body->approach_end(dt));
    return most;
}

}  // namespace enduring
