#pragma once

#include "common/simulation/contact_parameters.hpp"

namespace enduring {

/// The two penalty laws, for pairs of every kind. Against a plane they are chapter 1's: where the normal
/// stands still the depth is linear, and its integral elementary.
Vec3 discrete_penalty(const PairStep& step, double start, double k, double dt);
Vec3 continuous_penalty(const PairStep& step, double start, double k, double dt);

/// The law that a scene asks for.
NormalLaw normal_law(const ContactParameters& parameters);

}  // namespace enduring
