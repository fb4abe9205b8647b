#include "chapters/02_collision_detection/impact_weights.hpp"
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/tests/step_generators.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::generated;

namespace {

/// Distance of the two weighted points, in parts of the largest coordinate difference of the query.
double relative_gap(const Points& p, double tau, const std::array<double, 4>& weights)
{
    Vec3 gap = Vec3::Zero();
    double size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        gap += weights[i] * at_time(p[i] - p[0], p[i + 4] - p[4], tau);
        for (std::size_t k = 0; k < 8; ++k)
            size = std::max(size, (p[k] - p[i]).norm());
    }
    return size > 0 ? gap.norm() / size : 0;
}

}  // namespace

TEST_CASE("impact weights: at the time of impact the vertex is where its weights say, in every category")
{
    Random random(31);
    for (const Category& category : categories())
        for (int i = 0; i < 200; ++i) {
            const Points points = category.make(random, false);
            const auto step = step_of<VertexFaceStep>(points);
            const auto time = time_of_impact(step);
            if (!time)
                continue;
            CAPTURE(category.name);
            CAPTURE(i);
            const std::array<double, 3> w = impact_weights(step, *time);
            for (const double weight : w)
                CHECK((weight >= 0 && weight <= 1));
            CHECK(w[0] + w[1] + w[2] == doctest::Approx(1).epsilon(1e-12));
            CHECK(relative_gap(points, *time, {1, -w[0], -w[1], -w[2]}) <= 1e-9);
        }
}

TEST_CASE("impact weights: at the time of impact the edges meet where their weights say, in every category")
{
    Random random(32);
    for (const Category& category : categories())
        for (int i = 0; i < 200; ++i) {
            const Points points = category.make(random, true);
            const auto step = step_of<EdgeEdgeStep>(points);
            const auto time = time_of_impact(step);
            if (!time)
                continue;
            CAPTURE(category.name);
            CAPTURE(i);
            const auto [s, t] = impact_weights(step, *time);
            CHECK((s >= 0 && s <= 1 && t >= 0 && t <= 1));
            CHECK(relative_gap(points, *time, {1 - s, s, t - 1, -t}) <= 1e-9);
        }
}

TEST_CASE("impact weights: a point inside the face has its barycentric coordinates")
{
    const Vec3 f0(0, 0, 0), f1(4, 0, 0), f2(0, 4, 0), v = 0.5 * f0 + 0.25 * f1 + 0.25 * f2;
    const std::array<double, 3> w = impact_weights(VertexFaceStep{v, f0, f1, f2, v, f0, f1, f2}, 0.5);
    CHECK(w[0] == doctest::Approx(0.5));
    CHECK(w[1] == doctest::Approx(0.25));
    CHECK(w[2] == doctest::Approx(0.25));
}
