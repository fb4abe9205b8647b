#pragma once

#include "common/simulation/step.hpp"

#include <map>
#include <utility>
#include <vector>

namespace enduring {

//! [standing_bodies]
/// Bodies that would still cross in a part of a step that is not halved any more. They do not move in it.
/// Afterwards those that would cross each other move on as one, with the momentum and the angular momentum
/// that they have together: a hit without a bounce (impact zones: Provot 1997; Harmon et al. 2008). Soft
/// bodies keep how their parts move against each other. With what is held or given among them, rigid ones are
/// at rest, and soft ones keep their velocities, by which their elements go on.
class StandingBodies {
public:
    /// Those of a pair stand from now on, and belong together.
    /// @return  whether one of them did not stand before
    bool add(World& world, const Contact& contact);
    /// When the part is the state: they are where they were, and move on together.
    void move_on(World& world);
    void clear();

private:
    std::map<int, std::vector<double>> states_;  ///< as they were at the start
    std::vector<std::pair<int, int>> crossing_;  ///< which of them would cross
};
//! [standing_bodies]

}  // namespace enduring
