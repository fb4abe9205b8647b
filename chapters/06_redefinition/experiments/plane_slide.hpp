#pragma once

#include "common/experiments/run/probes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/scenes/scene.hpp"

namespace enduring::chapter06 {

/// Where the cube of scene sliding_plane starts, in whose triangles, and in which of eight directions it
/// goes. It crosses 20 cells along x, along z, or along both.
struct PlaneSlide {
    GridDiagonals diagonals = GridDiagonals::same;
    int direction = 0;        ///< times 45 degrees from +x towards +z
    bool on_lattice = false;  ///< its faces start on lines of the grid instead of between them
    double stiffness = 30000;
    double dt = 0.001;
    bool may_gain_energy = false;  ///< shows on purpose what too stiff a contact does (see RunLimits)
};

inline constexpr double slide_speed = 2;  ///< [m/s]
inline constexpr int slide_cells = 20;
/// For tables.
inline constexpr std::array<GridDiagonals, 3> all_diagonals{GridDiagonals::same, GridDiagonals::alternating,
                                                            GridDiagonals::crossed};
std::string name_of(GridDiagonals diagonals);

Scene scene_of(const PlaneSlide& slide);

/// How the cube came through. Speeds are parts of its first speed.
struct SlideOutcome {
    double speed_change = 0;         ///< largest departure along its direction, with its sign
    double sideways_speed = 0;       ///< largest, along the floor and across its direction
    double mean_pairs = 0;           ///< that pushed, per step
    double sag = 0;                  ///< m g / (n k) for that n [m]
    double lowest = 0, highest = 0;  ///< of the cube's lowest vertex [m], after the first tenth of the run
};

/// Runs a slide under a solver made for it.
/// @param observer  if given, sees the run too
SlideOutcome slide_over_plane(const PlaneSlide& slide, const Solver& solver, Probe* observer = nullptr);

}  // namespace enduring::chapter06
