#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"

namespace enduring {

/// A guess of each pair's friction, beside the one that its velocity makes, while its limit is lagged.
///
/// A pair that slips pushes with its limit, whichever way it slips: its direction turns the faster the slower
/// it slips, and Newton's method, which takes it for a straight line, passes the place where the pair would
/// hold. So friction becomes an unknown w of its own, with the equation
///   max(|s|, limit) w = limit s,    s the impulse of the spring if it never gave.
/// Its derivative is tame: how stiff a pair is along its slip follows from how far w is from the limit.
/// T. F. Chan, G. H. Golub, P. Mulet: A nonlinear primal-dual method for total variation-based image
/// restoration, SIAM Journal on Scientific Computing 20, 1999.
class DualFriction {
public:
    /// The guesses are the friction that acts, within the limits: at a solution they fit. The problem
    /// outlives it.
    explicit DualFriction(const ContactProblem& problem);

    /// Of each row that pushes so at its velocity: minus the derivative of its impulse, friction by the
    /// equation above.
    std::vector<Mat3> hessians(const std::vector<PairPush>& pushes,
                               const std::vector<Vec3>& velocities) const;
    /// Brings the guesses to where the equation's tangent has them behind a Newton step, within the limits.
    /// @param rates  of the pairs' velocities along the step
    void follow(const std::vector<Vec3>& velocities, const std::vector<Vec3>& rates);

private:
    const ContactProblem& problem_;
    std::vector<Vec3> guesses_;  ///< on p [N s]
};

}  // namespace enduring
