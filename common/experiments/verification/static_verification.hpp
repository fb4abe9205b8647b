#pragma once

#include "common/experiments/report/table.hpp"
#include "common/fem/elastic_body.hpp"

#include <functional>

namespace enduring::verification {

/// Static tip deflection of a clamped bar against beam theory with shear (Timoshenko; Cowper's coefficient).
/// Columns basis, cells_along, unknowns, deflection_m, theory_m, ratio.
Table cantilever();

/// How far the centre of mass of a clamped bar of 10 x 2 x 2 cells sags under its weight, against beam theory
/// with shear, over Poisson's ratio. Columns basis, split, poisson, sag_mm, theory_mm, ratio,
/// sideways_percent (of the sag).
Table locking();

/// Errors against a manufactured displacement of the unit cube, and the orders at which they vanish.
/// Columns basis, cells, l2_error, gradient_error, l2_order, gradient_order (0 in the first row of a basis).
Table convergence_in_space();

/// Displacements in equilibrium with the forces [N], rotations frozen: one step of
/// implicit Euler so long that inertia plays no part.
NodalVectors static_displacement(ElasticBody& body, const NodalVectors& forces);

/// Weights of the nodes on a plane face of a body, w_i = int phi_i dA: a
/// traction t [Pa] is the nodal forces w_i t.
Eigen::VectorXd face_weights(const ElasticMesh& mesh, const std::function<bool(const Vec3&)>& on_face);

}  // namespace enduring::verification
