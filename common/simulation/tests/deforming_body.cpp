#include "common/simulation/deforming_body.hpp"

#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>

using namespace enduring;

namespace {

/// A box at three uneven times: as it is, twice as high, and shifted.
std::vector<DeformingBody::Shape> shapes()
{
    const std::vector<Vec3> first = box({1, 1, 1}).vertices;
    std::vector<Vec3> high = first, shifted = first;
    for (Vec3& x : high)
        x.y() *= 2;
    for (Vec3& x : shifted)
        x += Vec3(0.3, 0, -1);
    return {{0.5, first}, {1, high}, {1.75, shifted}};
}

DeformingBody body(double time)
{
    const SurfaceMesh mesh = box({1, 1, 1});
    return {"hand", topology_of(mesh), shapes(), time};
}

}  // namespace

TEST_CASE("deforming body: it has each shape at its time, and rests before the first and after the last one")
{
    for (const auto& [time, vertices] : shapes())
        for (std::size_t v = 0; v < vertices.size(); ++v)
            CHECK((body(time).positions_t0()[v] - vertices[v]).norm() <= 1e-14);
    for (const double outside : {-3.0, 0.2, 2.0}) {
        const DeformingBody still = body(outside);
        const std::vector<Vec3> expected = outside < 1 ? shapes().front().vertices : shapes().back().vertices;
        for (std::size_t v = 0; v < expected.size(); ++v)
            CHECK((still.positions_t0()[v] - expected[v]).norm() <= 1e-14);
        CHECK(still.velocity(3).norm() == 0);
    }
}

TEST_CASE("deforming body: a velocity is the slope of its vertex' path, continuous at the shapes")
{
    constexpr double step = 1e-6;
    for (double time = 0.4; time < 1.9; time += 0.05)
        for (const std::size_t v : {0, 3, 5}) {
            const Vec3 slope = (body(time + step).positions_t0()[v] - body(time - step).positions_t0()[v]) /
                               (2 * step);
            CAPTURE(time);
            CHECK((body(time).velocity(static_cast<int>(v)) - slope).norm() <= 1e-4);
        }
}

TEST_CASE("deforming body: between two shapes no coordinate leaves what lies between their values")
{
    for (double time = 0.5; time < 1.75; time += 0.01) {
        const auto now = shapes();
        const auto next = std::find_if(now.begin(), now.end(),
                                       [&](const auto& shape) { return shape.time > time; });
        const DeformingBody between = body(time);
        for (std::size_t v = 0; v < next->vertices.size(); ++v)
            for (int axis = 0; axis < 3; ++axis) {
                const auto [low, high] = std::minmax((next - 1)->vertices[v][axis], next->vertices[v][axis]);
                CHECK(between.positions_t0()[v][axis] >= low - 1e-14);
                CHECK(between.positions_t0()[v][axis] <= high + 1e-14);
            }
    }
}

TEST_CASE("deforming body: a step leads from where it is to where its time leads, whatever pushes it")
{
    DeformingBody moving = body(0.6);
    moving.predict(Vec3(0, -9.81, 0), 0.1);
    moving.apply_impulse(0, Vec3(0, -1e6, 0));
    moving.update_prediction(0.1);
    for (std::size_t v = 0; v < 8; ++v)
        CHECK((moving.positions_t1()[v] - body(0.7).positions_t0()[v]).norm() <= 1e-14);
    moving.commit(0.1);
    CHECK(moving.time() == doctest::Approx(0.7));
    CHECK((moving.positions_t0()[2] - body(0.7).positions_t0()[2]).norm() <= 1e-14);
    CHECK(moving.is_static());
    CHECK(moving.is_driven());
}

TEST_CASE("deforming body: one shape, times that do not ascend and missing vertices are refused")
{
    const SurfaceMesh mesh = box({1, 1, 1});
    const auto make = [&](std::vector<DeformingBody::Shape> of) {
        return DeformingBody("hand", topology_of(mesh), std::move(of));
    };
    auto late = shapes(), few = shapes();
    late[2].time = 1;
    few[1].vertices.pop_back();
    CHECK_THROWS_AS(make({shapes().front()}), std::invalid_argument);
    CHECK_THROWS_AS(make(late), std::invalid_argument);
    CHECK_THROWS_AS(make(few), std::invalid_argument);
    CHECK_NOTHROW(make(shapes()));
}
