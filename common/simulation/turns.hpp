#pragma once

#include "common/simulation/step.hpp"

#include <vector>

namespace enduring {

/// How far bodies turn in a step without its impulses, to be compared with how far they turn with them.
class Turns {
public:
    /// As fast as these bodies turn now.
    /// @param bodies  by their places in the world
    /// @param dt      length of the step [s]
    Turns(const World& world, std::vector<int> bodies, double dt);
    /// The same of all bodies.
    Turns(const World& world, double dt);

    /// Whether impulses turn a body so far that its vertices leave their straight lines: by more than
    /// `max_turn` [rad] beyond its turn without them. An answer that turns a body by radians may end beside
    /// what pressed it: that solves the equation, too, with any energy.
    bool exceeded(const World& world, double max_turn) const;

private:
    double turn_of(const World& world, int body) const;

    std::vector<int> bodies_;
    double dt_;
    std::vector<double> before_;  ///< of each of these [rad]
};

}  // namespace enduring
