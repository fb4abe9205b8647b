#include "chapters/04_friction/friction_law.hpp"
#include "chapters/04_friction/tangent_plane.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE(
    "errata: friction along f_n, as (5.21) prints it, brakes nothing, while (5.23) acts against the slip")
{
    const YamaneNakamura friction{.mu_s = 0.4, .mu_d = 0.1};
    const double normal_impulse = 2, dt = 0.01;
    for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0.6, 0.8, 0), Vec3(-2, 1, 2).normalized().eval()}) {
        const TangentPlane plane(normal);
        for (const Vec2& velocity : {Vec2(3, 0), Vec2(-1, 2), Vec2(0, -500)}) {
            CAPTURE(normal.transpose());
            CAPTURE(velocity.transpose());
            const Vec3 slip = plane.in_space(velocity);
            const Vec3 as_printed = friction.mu_d * normal_impulse * normal;
            // no work: a sliding block would never stop
            CHECK(std::abs(as_printed.dot(slip)) < 1e-12 * slip.norm());

            const Vec2 stretch = Vec2(1, 1) * 1e3;  // far beyond what mu_s holds
            const Vec3 against_slip =
                plane.in_space(yamane_nakamura({stretch, velocity, normal_impulse}, friction, dt).impulse);
            CHECK((against_slip + friction.mu_d * normal_impulse * slip.normalized()).norm() < 1e-12);
        }
    }
}
