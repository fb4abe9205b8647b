#include "chapters/05_categorisation/experiments/corner.hpp"
#include "live/figures.hpp"

#include <cmath>
#include <numbers>

namespace enduring::live {

Numbers circle(double opening_deg)
{
    const chapter05::Corner wedge = chapter05::wedge_corner("wedge", opening_deg * std::numbers::pi / 180);
    Numbers result;
    for (int lean = -180; lean < 180; ++lean) {
        const double angle = lean * std::numbers::pi / 180;
        const Vec3 normal(-std::sin(angle), std::cos(angle), 0);
        result.push_back(can_touch(wedge, normal) + 2 * average_says_regular(wedge, normal) +
                         4 * span_says_regular(wedge, normal));
    }
    return result;
}

}  // namespace enduring::live
