#include "../category.hpp"

#include "../experiments/corner.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter05;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A unit vector at an angle from straight down, leaning towards +x.
Vec3 from_down(double angle_deg) { return {std::sin(angle_deg * degree), -std::cos(angle_deg * degree), 0}; }

bool vertex_hooks(const Corner& corner, const Vec3& normal) { return is_hooked_vertex(corner.surface(), 0, normal); }

}  // namespace

TEST_CASE("category: a vertex of a flat surface hooks beyond 45 degrees and not before, to a millionth of a degree")
{
    const Corner flat = fan({{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}}, Vec3(0, 1, 0));
    for (const double turn : {0.0, 17.0, 90.0, 123.0, 260.0})
        for (const double slip : {-1e-6, 1e-6}) {
            CAPTURE(turn);
            CAPTURE(slip);
            // The normal of the contact points out of B, against the surface that looks up.
            const Vec3 normal = Eigen::AngleAxisd(turn * degree, Vec3::UnitY()) * from_down(45 + slip);
            CHECK(vertex_hooks(flat, normal) == (slip > 0));
        }
    CHECK(vertex_hooks(flat, Vec3(0, 1, 0)));  // pushed along its own normal: it is inside out
}
