#pragma once

#include <string>

namespace enduring::chapter08 {

/// What a run measured, and what a formula says.
struct AgainstFormula {
    double measured, formula;

    double error() const { return measured / formula - 1; }
};

/// A cube on a piston that moves up and down as a table of 64 rows a period says: the height of its top dead
/// centre, from A (1 - cos(omega t)) [m].
AgainstFormula piston(double dt);

/// A small block on a turntable that turns faster and faster: the speed at which it slides off, sqrt(mu_s g /
/// r) [rad/s].
AgainstFormula turntable_slip(double dt);

/// A block that is put on a belt which runs with v.
struct Conveyed {
    AgainstFormula slid;  ///< how far the belt runs under it before both are as fast: v^2 / (2 mu_d g) [m]
    AgainstFormula heat;  ///< what the belt's drive gives and the block has not: m v^2 / 2 [J]
};
Conveyed conveyor(double dt);

/// A puck on the ground under a force from rest: (F / m - mu_d g) t^2 / 2 [m].
AgainstFormula pushed_puck(double dt);

/// A wheel that can only turn about its axle, from a torque and a force on its rim: (T + F r) t / I [rad/s].
AgainstFormula torque_on_wheel(double dt);

/// A locked slider that is hit by a ball which sticks to nothing: their momentum along the free axis [N s].
AgainstFormula hit_slider(double dt);

/// A block of one material on a slope of another: its acceleration, g (sin - mu_d cos) above the angle of
/// mu_s [m/s^2].
AgainstFormula slide_of_materials(double slope_deg, double dt);

/// Whether the same block stays, within a tenth of a millimetre for a second.
bool materials_hold(double slope_deg, double dt);

}  // namespace enduring::chapter08
