#pragma once

#include "chapters/13_other_solvers/method_solver.hpp"

namespace enduring {

//! [regularised]
/// A contact of the relaxed law, regularised: R along the normal and along the surface, and the velocity v^
/// at which nothing pushes.
struct RegularisedContact {
    double r_normal = 0, r_tangent = 0;  ///< velocity per impulse [1/kg]
    double free_speed = 0;               ///< v^_n [m/s]
    double mu = 0;
    Eigen::Vector2d free_slip = Eigen::Vector2d::Zero();  ///< the same along the surface [m/s]
};

/// Impulse, potential and minus the derivative of the impulse; all in the frame of the contact, the normal
/// first.
struct RelaxedAnswer {
    Vec3 impulse = Vec3::Zero();  ///< gamma [N s]
    double potential = 0;         ///< 1/2 gamma R gamma [J]
    Mat3 hessian = Mat3::Zero();  ///< [kg]
};
/// gamma(v) is the point of the cone of friction that is nearest to y = -R^-1 (v - v^), measured by R: inside
/// it holds, on its side it slides, at its tip the contact is open.
/// @see Castro et al. 2022, "An unconstrained convex formulation of compliant contact", (20) to (22) and
///     appendix on analytical inverse dynamics
RelaxedAnswer relaxed_answer(const RegularisedContact& contact, const Vec3& velocity);
//! [regularised]

/// What a step of Newton's method has left.
struct RelaxedRecord {
    int newton_steps = 0;
    double gradient = 0;  ///< of the momentum of the step [1]
};

/// The convex relaxation: the velocities at the end of the step minimise kinetic energy of the change plus
/// the potentials of all contacts.
/// @param step  changed in place
RelaxedRecord convex_relaxation(MethodStep& step, const RelaxedSettings& settings);

Solver chapter13_relaxation_solver(const ContactParameters& parameters, const RelaxedSettings& settings = {});

}  // namespace enduring
