#include "chapters/07_implicit_contact/pair_law.hpp"

#include "chapters/07_implicit_contact/weighted_impulse.hpp"

namespace enduring {

//! [answer]
PairAnswer answer(const PairLaw& pair, const Vec3& velocity, const StepLaw& step)
{
    const Vec3& n = pair.normal;
    const double k = pair.stiffness, dt = step.dt;
    const auto [impulse, slope] = weighted_impulse(pair.depth_t0, pair.depth_t0 + dt * n.dot(velocity),
                                                   step.centre, k, dt);
    PairAnswer result{impulse * n, Vec3::Zero(), -dt * slope * n * n.transpose()};
    if (pair.friction_limit <= 0)
        return result;

    // A spring that gives: its end moves with p, its impulse never exceeds the limit.
    const Mat3 along = Mat3::Identity() - n * n.transpose();
    const Vec3 wanted = -k * dt * (along * (pair.stretch + dt * velocity));
    const double size = wanted.norm();
    result.slips = size > pair.friction_limit;
    if (!result.slips) {
        result.friction = wanted;
        result.stiffening += k * dt * dt * along;
    } else {
        const double share = pair.friction_limit / size;
        const Vec3 direction = wanted / size;
        result.friction = share * wanted;
        result.stiffening += share * k * dt * dt * (along - direction * direction.transpose());
    }
    return result;
}
//! [answer]

}  // namespace enduring
