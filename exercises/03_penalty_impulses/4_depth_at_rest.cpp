#include "4_depth_at_rest.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "common/simulation/run.hpp"
#include "penalty_contact.hpp"

#include <algorithm>
#include "exercises/not_implemented_yet.hpp"

namespace enduring {

double predicted_factor()
{
    not_implemented_yet("3.4");
}

double depth_at_rest(const RestingCube& cube)
{
    not_implemented_yet("3.4");
}

double measured_factor(RestingCube cube, int other_cells)
{
    not_implemented_yet("3.4");
}

double law_of_depth(const RestingCube& cube)
{
    not_implemented_yet("3.4");
}

}  // namespace enduring
