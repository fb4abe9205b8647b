#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/tests/step_generators.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace enduring;
using namespace enduring::generated;

namespace {

/// A vertex that falls from height 1 to -1 on a right-angled face with legs of length 2 in the plane z = 0.
VertexFaceStep falling(double x, double y)
{
    const Vec3 f0(0, 0, 0), f1(2, 0, 0), f2(0, 2, 0);
    return {{x, y, 1}, f0, f1, f2, {x, y, -1}, f0, f1, f2};
}

/// An edge along x that falls from height 1 to -1 on an edge along y
/// of length 2, beside its middle by `along`.
EdgeEdgeStep falling_edge(double along)
{
    return {{-1, along, 1},  {1, along, 1},  {0, -1, 0}, {0, 1, 0},
            {-1, along, -1}, {1, along, -1}, {0, -1, 0}, {0, 1, 0}};
}

/// A height of (tau - 1/2)^2 - depth over a face that tilts while the vertex runs against it.
VertexFaceStep tangent(double depth)
{
    const auto face = [](double x, double y, double tilt) { return Vec3(x, y, tilt * x); };
    return {{0.5, 0, -depth},  face(-2, -2, -0.5), face(2, -2, -0.5), face(0, 2, -0.5),
            {-0.5, 0, -depth}, face(-2, -2, 0.5),  face(2, -2, 0.5),  face(0, 2, 0.5)};
}

/// Equal up to the slack of one answer, or both empty.
bool same(const std::optional<double>& a, const std::optional<double>& b)
{
    return a.has_value() == b.has_value() && (!a || std::abs(*a - *b) <= 1.01 * time_of_impact_slack);
}

template <class Step, class Change>
void require_same_answers(bool edges, const Change& change)
{
    Random random(7);
    for (const Category& category : categories())
        for (int i = 0; i < 60; ++i) {
            const Points points = category.make(random, edges);
            CAPTURE(category.name);
            CAPTURE(i);
            CHECK(same(time_of_impact(step_of<Step>(points)), time_of_impact(step_of<Step>(change(points)))));
        }
}

Points permuted(const Points& p, const std::array<std::size_t, 4>& order)
{
    Points result;
    for (std::size_t i = 0; i < 4; ++i) {
        result[i] = p[order[i]];
        result[i + 4] = p[order[i] + 4];
    }
    return result;
}

Points reversed(const Points& p) { return {p[4], p[5], p[6], p[7], p[0], p[1], p[2], p[3]}; }

}  // namespace

TEST_CASE(
    "certified query: a vertex beside an edge of the face by eps misses it, and within by eps hits it, down to 2^-52")
{
    for (int k = 2; k <= 52; ++k) {
        const double eps = std::ldexp(1.0, -k);
        CAPTURE(k);
        CHECK_FALSE(time_of_impact(falling(-eps, 0.5)));
        CHECK_FALSE(time_of_impact(falling(0.5, -eps)));
        CHECK_FALSE(time_of_impact(falling(1 + eps, 1)));
        CHECK(same(time_of_impact(falling(eps, 0.5)), 0.5));
        CHECK(same(time_of_impact(falling(0.5, eps)), 0.5));
        CHECK(same(time_of_impact(falling(1 - eps, 1)), 0.5));
    }
    CHECK(same(time_of_impact(falling(0, 0.5)), 0.5));
    CHECK(same(time_of_impact(falling(0, 0)), 0.5));
    CHECK(same(time_of_impact(falling(2, 0)), 0.5));
}

TEST_CASE(
    "certified query: an edge that passes the other's end by eps misses it, and within by eps hits it, down to 2^-52")
{
    for (int k = 1; k <= 52; ++k) {
        const double eps = std::ldexp(1.0, -k);
        CAPTURE(k);
        CHECK_FALSE(time_of_impact(falling_edge(1 + eps)));
        CHECK_FALSE(time_of_impact(falling_edge(-1 - eps)));
        CHECK(same(time_of_impact(falling_edge(1 - eps)), 0.5));
    }
    CHECK(same(time_of_impact(falling_edge(1)), 0.5));
}

TEST_CASE(
    "certified query: a tangent height touches at its double root, dips at its first root, and turns back unseen")
{
    for (int k = 4; k <= 60; ++k) {
        const double depth = std::ldexp(1.0, -k);
        CAPTURE(k);
        CHECK(same(time_of_impact(tangent(depth)), 0.5 - std::sqrt(depth)));
        CHECK_FALSE(time_of_impact(tangent(-depth)));
    }
    CHECK(same(time_of_impact(tangent(0)), 0.5));
}

