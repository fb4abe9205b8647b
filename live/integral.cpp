#include "chapters/03_penalty_impulses/penetration.hpp"
#include "live/figures.hpp"

#include <algorithm>

namespace enduring::live {

Numbers integral(double d0, double d1, double d2, double d3)
{
    const Bernstein<double, 3> depth{{d0, d1, d2, d3}};
    Numbers result{0, std::max(0.0, -d3)};
    for (const Interval& inside : penetration_intervals(depth)) {
        const auto [e0, e1, e2, e3] = restricted(depth, inside).coefficients;
        result[0] -= inside.length() * (e0 + e1 + e2 + e3) / 4;
        result.insert(result.end(), {inside.from, inside.to});
    }
    return result;
}

}  // namespace enduring::live
