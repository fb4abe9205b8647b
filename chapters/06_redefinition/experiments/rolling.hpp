#pragma once

#include "chapters/06_redefinition/experiments/make_solver.hpp"
#include "common/geometry/meshes.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter06 {

/// A ball, or a cylinder with flat sides, of 0.2 m on level or sloping ground.
struct Roll {
    PenaltyMethod method = PenaltyMethod::continuous;
    double dt = 0.001;          ///< [s]
    bool on_triangles = false;  ///< instead of an analytic plane
    int sides = 0;              ///< of a cylinder; 0 is a ball
    int subdivisions = 4;       ///< of the ball's faces
    double mass = 20;           ///< [kg]
    double stiffness = 20000;   ///< of one pair [N/m]
    double slope_deg = 15;
    double mu_s = 0.5;      ///< mu_d is 0.8 of it; 0 is no friction at all
    double speed = 0;       ///< of the centre at first [m/s], rolling
    double spin = 0;        ///< at first, beyond rolling: of the surface against the centre [m/s]
    double duration = 1.5;  ///< [s]; the first two fifths of it are not measured

    static constexpr double radius = 0.2;  ///< [m]
};

/// A cylinder about z with so many flat sides; the middles of its two ends are the last vertices.
SurfaceMesh prism(int sides, double radius, double half_length);

struct RollOutcome {
    double acceleration = 0;   ///< of the centre, down the slope [m/s^2]
    double spin_change = 0;    ///< of the surface's speed around the centre [m/s^2]
    double surface_speed = 0;  ///< around the centre, mean [m/s]
    /// acceleration of a round body that rolls without loss, m r^2 g sin / (m r^2 + I) [m/s^2]
    double exact = 0;
    /// what the lever of the step's start takes of the acceleration, by
    /// formula [m/s^2]; without friction, of the spin
    double brake = 0;
};

/// Rolls and takes the means of the last three fifths.
/// @param make_solver  this chapter's, or a later one's
RollOutcome roll(const Roll& roll, const MakeSolver& make_solver = chapter06_solver);

}  // namespace enduring::chapter06
