#pragma once

#include "common/simulation/contact.hpp"
#include "common/simulation/normal_law.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// Where the two points of a contact lie at one moment of the step.
struct ContactGeometry {
    Vec3 p = Vec3::Zero();       ///< point of A [m]
    Vec3 q = Vec3::Zero();       ///< point of B [m]; for a plane the foot of p
    Vec3 normal = Vec3::Zero();  ///< unit length, out of B; zero where the face or the edges have no normal
    double depth = 0;            ///< normal . (p - q) [m], negative inside
};

/// Points, normal and depth of a contact at tau in [0, 1], from vertices
/// that move linearly between the ends of the step.
///
/// After a step has been committed both ends are the new state, so any tau reads that state. The solvers
/// integrate over tau by closed forms of their own; this is for probes, pictures and checks.
ContactGeometry contact_geometry(const World& world, const Contact& contact, double tau);

/// A contact over the step as a normal law sees it, from its bodies' positions.
PairStep pair_step(const World& world, const Contact& contact);

/// Stiffness of a pair [N/m]: its plane's own where it has one, else that of all pairs.
double pair_stiffness(const World& world, const Contact& contact, double of_all_pairs);

/// Coefficients of a pair: those between its two materials where the scene has materials, else those of all
/// pairs.
const FrictionCoefficients& pair_friction(const World& world, const Contact& contact,
                                          const FrictionCoefficients& of_all_pairs);

/// The coefficient of restitution between a pair's two materials.
double pair_restitution(const World& world, const Contact& contact);

/// How the surface of A runs against that of B, on bodies that have a surface velocity [m/s].
Vec3 running_of_surfaces(const World& world, const Contact& contact);

/// The names of the two sides; B may be a plane.
const std::string& name_of_a(const World& world, const Contact& contact);
const std::string& name_of_b(const World& world, const Contact& contact);

/// The body that the contact's i-th vertex (0..3) belongs to, by its place in World::bodies.
inline std::size_t body_index(const Contact& contact, int i)
{
    return static_cast<std::size_t>(i < contact.vertices_of_a() ? contact.body_a : contact.body_b);
}
inline Body& body_of_vertex(const World& world, const Contact& contact, int i)
{
    return *world.bodies[body_index(contact, i)];
}

/// World position of the contact's i-th vertex (0..3) at tau [m].
Vec3 contact_vertex(const World& world, const Contact& contact, int i, double tau);

}  // namespace enduring
