#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/meshes.hpp"

#include <vector>

namespace enduring::chapter08 {

/// What swings without friction in something round made of facets, and begins at rest beside its lowest
/// place.
struct Swing {
    Scene scene;                  ///< the round thing, then the body that swings in it
    SurfaceMesh hollow;           ///< of the round thing: outside is in front of all its faces
    double crease = 0;            ///< angle between two facets along the way [rad]
    double amplitude = 0;         ///< at first, seen from the middle of the round thing [rad]
    double arm = 0;               ///< from that middle to the centre of mass [m]
    double squared_gyration = 0;  ///< of what turns with the swing [m^2]
    double half_angle = 0;  ///< between the two places where the body touches, seen from the middle [rad]
    double radius = 1;      ///< of the round thing [m]
    double direction = 0;   ///< of the swing, about the vertical [rad]
    double slant = 1;       ///< cosine between the normals where the body touches and the plane of the swing
};

/// A block of 0.2 x 0.1 x 0.3 m in a half pipe, an open surface whose half circle has so many facets.
Swing block_in_pipe(int facets, double dt);
/// A ball of 0.2 m in the course's bowl of 1 m; its swing passes over facets askew.
Swing ball_in_bowl(int segments_around, int segments_along, double dt);

/// A block inside of a torus that stands upright, 0.7 m to the middle of its tube of 0.3 m, which has 24
/// facets around it.
Swing block_in_torus(int facets, double dt);

/// The part of its amplitude that an inelastic body keeps after one period: at each crease it loses its
/// velocity against the next facet, and nothing else.
double inelastic_bound(const Swing& swing);
/// Period of the pendulum of the same arm [s], for swings of this amplitude.
double pendulum_period(const Swing& swing, double amplitude);

struct SwingOutcome {
    double kept = 0;        ///< part of the amplitude after one period
    double period_s = 0;    ///< between two passages of the lowest place in one direction
    double deepest_mm = 0;  ///< vertex behind a facet, by geometry and not by pairs
    double energy_gain_j = 0;
    double pairs = 0, edge_pairs = 0;  ///< that push, on average
    chapter07::SolveStatistics solves;
};

/// Runs it for one period and a quarter; the observer, if any, sees each step.
SwingOutcome watch_swing(Swing& swing, Probe* observer = nullptr);

}  // namespace enduring::chapter08
