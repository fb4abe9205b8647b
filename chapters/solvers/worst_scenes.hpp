#pragma once

#include "common/scenes/scene.hpp"

namespace enduring::solvers {

/// Rigid bodies that are hit, made by code. Lengths in metres; the ground is the plane y = 0; mu = 0.5.

/// A wall of bricks of 15 kg and 40 x 20 x 20 cm, each row half a brick beside the one below. A ball of 200
/// kg and 15 m/s hits its middle.
/// @param columns, rows  of bricks, at least 1
Scene hit_wall(int columns, int rows);

/// Spheres of 1 kg and 20 cm that fall into a box without a lid, in layers of 4 x 4.
/// @param count  of spheres, at least 1
Scene poured_spheres(int count);

/// The same spheres in a funnel of four plates: they run out of its hole, which is 60 cm wide.
Scene hopper(int count);

/// A chain of ring links, each through the next, lies straight and sags: its first and its last link stand
/// still.
/// @param links  at least 2
Scene hanging_chain(int links);

/// A closed bicycle chain that lies on its side, at rest: outer links on the ground, inner ones on their
/// plates. All pins stand in the middle of their bores.
/// @param links  even, at least 6
Scene bicycle_chain(int links);

}  // namespace enduring::solvers
