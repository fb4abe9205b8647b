#include "chapters/03_penalty_impulses/penalty_law.hpp"

#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"

#include <array>

namespace enduring {

//! [laws]
Vec3 discrete_penalty(const PairStep& step, double start, double k, double dt)
{
    return step.plane_normal ? discrete_on_plane(step, start, k, dt) : discrete_impulse(step.t1, k, dt);
}

Vec3 continuous_penalty(const PairStep& step, double start, double k, double dt)
{
    return step.plane_normal ? continuous_on_plane(step, start, k, dt)
                             : continuous_impulse(step, start, k, dt);
}
//! [laws]

//! [normal_law]
NormalLaw normal_law(const ContactParameters& parameters)
{
    if (parameters.law)
        return parameters.law;
    constexpr std::array laws{discrete_penalty, continuous_penalty};  // as PenaltyMethod has them
    static_assert(laws.size() == penalty_words.size(), "a method without a law");
    return laws[static_cast<std::size_t>(parameters.method)];
}
//! [normal_law]

}  // namespace enduring
