#pragma once

#include "chapters/07_implicit_contact/pair_memory.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace enduring {

/// A piece of a tower: a prism that stands on an equilateral triangle.
struct TowerPiece {
    double radius;  ///< from its axis to its corners [m]
    double height;  ///< [m]
    double mass;    ///< [kg]
};

/// From the lowest piece to the highest; each piece has a smaller radius than the piece below.
using Tower = std::vector<TowerPiece>;

constexpr double tower_gravity = 9.81;  ///< [m/s^2]

inline SurfaceMesh prism(double radius, double bottom, double top)
{
    SurfaceMesh mesh;
    for (const double height : {bottom, top})
        for (int corner = 0; corner < 3; ++corner) {
            const double angle = 2 * std::numbers::pi * corner / 3;
            mesh.vertices.emplace_back(radius * std::cos(angle), height, -radius * std::sin(angle));
        }
    mesh.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
    return mesh;
}

/// The tower on the plane y = 0. A gap of a nanometre in each joint lets each pair come from outside, for any
/// rounding. In each joint the three lower corners of a piece meet the top of the piece below, or the ground:
/// three pairs with equal loads. The pieces are the world's bodies, in the tower's order.
inline World world_of(const Tower& tower)
{
    World world;
    world.gravity = Vec3(0, -tower_gravity, 0);
    world.planes.push_back({"ground"});
    double height = 0;
    for (const TowerPiece& piece : tower) {
        height += 1e-9;
        const SurfaceMesh mesh = prism(piece.radius, height, height + piece.height);
        height += piece.height;
        world.bodies.push_back(
            std::make_unique<RigidBody>("piece " + std::to_string(world.bodies.size() + 1), mesh,
                                        with_mass(mass_properties(mesh, 1000), piece.mass)));
    }
    return world;
}

/// Your prediction, written down before anything is measured: by which factor a ton on top of a piece of 1 kg
/// increases the depth of this piece in the ground, with steps of 0.01 s.
double predicted_factor();

/// The force that each joint carries at rest, all three pairs together [N]. Joint i is below piece i.
std::vector<double> loads_of(const Tower& tower);

/// The mass that a pair of joint i feels [kg]: the inverse of the velocity change of the pair by an impulse
/// of 1 N s along its normal. Both pieces move, and both turn, since the impulse acts at a corner of the
/// upper piece; the ground does not move.
double mass_of_pair(const Tower& tower, std::size_t joint);

/// The law: the depth of each joint at rest [m], positive.
std::vector<double> law_of_depths(const Tower& tower, const StiffnessChoice& choice, double dt);

/// The same, measured after some seconds with chapter 7's solver and this choice of stiffness: the distance
/// of the lower side of each piece below the top of the piece under it, or below the ground.
std::vector<double> measured_depths(const Tower& tower, const StiffnessChoice& choice, double dt,
                                    double seconds);

}  // namespace enduring
