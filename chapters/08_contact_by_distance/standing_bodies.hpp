#pragma once

#include "common/simulation/step.hpp"

#include <map>
#include <utility>
#include <vector>

namespace enduring {

//! [standing_bodies]
/// Bodies that would still cross in a part of a step that is not halved any more, or whose joints' forces are
/// not found in it, and all that joints hold to them. They do not move in this part. Afterwards those that
/// belong together move on as one, with the momentum and the angular momentum that they have together: a hit
/// without a bounce (impact zones: Provot 1997; Harmon et al. 2008). Soft bodies keep how their parts move
/// against each other. With what is held or given among them, rigid ones are at rest, and soft ones keep
/// their velocities, by which their elements go on.
class StandingBodies {
public:
    /// Both stand from now on, and belong together.
    /// @param b  -1 for a plane, or for the world
    /// @return   whether one of them did not stand before
    bool add(World& world, int a, int b);
    /// When the part is the state: they are where they were, and move on together.
    void move_on(World& world);
    void clear();

private:
    bool stand(World& world, int index);

    std::map<int, std::vector<double>> states_;         ///< as they were at the start
    std::vector<std::pair<int, int>> belong_together_;  ///< since they would cross, or are joined
};
//! [standing_bodies]

}  // namespace enduring
