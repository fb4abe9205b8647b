#include "common/simulation/static_body.hpp"
#include "common/simulation/tests/triangle_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE(
    "body: a vertex goes straight from one end of the step to the other, and the centre is that of the start")
{
    const auto body = triangle("sheet", 3, {0, 2, 0});
    body->predict(Vec3::Zero(), 0.5);
    CHECK((body->position(2, 0.25) - Vec3(1, 3.25, 0)).norm() < 1e-15);
    CHECK(body->position(2, 0) == body->positions_t0()[2]);
    CHECK(body->position(2, 1) == body->positions_t1()[2]);
    CHECK((body->centre() - Vec3(1 / 3.0, 3, 1 / 3.0)).norm() < 1e-15);
    CHECK((body->mean_velocity() - Vec3(0, 2, 0)).norm() < 1e-15);
}

TEST_CASE("body: what does not move has a mean velocity of zero, although it has no mass")
{
    const std::vector<Vec3> corners{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const StaticBody floor("floor", SurfaceTopology(3, {{0, 1, 2}}), corners);
    CHECK(floor.mass() == 0);
    CHECK(floor.mean_velocity() == Vec3::Zero());
}