TEST_CASE(
    "certified query: what slides into a face in its plane touches it at its edge, and above it by 2^-60 does not")
{
    const auto sliding = [](double above, double turned) {
        VertexFaceStep step = falling(0, 0);
        step.v_t0 = Vec3(-1, 0.5, above);
        step.v_t1 = Vec3(1, 0.5, above);
        // planes that no axis lies in; shears by powers of two keep every digit
        for (Vec3* x : {&step.v_t0, &step.f0_t0, &step.f1_t0, &step.f2_t0, &step.v_t1, &step.f0_t1,
                        &step.f1_t1, &step.f2_t1})
            x->z() += turned * (x->x() + 2 * x->y());
        return step;
    };
    for (const double turned : {0.0, 0.25}) {
        CAPTURE(turned);
        CHECK(same(time_of_impact(sliding(0, turned)), 0.5));
        CHECK(same(time_of_impact(sliding(0, turned), 0.75), 0.75));
    }
    CHECK_FALSE(time_of_impact(sliding(0x1p-60, 0)));
    CHECK_FALSE(time_of_impact(sliding(-0x1p-60, 0)));
}

TEST_CASE("certified query: the ends of the step belong to it, and nothing beyond them does")
{
    VertexFaceStep step = falling(0.5, 0.5);
    step.v_t1.z() = 0;
    CHECK(same(time_of_impact(step), 1.0));
    step.v_t1.z() = 0x1p-52;
    CHECK_FALSE(time_of_impact(step));
    step.v_t0.z() = 0;
    step.v_t1.z() = 1;
    CHECK(time_of_impact(step) == 0.0);
    step.v_t0.z() = 0x1p-60;
    CHECK_FALSE(time_of_impact(step));
}

TEST_CASE("certified query: the order of the face's corners does not matter")
{
    require_same_answers<VertexFaceStep>(false, [](const Points& p) { return permuted(p, {0, 2, 3, 1}); });
    require_same_answers<VertexFaceStep>(false, [](const Points& p) { return permuted(p, {0, 2, 1, 3}); });
}

TEST_CASE("certified query: neither the order of the edges nor their direction matters")
{
    require_same_answers<EdgeEdgeStep>(true, [](const Points& p) { return permuted(p, {2, 3, 0, 1}); });
    require_same_answers<EdgeEdgeStep>(true, [](const Points& p) { return permuted(p, {1, 0, 2, 3}); });
    require_same_answers<EdgeEdgeStep>(true, [](const Points& p) { return permuted(p, {0, 1, 3, 2}); });
}

TEST_CASE("certified query: a step played backwards touches if and only if it does forwards")
{
    Random random(8);
    for (const Category& category : categories())
        for (int i = 0; i < 60; ++i) {
            CAPTURE(category.name);
            CAPTURE(i);
            const Points face = category.make(random, false), edge = category.make(random, true);
            CHECK(time_of_impact(step_of<VertexFaceStep>(face)).has_value() ==
                  time_of_impact(step_of<VertexFaceStep>(reversed(face))).has_value());
            CHECK(time_of_impact(step_of<EdgeEdgeStep>(edge)).has_value() ==
                  time_of_impact(step_of<EdgeEdgeStep>(reversed(edge))).has_value());
        }
}

TEST_CASE("certified query: a size that is a power of two, from 2^-900 to 2^900, changes no answer")
{
    Random random(9);
    for (const Category& category : categories())
        for (const int power : {-900, -300, -1, 100, 400, 900}) {
            CAPTURE(category.name);
            CAPTURE(power);
            const Points points = category.make(random, true);
            Points scaled = points;
            for (Vec3& x : scaled)
                x = x.unaryExpr([power](double c) { return std::ldexp(c, power); });
            CHECK(time_of_impact(step_of<EdgeEdgeStep>(scaled)) ==
                  time_of_impact(step_of<EdgeEdgeStep>(points)));
        }
}

TEST_CASE("certified query: moving a lattice of 2^-20 to 2^30 changes no answer")
{
    Random random(10);
    for (int i = 0; i < 500; ++i) {
        Points near = categories()[2].make(random, false), far = near;
        for (std::size_t k = 0; k < 8; ++k) {
            near[k] *= 0x1p-20;
            far[k] = near[k] + Vec3(0x1p30, -0x1p30, 0x1p29);
        }
        CAPTURE(i);
        CHECK(time_of_impact(step_of<VertexFaceStep>(near)) == time_of_impact(step_of<VertexFaceStep>(far)));
    }
}

TEST_CASE("certified query: after a crossing outwards the search goes on to the next one inwards")
{
    // The height (tau - 1/2)^2 - 1/16 vanishes at 1/4 and at 3/4.
    const VertexFaceStep step = tangent(0.0625);
    CHECK(same(time_of_impact(step), 0.25));
    CHECK(same(time_of_impact(step, 0.25 + 2 * time_of_impact_slack), 0.75));
    CHECK(same(time_of_impact(step, 0.5), 0.75));
    CHECK_FALSE(time_of_impact(step, 0.75 + 2 * time_of_impact_slack));
    CHECK(same(time_of_impact(step, 0.0), time_of_impact(step)));
}

TEST_CASE("certified query: what is not a number is refused")
{
    VertexFaceStep step = falling(0.5, 0.5);
    step.v_t0.x() = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(time_of_impact(step), std::invalid_argument);
    step.v_t0.x() = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(time_of_impact(step), std::invalid_argument);
    CHECK_THROWS_AS(time_of_impact(falling(0.5, 0.5), -0.1), std::invalid_argument);
    CHECK_THROWS_AS(time_of_impact(falling_edge(0), 1.5), std::invalid_argument);
}
