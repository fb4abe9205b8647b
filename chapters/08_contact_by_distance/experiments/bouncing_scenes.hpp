#pragma once

#include "common/scenes/scene.hpp"

#include <string>
#include <vector>

namespace enduring::chapter08 {

/// What a ball falls on.
enum class Floor { plane, triangles, corner_of_triangles };

/// A ball that falls a metre: the part of its height that the first bounce keeps; e^2 by formula.
double kept_height(double e, Floor floor, double dt);

/// The height of such a ball over a plane in each step of some seconds [m].
std::vector<double> heights_of_ball(double e, double dt, double duration);

/// Five equal balls in a line, without weight; the first one comes with 1 m/s.
struct Cradle {
    std::vector<double> velocities;  ///< at the end [m/s]
    double kinetic = 0;              ///< over that at the start
};
Scene cradle_scene(double e, double gap, double dt);
Cradle cradle(double e, double gap, double dt);

/// The same on pins and with weight; the first ball swings down from 35 degrees. Parts of steps that ended
/// badly in a second, and the speed of the last ball behind the first impact over that of the first ball
/// before it.
struct HangingCradle {
    long ended_badly = 0;
    double handed_on = 0;
};
HangingCradle hanging_cradle(double gap, double dt);

/// Energy over a run, as parts of that which moves at the most [-]. What symplectic Euler counts too little
/// in a fall is put back: half a step of weight times velocity.
struct EnergyOfRun {
    double most_gained = 0;  ///< at any step
    double left = 0;         ///< at the end
};

/// A cube that falls on its corner, half a metre, and bounces for some seconds.
EnergyOfRun cube_on_corner(double e, double mu, double dt, double duration = 4);

/// Two soft cubes that fly at each other, without weight.
EnergyOfRun soft_cubes(double e, double dt, const std::string& response = "implicit");

/// Ten cubes that fall on each other from a hundredth of their size: the time at which all are at rest for
/// good [s], or no number.
double rest_of_stack(double e, double dt, int cubes = 10, double duration = 12);

/// A ball without weight that meets the ground at 45 degrees with 1 m/s along and 1 m/s down, and cannot
/// turn.
struct ObliqueBounce {
    double along = 0, up = 0;  ///< velocities behind it [m/s]
};
ObliqueBounce oblique_bounce(double e, double mu, double dt);

/// Balls that lie in a cube of so many along each edge, each a little aside, and fall apart on the ground
/// without friction.
struct BallsApart {
    EnergyOfRun energy;
    double deepest = 0;  ///< of all pairs in all steps [m]
    double sideways =
        0;  ///< momentum of all balls along the ground, over the sum of theirs; the most of all steps
};
BallsApart balls_apart(int along_edge, double e, double dt, double duration);

}  // namespace enduring::chapter08
