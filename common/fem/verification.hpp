#pragma once

#include "common/fem/elastic_body.hpp"
#include "common/geometry/vector.hpp"
#include "common/report/report.hpp"

#include <functional>
#include <vector>

/// Experiments that hold the elastic bodies against what is known otherwise. The tests assert their outcome, and the book
/// shows the same tables.
namespace enduring::verification {

/// Moments of inertia about the centre, of a mass matrix with its nodes at these places [kg m^2].
Mat3 inertia(const Eigen::SparseMatrix<double>& masses, const NodalVectors& positions);

/// Shares of an element's mass at a corner and at an edge node, by three ways of lumping the ten-node element.
/// Columns lumping, corner, edge.
Table ways_of_lumping();

/// Static tip deflection of a clamped bar against beam theory with shear (Timoshenko; Cowper's coefficient).
/// Columns basis, cells_along, unknowns, deflection_m, theory_m, ratio.
Table cantilever();

/// First bending frequency of a slender clamped bar against Euler and Bernoulli; lumped_ratio is that of the same body with the
/// row sums of its mass matrix at the nodes.
/// Columns basis, cells_along, unknowns, frequency_hz, theory_hz, ratio, lumped_ratio.
Table bending_frequency();

/// First torsional frequency of a square clamped bar against Saint-Venant's torsion.
/// Columns basis, cells_across, unknowns, frequency_hz, theory_hz, ratio, lumped_ratio.
Table torsion_frequency();

/// Moments of inertia over the integral over the volume: of the mass matrix, and of its row sums as point masses at the nodes, about
/// the axes of bars of the scenes, of finer ones, and of the bunny.
/// Columns shape, basis, lumped_x, lumped_y, lumped_z, consistent (the one that differs most from 1).
Table inertia_ratios();

/// The first of these for the bar of 3 x 0.4 x 0.4 m over the cells across it: rows cells_across, linear, quadratic, consistent.
Table inertia_over_cells();

/// Errors against a manufactured displacement of the unit cube, and the orders at which they vanish.
/// Columns basis, cells, l2_error, gradient_error, l2_order, gradient_order (0 in the first row of a basis).
Table convergence_in_space();

/// Error after half a period of the bar's first mode against cos(omega t).
/// Columns steps_per_period, error, order.
Table convergence_in_time();

/// A free bar that starts as a rigid body spinning about its middle axis.
struct SpinningBar {
    bool freeze_rotations = false;
    double young = 1e6;       ///< [Pa]
    double omega_dt = 0.05;   ///< angle of one step [rad]
    double dt = 0.01;         ///< [s]
    int steps = 200;
};
struct SpinGrowth {
    double first_step = 0;           ///< relative growth of the energy in the first step
    double first_step_formula = 0;   ///< and what the stretch of a linearised rotation explains
    double largest = 0;              ///< of the energy over its start, over all steps
    double final_energy = 0;         ///< relative to the start
    double linear_momentum = 0;      ///< largest change, relative to mass times tip speed
    double angular_momentum = 0;     ///< final change, relative
};
SpinGrowth spin(const SpinningBar& bar);

/// The above over stiffnesses and angles.
/// Columns young_pa, omega_dt, first_step_percent, formula_percent, largest_percent, final_percent, angular_percent.
Table spinning_bar_growth();

/// Displacements in equilibrium with the forces [N], rotations frozen: one step of implicit Euler so long that inertia
/// plays no part.
NodalVectors static_displacement(ElasticBody& body, const NodalVectors& forces);

/// Weights of the nodes on a plane face of a body, w_i = int phi_i dA: a traction t [Pa] is the nodal forces w_i t.
Eigen::VectorXd face_weights(const ElasticMesh& mesh, const std::function<bool(const Vec3&)>& on_face);

}  // namespace enduring::verification
