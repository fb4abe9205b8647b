#pragma once

#include "common/fem/material.hpp"
#include "common/simulation/step.hpp"

#include <string>

namespace enduring::chapter08 {

/// A soft block of 0.4 m, or a bunny, between a plate that stands and one that comes down as given within a
/// second, and then stays.
struct PressedSoft {
    std::string shape = "block";  ///< or "bunny"
    ElasticLaw law = ElasticLaw::neo_hookean;
    std::string basis = "linear";
    double mu = 0;        ///< between plates and body
    double height = 0.7;  ///< that is left, of what it was
    double dt = 0.01;     ///< [s]
};

struct PressedOutcome {
    double force = 0;       ///< on the upper plate at the end [N]
    double formula = 0;     ///< of a block without friction, whose strain is the same everywhere; else 0 [N]
    double deepest_mm = 0;  ///< of any pair at any step [mm]
    int inverted = 0;       ///< most elements at any step
    int unsolved = 0;       ///< steps that ended badly
};
PressedOutcome press_soft(const PressedSoft& plan);

/// The force that presses a block of 0.4 m, Young's modulus 1e5 Pa and Poisson's ratio 0.4 to a part of its
/// height while nothing holds its sides [N].
double force_without_friction(ElasticLaw law, double height);

}  // namespace enduring::chapter08
