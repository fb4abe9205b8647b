#include "chapters/08_speculative_contacts/experiments/bouncing_scenes.hpp"
#include "chapters/08_speculative_contacts/experiments/experiments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace enduring::chapter08 {

void bouncing(const RunOptions& options, Report& report)
{
    (void)options;
    (void)report;
    for (const Floor floor : {Floor::plane, Floor::triangles, Floor::corner_of_triangles})
        for (const double dt : {0.01, 0.005, 0.002})
            for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const double kept = kept_height(e, floor, dt);
                std::printf("floor %d dt %g e %g kept %.5f formula %.5f rel %.4f\n", static_cast<int>(floor),
                            dt, e, kept, e * e, e > 0 ? kept / (e * e) - 1 : kept);
            }
    for (const double gap : {0.0, 1e-4, 1e-3, 1e-2})
        for (const double dt : {0.01, 0.005, 0.002})
            for (const double e : {0.0, 0.5, 1.0}) {
                const Cradle end = cradle(e, gap, dt);
                std::printf("cradle gap %g dt %g e %g:", gap, dt, e);
                for (const double v : end.velocities)
                    std::printf(" %.5f", v);
                std::printf("  kinetic %.5f\n", end.kinetic);
            }
    for (const double dt : {0.01, 0.005, 0.002})
        for (const double e : {0.0, 0.5, 0.9, 1.0}) {
            const EnergyOfRun cube = cube_on_corner(e, dt), soft = soft_cubes(e, dt);
            std::printf("dt %g e %g cube gained %.3g left %.4f  soft gained %.3g left %.4f\n", dt, e,
                        cube.most_gained, cube.left, soft.most_gained, soft.left);
        }
    for (const double mu : {0.0, 0.2, 0.8})
        for (const double e : {0.0, 0.5, 1.0}) {
            const ObliqueBounce one = oblique_bounce(e, mu, 0.01);
            std::printf("oblique mu %g e %g along %.5f up %.5f\n", mu, e, one.along, one.up);
        }
    for (const double e : {0.0, 0.5, 0.9})
        std::printf("stack e %g rests at %g\n", e, rest_of_stack(e, 0.01));
}

}  // namespace enduring::chapter08
