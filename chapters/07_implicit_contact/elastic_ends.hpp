#pragma once

#include "chapters/07_implicit_contact/islands.hpp"
#include "common/fem/elastic_body.hpp"

#include <vector>

namespace enduring {

class DeformableBody;

/// Refresh, before anything is looked for: brings the elastic forces of soft bodies to where the step ends without contact. What is
/// left makes the step shorter, as an unsolved one.
void settle_soft_bodies(World& world, double dt);

/// Those of an island that have settled in this step. A solver without that pass keeps the linear step.
std::vector<DeformableBody*> soft_bodies(World& world, const Island& island);

/// Brings the elastic forces of soft bodies nearer to where the step ends now.
/// @return  what was missing, of the body that missed most (DeformableBody::approach_end())
double approach_ends(const std::vector<DeformableBody*>& soft, double dt);

}  // namespace enduring
