#include "common/geometry/quadratic.hpp"
#include "common/geometry/shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

#include <memory>

using namespace enduring;

namespace {

std::unique_ptr<DeformableBody> soft_bar(ImpulseResponse response, bool quadratic)
{
    DeformableSettings settings;
    settings.material.density = 100;
    settings.material.young = 5e4;
    settings.material.poisson = 0.3;
    settings.impulse_response = response;
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
    if (quadratic)
        return std::make_unique<DeformableBody>("bar", with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>("bar", mesh, settings);
}

/// Velocity that an impulse at vertex 0 gives that vertex within one step.
Vec3 answer(ImpulseResponse response, bool quadratic, double dt)
{
    const auto body = soft_bar(response, quadratic);
    body->predict(Vec3::Zero(), dt);
    body->apply_impulse(0, {0, 1, 0});
    body->update_prediction(dt);
    return body->velocity(0);
}

}  // namespace

TEST_CASE("impulse response: the implicit one gives the impulse's momentum, once, and moves nothing before the update")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(ImpulseResponse::implicit, quadratic);
        const double dt = 0.01;
        body->predict(Vec3::Zero(), dt);
        body->apply_impulse(0, {0.5, -1, 2});
        body->apply_impulse(3, {1, 0, 0});
        CHECK(body->linear_momentum().norm() < 1e-12);
        for (int update = 0; update < 2; ++update) {
            body->update_prediction(dt);
            CHECK((body->linear_momentum() - Vec3(1.5, -1, 2)).norm() < 1e-9);
        }
    }
}

TEST_CASE("impulse response: the implicit one tends to the lumped one as the step shrinks, and is the smaller")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const Vec3 lumped = answer(ImpulseResponse::lumped, quadratic, 1e-6);
        CHECK((answer(ImpulseResponse::implicit, quadratic, 1e-6) - lumped).norm() < 1e-5 * lumped.norm());
        CHECK(answer(ImpulseResponse::implicit, quadratic, 0.01).y() < 0.7 * lumped.y());
    }
}

TEST_CASE("impulse response: an impulse that nobody updates for is not lost at the end of the step")
{
    const auto body = soft_bar(ImpulseResponse::implicit, false);
    body->predict(Vec3::Zero(), 0.01);
    body->apply_impulse(0, {0, 1, 0});
    body->commit(0.01);
    CHECK((body->linear_momentum() - Vec3(0, 1, 0)).norm() < 1e-9);
}
