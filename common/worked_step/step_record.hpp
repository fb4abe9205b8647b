#pragma once

#include "common/simulation/step.hpp"

#include <string>
#include <vector>

namespace enduring {

/// Everything a step may change on one body.
struct BodyRecord {
    std::vector<Vec3> positions_t0, positions_t1, velocities;
};

/// The whole state as it stands after one stage of a step.
struct StageRecord {
    std::string stage;  ///< "start", a pass's name, or "predict", "update prediction", "commit"
    std::vector<BodyRecord> bodies;
    Contacts contacts;
};

/// Runs advance() and copies every array before it and after each of its stages: for the worked step, and for
/// finding the pass where a number first goes wrong.
std::vector<StageRecord> record_step(World& world, Contacts& contacts, const Solver& solver, double dt);

}  // namespace enduring
