#pragma once

#include "common/fem/material.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/deformable_body.hpp"

namespace enduring::chapter13 {

/// A soft cube of 1 m and 10 kg, of 1000 Pa: it is pressed together by 5 % under its weight.
struct SoftCube {
    int cells = 2;                  ///< along each edge
    Vec3 centre = Vec3(0, 0.5, 0);  ///< [m]
    double poisson = 0;             ///< with 0, a column under its weight has a formula
    Vec3 velocity = Vec3::Zero();   ///< [m/s]
    ElasticLaw law = ElasticLaw::corotated;
};
inline constexpr double soft_young = 1000, soft_density = 10;  ///< [Pa], [kg/m^3]

/// Behind the bodies of a scene.
void append_soft_cube(Scene& scene, const SoftCube& cube, const std::string& name = "soft");
/// It alone on the ground, or on a slope.
Scene soft_cube_scene(const SoftCube& cube, double slope_deg = 0, double mu = 0.5, double dt = 0.01);

/// A bar of 1 x 0.25 x 0.25 m that is clamped at its end x = -0.5, in the air.
/// @param mass_damping  of its material [1/s]; those of the methods have none
Scene clamped_bar(double dt = 0.01, double mass_damping = 0);

const DeformableBody& soft_body(const Scene& scene, std::size_t index = 0);
/// The mean place of the nodes that lie farthest along an axis at rest, in its direction or against it [m].
Vec3 mean_of_side(const DeformableBody& body, int axis, double direction);
/// The mean height of the cube's top, and of the bar's free end [m].
inline double height_of_top(const DeformableBody& body) { return mean_of_side(body, 1, 1).y(); }
inline double height_of_tip(const DeformableBody& body) { return mean_of_side(body, 0, 1).y(); }
/// By how much a column of the cube's material is lower under its own weight [m]: rho g H^2 / (2 E).
double column_sinks();
/// The mean of something over so many steps of a run, from now on.
double mean_over(Scene& scene, Contacts& contacts, const Solver& solver, int steps,
                 const std::function<double()>& value);

}  // namespace enduring::chapter13
