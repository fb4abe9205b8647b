#include "common/simulation/turns.hpp"

#include <numeric>
#include <utility>

namespace enduring {
namespace {

std::vector<int> all_bodies(const World& world)
{
    std::vector<int> bodies(world.bodies.size());
    std::iota(bodies.begin(), bodies.end(), 0);
    return bodies;
}

}  // namespace

//! [turns]
Turns::Turns(const World& world, std::vector<int> bodies, double dt) : bodies_(std::move(bodies)), dt_(dt)
{
    for (const int body : bodies_)
        before_.push_back(turn_of(world, body));
}

bool Turns::exceeded(const World& world, double max_turn) const
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (!(turn_of(world, bodies_[i]) <= before_[i] + max_turn))  // what is no number, too
            return true;
    return false;
}

double Turns::turn_of(const World& world, int body) const
{
    return dt_ * world.bodies[static_cast<std::size_t>(body)]->turning_speed();
}
//! [turns]

Turns::Turns(const World& world, double dt) : Turns(world, all_bodies(world), dt) {}

}  // namespace enduring
