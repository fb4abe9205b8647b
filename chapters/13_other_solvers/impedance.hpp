#pragma once

#include "chapters/13_other_solvers/convex_relaxation.hpp"

namespace enduring {

//! [impedance]
/// MuJoCo's impedance d of a contact at a depth [1]: from `least` to `most` over `width`, along two
/// parabolas.
double impedance(const ImpedanceSettings& settings, double depth);

/// Softness and free velocity of a contact as MuJoCo has them, for the same convex problem.
///
/// A contact asks for the acceleration a^ = -b u - k s: u and s are its velocity and separation when the step
/// begins, b = 2 / (d_max T) and k = d / (d_max T zeta)^2. Over a step this is the free velocity u + dt a^.
/// R is (1 - d) / d times the response, for which MuJoCo takes 1/m of both bodies, without their turning. By
/// default its cone is a pyramid of four edges n + mu t and n - mu t. R of each is 2 mu^2 times that of the
/// normal; together they are a cone with R_n = mu^2 R / 2 and R_t = R.
/// @param separation    when the step begins [m]; a contact that is open gets no force
/// @param velocity      then, before gravity, in the frame of the contact [m/s]
/// @param inverse_mass  of both bodies together [1/kg]
/// @see Todorov 2014; MuJoCo's documentation, "Computation", and engine_core_constraint.c
RegularisedContact impedance_contact(const ImpedanceSettings& settings, double separation,
                                     const Vec3& velocity, double inverse_mass, double mu, double dt);
//! [impedance]

}  // namespace enduring
