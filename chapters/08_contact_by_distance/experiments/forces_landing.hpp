#pragma once

#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

namespace enduring::chapter08::force_rows {

/// On what a round body lands.
enum class Ground { plane, box, over_a_vertex, over_an_edge, beside, slab };
std::string name_of(Ground ground);

/// A cylinder has 192 sides, and so has a torus, which lands upright.
enum class Round { ball, cylinder, torus };

/// A round body that slides when it comes down.
struct Landing {
    Ground ground = Ground::plane;
    Round shape = Round::ball;
    int subdivisions = 5;  ///< of a ball
    double slides = 2;     ///< velocity of its centre along the ground [m/s]
    double rim = 0;        ///< its spin times its radius; what is positive pushes it back [m/s]
    double drop = 0.3;     ///< [m]
    double mu = 0.5, restitution = 0;
    double dt = 1.0 / 60;  ///< [s]
    int turns = 6;         ///< of the body, at random; the mean counts
};
std::string name_of(const Landing& landing);

/// Speed with which it rolls [m/s], three steps after it has ceased to slide.
struct Landed {
    double mean = 0, formula = 0;
    double worst = 0;  ///< error of any one turn, of the formula [1]
    double error() const { return mean / formula - 1; }
};
Landed land(const Landing& landing, const MakeSolver& make);

/// The speed at which a round body rolls whose sliding a step's friction ends [m/s]: m R (v_0 - v) = I w, and
/// dt v = R sin(w dt).
/// @param inertia_ratio  I / (m R^2)
double rolling_speed(double v0, double inertia_ratio, double radius, double dt);

Rows landings(const MakeSolver& make, bool full);

}  // namespace enduring::chapter08::force_rows
