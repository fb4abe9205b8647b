#include "common/experiments/run/run.hpp"

#include <cmath>

namespace enduring {

// Apart from run(), whose thread of progress a browser does not have: exercises in the page count steps, too.
int step_count(const Scene& scene)
{
    const double steps = scene.duration / scene.dt;
    const double whole = std::round(steps);
    return static_cast<int>(std::abs(steps - whole) < 1e-6 * steps ? whole : std::ceil(steps));
}

}  // namespace enduring
