#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/step.hpp"

namespace enduring {

/// A pair's normal where its force acts; zero where its features have none.
Vec3 normal_of(const PairStep& step, double tau);

/// Sets a row to where the bodies move now: normal, depth, velocity, and what acts.
void update_row(const World& world, const Contact& contact, const StepLaw& step, PairRow& row);

}  // namespace enduring
