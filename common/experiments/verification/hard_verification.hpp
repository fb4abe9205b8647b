#pragma once

#include "common/experiments/report/table.hpp"
#include "common/fem/elastic_body.hpp"

namespace enduring::verification {

/// As a scene's "elasticity" names it.
const char* name_of(ElasticLaw law);

/// A soft body that is deformed hard, held so, and let go.
struct HardLoad {
    ElasticLaw law = ElasticLaw::corotated;
    Basis basis = Basis::quadratic;
    double young = 1e5;  ///< [Pa]
    double dt = 0.01;    ///< [s]
};
struct HardOutcome {
    int inverted_held = 0, inverted_free = 0;  ///< elements, the most after any step
    double held = 0;                           ///< energy when it is let go [J]
    double gain = 0;                           ///< most that the energy rises above that afterwards [J]
    double left = 0;  ///< largest distance of a node from its place at rest, two seconds later [m]
};
/// A bar of 1 x 0.2 x 0.2 m, clamped at one end; the other end is turned once about its axis within a second.
HardOutcome twist_once(const HardLoad& load);
/// A block of 0.4 m between two plates that hold its faces: within half a second it is pressed to 30 % of its
/// height. The upper plate lets it go.
HardOutcome press_flat(const HardLoad& load);

/// Both over bases, laws and, unless it has to be quick, stiffnesses and steps. Columns basis, elasticity,
/// young_pa, dt_s, inverted_held, inverted_free, held_j, gain_j, left_mm.
Table hard_loads(HardOutcome (*load)(const HardLoad&), bool quick);

/// Share of its angular momentum that a free bar loses in a second while it tumbles and bends.
double lost_while_tumbling(const HardLoad& load);
/// The above over bases, laws and steps. Columns basis, elasticity, then one for each step.
Table tumbling_losses();

}  // namespace enduring::verification
