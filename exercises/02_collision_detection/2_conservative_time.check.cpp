#include "exercises/02_collision_detection/2_conservative_time.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

namespace enduring {
namespace {

VertexFaceStep over_a_face(const Vec3& from, const Vec3& to)
{
    const Vec3 f0(0, 0, 0), f1(1, 0, 0), f2(0, 0, 1);
    return {from, f0, f1, f2, to, f0, f1, f2};
}

/// By trying a fine grid of the triangle's points.
double distance_by_search(const Vec3& point, const Vec3& f0, const Vec3& f1, const Vec3& f2)
{
    double least = 1e300;
    for (int i = 0; i <= 300; ++i)
        for (int j = 0; i + j <= 300; ++j)
            least = std::min(least, (point - f0 - i / 300.0 * (f1 - f0) - j / 300.0 * (f2 - f0)).norm());
    return least;
}

double distance_at(const VertexFaceStep& s, double tau)
{
    return distance_by_search(at_time(s.v_t0, s.v_t1, tau), at_time(s.f0_t0, s.f0_t1, tau),
                              at_time(s.f1_t0, s.f1_t1, tau), at_time(s.f2_t0, s.f2_t1, tau));
}

std::vector<VertexFaceStep> random_steps(int count)
{
    RandomInputs random(5);
    const auto point = [&] { return random.point(-1, 1); };
    std::vector<VertexFaceStep> steps;
    for (int i = 0; i < count; ++i)
        steps.push_back({point(), point(), point(), point(), point(), point(), point(), point()});
    return steps;
}

}  // namespace

TEST_CASE("distance: above the face, beside a side, before a corner")
{
    const Vec3 f0(0, 0, 0), f1(1, 0, 0), f2(0, 0, 1);
    given("the face (0, 0, 0), (1, 0, 0), (0, 0, 1) m");
    expect("from (0.2, -0.3, 0.2)", distance_to_triangle({0.2, -0.3, 0.2}, f0, f1, f2), 0.3, 1e-12, "m");
    expect("from (0.5, 0.4, -0.3)", distance_to_triangle({0.5, 0.4, -0.3}, f0, f1, f2), 0.5, 1e-12, "m");
    expect("from (4, 0, -4)", distance_to_triangle({4, 0, -4}, f0, f1, f2), 5.0, 1e-12, "m");
    expect("from (1, 1, 1)", distance_to_triangle({1, 1, 1}, f0, f1, f2), std::sqrt(1.5), 1e-12, "m");
    expect("from (0, 3, 0) of a face that is a line",
           distance_to_triangle({0, 3, 0}, {1, 3, 0}, {2, 3, 0}, {4, 3, 0}), 1.0, 1e-12, "m");
}

TEST_CASE("distance: a face with equal corners is a segment or a point")
{
    const Vec3 a(0, 0, 0), b(2, 0, 0), point(1, 1, 0);
    given("from (1, 1, 0) m, corners (0, 0, 0) and (2, 0, 0) m, one of them twice");
    expect("distance, first and second equal", distance_to_triangle(point, a, a, b), 1.0, 1e-12, "m");
    expect("distance, second and third equal", distance_to_triangle(point, a, b, b), 1.0, 1e-12, "m");
    expect("distance, third and first equal", distance_to_triangle(point, a, b, a), 1.0, 1e-12, "m");
    given("from (1, 1, 0) m, all three corners (0, 0, 0) m");
    expect("distance", distance_to_triangle(point, a, a, a), std::sqrt(2), 1e-12, "m");
}

TEST_CASE("distance: it is that of the nearest of many points of the triangle")
{
    for (const VertexFaceStep& s : random_steps(60)) {
        given("the point ", readable(s.v_t0), " and the face ", readable(s.f0_t0), ", ", readable(s.f1_t0),
              ", ", readable(s.f2_t0));
        expect("distance", distance_to_triangle(s.v_t0, s.f0_t0, s.f1_t0, s.f2_t0),
               distance_by_search(s.v_t0, s.f0_t0, s.f1_t0, s.f2_t0), 5e-3, "m");
    }
}

TEST_CASE("approach: the vertex' way and the longest of the corners'")
{
    VertexFaceStep step = over_a_face({0, 1, 0}, {0, -1, 0});
    step.f1_t1 = step.f1_t0 + Vec3(0, 3, 4);
    step.f2_t1 = step.f2_t0 + Vec3(1, 0, 0);
    given("the vertex moves by 2 m, the corners by 0, 5 and 1 m");
    expect("fastest approach", fastest_approach(step), 7.0, 1e-12, "m per step");
}

TEST_CASE("approach: lengths of ways count, whichever corner goes farthest")
{
    for (const int longest : {0, 1, 2}) {
        VertexFaceStep step = over_a_face({0, 1, 0}, {2, 0, 2});
        Vec3* const ends[] = {&step.f0_t1, &step.f1_t1, &step.f2_t1};
        *ends[longest] += Vec3(2, -6, 3);
        *ends[(longest + 1) % 3] += Vec3(0, 1, 0);
        given("the vertex moves by (2, -1, 2) m, corner ", longest,
              " by (2, -6, 3) m, the next by (0, 1, 0) m");
        expect("fastest approach", fastest_approach(step), 3.0 + 7.0, 1e-12, "m per step");
    }
}

TEST_CASE("size: distances and times are the same from micrometres to kilometres")
{
    for (const double size : {1e-6, 1e-3, 1e3})
        for (const VertexFaceStep& s : random_steps(20)) {
            VertexFaceStep sized = s;
            for (Vec3* x : {&sized.v_t0, &sized.f0_t0, &sized.f1_t0, &sized.f2_t0, &sized.v_t1, &sized.f0_t1,
                            &sized.f1_t1, &sized.f2_t1})
                *x *= size;
            given("a random step in a cube of 2 m, and the same in one of ", 2 * size,
                  " m; gap a twentieth of a metre, or of the size");
            expect("distance over size",
                   distance_to_triangle(sized.v_t0, sized.f0_t0, sized.f1_t0, sized.f2_t0) / size,
                   distance_to_triangle(s.v_t0, s.f0_t0, s.f1_t0, s.f2_t0), 1e-9, "m");
            expect("time", conservative_time(sized, 0.05 * size, 0.001 * size).value_or(1),
                   conservative_time(s, 0.05, 0.001).value_or(1), 1e-9);
        }
}

TEST_CASE("time: a straight fall stops at the gap")
{
    given("a vertex from 1 m above a face to 1 m below, gap 0.1 m, to within 1e-6 m");
    const auto time = conservative_time(over_a_face({0.2, 1, 0.2}, {0.2, -1, 0.2}), 0.1, 1e-6);
    expect_that("there is a time", time.has_value());
    if (time) {
        expect("time", *time, 0.45, 1e-6);
        say("a vertex falls from 1 m to -1 m, gap 0.1 m: it stops at ", *time);
    }
    given("a vertex that stops 0.2 m above the face");
    expect_that("there is no time",
                !conservative_time(over_a_face({0.2, 1, 0.2}, {0.2, 0.2, 0.2}), 0.1, 1e-6).has_value());
    given("a vertex that begins 0.05 m above it");
    const auto begin = conservative_time(over_a_face({0.2, 0.05, 0.2}, {0.2, 1, 0.2}), 0.1, 1e-6);
    expect_that("the time is 0", begin.has_value() && *begin == 0);
    given("a vertex at rest 0.05 m above the face");
    const auto rest = conservative_time(over_a_face({0.2, 0.05, 0.2}, {0.2, 0.05, 0.2}), 0.1, 1e-6);
    expect_that("the time is 0", rest.has_value() && *rest == 0);
    given("a vertex at rest 1 m above the face");
    expect_that("there is no time",
                !conservative_time(over_a_face({0.2, 1, 0.2}, {0.2, 1, 0.2}), 0.1, 1e-6).has_value());
}

TEST_CASE("time: it is never too late, and at it the gap is as good as reached")
{
    const double gap = 0.05, close = 1e-3;
    for (const VertexFaceStep& step : random_steps(40)) {
        given("the vertex goes from ", readable(step.v_t0), " to ", readable(step.v_t1),
              "; gap 0.05 m, close 0.001 m");
        const auto time = conservative_time(step, gap, close);
        const double until = time.value_or(1.0);
        double least = 1e300;
        for (int i = 0; i < 40; ++i)
            least = std::min(least, distance_at(step, until * i / 40));
        expect_that("before it nothing comes nearer than the gap", until == 0 || least > gap - 1e-9);
        if (time && *time > 0)
            expect("distance then", distance_at(step, *time), gap + 0.5 * close, 0.5 * close + 5e-3, "m");
    }
}

TEST_CASE(
    "time: it lies between the gap and what may be near it, wherever a fall ends and whatever else moves")
{
    const double gap = 0.1, height = 1.0;
    for (const double close : {1e-2, 1e-6})
        for (const double way : {1.0, 1.7})
            for (const double together : {0.0, 200.0}) {
                const Vec3 shift(together, 0, 0);
                VertexFaceStep step = over_a_face({0.2, height, 0.2}, Vec3(0.2, height - way, 0.2) + shift);
                for (Vec3* corner : {&step.f0_t1, &step.f1_t1, &step.f2_t1})
                    *corner += shift;
                given("a vertex sinks by ", way, " m from ", height, " m above a face, both go ", together,
                      " m to the side; gap ", gap, " m, close ", close, " m");
                const auto time = conservative_time(step, gap, close);
                expect_that("there is a time", time.has_value());
                if (time)
                    expect("distance then", height - way * *time, gap + 0.5 * close, 0.5 * close + 1e-12,
                           "m");
            }
}

TEST_CASE("time: it is less than 1, also where the gap is reached at the very end")
{
    given("a vertex from 1.25 m above a face to 0.25 m, gap 0.25 m, close 1e-3 m");
    const auto end = conservative_time(over_a_face({0.25, 1.25, 0.25}, {0.25, 0.25, 0.25}), 0.25, 1e-3);
    expect_that("there is no time, or one before the end", !end || *end < 1);
    given("a vertex that sinks by a ten-millionth of a metre, to within the gap of 0.1 m");
    const auto slow = conservative_time(over_a_face({0.2, 0.1 + 0.5e-7, 0.2}, {0.2, 0.1 - 0.5e-7, 0.2}), 0.1,
                                        1e-9);
    expect_that("there is a time", slow.has_value());
    if (slow)
        expect("time", *slow, 0.495, 0.00501);
}

}  // namespace enduring
