#pragma once

#include "chapters/10_self_contact/experiments/soft_runs.hpp"

namespace enduring::chapter10 {

/// A rope that grows out of a post and goes once around it, as one body. Two forces pull along it, one at its
/// free end and one before the turn; between this place and the post it is slack.
struct RoundTurn {
    double radius = 0.012;      ///< of the post [m]
    double thickness = 0.0015;  ///< of the rope [m]
    double width = 0.004;       ///< of the rope [m]
    double pitch = 0.007;       ///< along the post, of the turn [m]
    double back = 0.05;         ///< length of the straight part before the turn, where it is held back [m]
    double front = 0.025;       ///< of the one behind it, which is pulled [m]
    double cell = 0.004;        ///< length of the rope's cells [m]

    double angle() const;  ///< by which the rope turns while it is on the post [rad]
};

/// The rope's shape at rest: it touches the post nowhere, and only just not in the turn.
TetrahedralMesh round_turn_mesh(const RoundTurn& shape);

struct RoundTurnRun {
    SoftRun soft;             ///< of its pulls the first holds back, the second pulls
    std::vector<int> middle;  ///< vertices of the rope in the middle of the turn
};

/// Weightless; the core of the post is held. What holds has the same coefficient as what rubs.
/// @param force  at the free end [N]
/// @param ratio  of this force to that which holds back
RoundTurnRun round_turn(const RoundTurn& shape, const SoftVariant& variant, double force, double ratio);

/// How far the middle of the turn has come along the turn since the scene was made [m]; less than half a
/// turn.
double displacement_of_turn(const RoundTurn& shape, const RoundTurnRun& turn);

}  // namespace enduring::chapter10
