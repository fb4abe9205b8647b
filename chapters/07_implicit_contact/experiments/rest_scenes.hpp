#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/meshes.hpp"

#include <array>
#include <string>
#include <vector>

namespace enduring::chapter07 {

/// A polygon in the xy-plane, drawn out along z by the same length to both sides.
/// @param outline  counter-clockwise; its first corner sees all the others [m]
SurfaceMesh prism(const std::vector<std::array<double, 2>>& outline, double length);

/// Pairs of cards that lean against each other on the ground, cards across their tops, and a pair less on
/// each level above: cards of 1 m x 1 m x 2 cm and 1 kg.
/// @param lean_deg  of each card against the vertical
std::vector<Box> card_house(int levels, double lean_deg);

/// A half circle of equal stones on the ground, 1 m thick and 1 m deep, nothing between them.
/// @param radius       to the middle of the stones [m]
/// @param other_depth  of every other stone [m]: if it is less, no corners coincide
Scene arch(int stones, double radius, double dt, double other_depth = 1);

/// What falls into a crack.
enum class Tip { spike, wedge };

/// A spike or a wedge, 1 m long and with the tip down, falls into a crack 1 m deep.
/// @param tip_deg    between the sides of the tip; of a spike, between a face and the edge on its other side
/// @param crack_deg  between the walls of the crack, below 90
Scene tip_in_crack(Tip tip, double tip_deg, double crack_deg, double dt);

/// A wedge with its edge down falls on the edge of another one, across it and
/// off both middles: it tips over and falls to the ground.
Scene wedge_on_edge(double dt);

/// A cube falls 20 cm between two planes, 5 cm off their middle.
/// @param half_angle_deg  of each plane against the vertical
/// @param mu              the coefficient of friction, static and dynamic
Scene cube_between_planes(double half_angle_deg, double mu, double dt);

}  // namespace enduring::chapter07
