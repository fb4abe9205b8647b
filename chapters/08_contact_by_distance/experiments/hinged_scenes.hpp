#pragma once

#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"

namespace enduring::chapter08 {

/// A bar that swings on a hinge at its end, from rest at one radian: its period, 4 sqrt(I / (m g r)) K(sin(1
/// / 2)) [s].
AgainstFormula swinging_bar(double dt);

/// A door on its hinge is hit by a ball that moves at right angles to it.
struct HitDoor {
    AgainstFormula speed;     ///< of the door behind the hit: m v b / (I + m b^2) with the ball's distance b
                              ///< from the hinge [rad/s]
    AgainstFormula momentum;  ///< of both about the hinge: m v b [N m s]
};
/// @param k_dt2_over_m  of the springs (StiffnessChoice)
HitDoor hit_door(double dt, double k_dt2_over_m = StiffnessChoice{}.k_dt2_over_m);

/// A crank, which is a box on a hinge near its end, pushes a slider that is locked to an axis and pressed
/// against it by a force: where the slider is when it is farthest from the largest coordinate of the crank's
/// corners along the axis, in two turns [m].
AgainstFormula slider_crank(double dt);

/// A box over the border of a sheet that moves as given, up, aside and round; its centre is this far beyond
/// the border, negative over the sheet [m]. Whether it is still on the sheet at the end.
bool rides_on_sheet(double beyond, double dt);

/// A rigid sheet lies on a box, over whose sides it reaches, and a ball lies on the sheet: the height of the
/// ball's lowest point, which is that of the box [m].
AgainstFormula sheet_on_box(double dt);

}  // namespace enduring::chapter08
