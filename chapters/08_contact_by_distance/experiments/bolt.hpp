#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/meshes.hpp"

namespace enduring::chapter08 {

/// A thread with one start, by a formula: a ridge between two flanks and two cylinders that climbs by `lead`
/// a turn.
struct Thread {
    double lead = 0.01328;                       ///< [m]
    double inner_radius = 0.030, depth = 0.006;  ///< of the groove, and of the ridge above it [m]
    double flank = 0.577;                        ///< height of a flank over its depth
};

/// A bolt of 0.5 kg that stands in a nut on two turns of its thread, without friction.
struct BoltInNut {
    Thread thread{};
    int segments = 96, bolt_segments = 84;  ///< in a turn, of the nut and of the bolt
    double dt = 0.01;
    double play = 5e-4;    ///< of the ridge in its groove, away from the axis [m]
    double above = 5e-5;   ///< of the ridge over the lower side of its groove [m]
    bool nut_held = true;  ///< else it falls, too
    static constexpr double mass = 0.5, squared_gyration = 6.12e-4;  ///< [kg], [m^2]
};

Scene scene_of(const BoltInNut& bolt);

/// How far a bolt has fallen after half a second.
struct BoltFall {
    double fallen_mm = 0, by_energy_mm = 0;
    double aside_mm = 0;  ///< of its axis
    double energy_gain_j = 0;
    double pairs = 0, edge_pairs = 0;  ///< that push, on average
    chapter07::SolveStatistics solves;
};

BoltFall drop_bolt(const BoltInNut& bolt, Probe* observer = nullptr);

}  // namespace enduring::chapter08
