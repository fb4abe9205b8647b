#include "exercises/03_penalty_impulses/4_depth_at_rest.hpp"

#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "exercises/not_implemented_yet.hpp"

#include <algorithm>

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
