#include "chapters/02_collision_detection/textbook.hpp"
#include "exercises/checking.hpp"

namespace enduring {
namespace {

/// A vertex that moves from one place to another over a face that rests: (0, 0, 0), (1, 0, 0), (0, 0, 1).
VertexFaceStep over_a_face(const Vec3& from, const Vec3& to)
{
    const Vec3 f0(0, 0, 0), f1(1, 0, 0), f2(0, 0, 1);
    return {from, f0, f1, f2, to, f0, f1, f2};
}

/// An edge along x from (x0, y, 0) to (x0 + 1, y, 0) falls from y = from to y = to; the other lies along z
/// through the origin, from -1/2 to 1/2.
EdgeEdgeStep falling_edge(double x0, double from, double to)
{
    const Vec3 b0(0, 0, -0.5), b1(0, 0, 0.5);
    return {Vec3(x0, from, 0), Vec3(x0 + 1, from, 0), b0, b1, Vec3(x0, to, 0), Vec3(x0 + 1, to, 0), b0, b1};
}

constexpr TextbookTolerances exact{.coefficient = 0, .weight = 0, .time = 0};

template <class Step>
void expect_time(const Step& step, double expected, const TextbookTolerances& tolerances = {})
{
    const auto time = textbook_time_of_impact(step, tolerances);
    expect_that("there is a touch", time.has_value());
    if (time)
        expect("time of the touch", *time, expected, 1e-12);
}

template <class Step>
void expect_none(const Step& step, const TextbookTolerances& tolerances = {})
{
    expect_that("there is no touch", !textbook_time_of_impact(step, tolerances).has_value());
}

/// A step in which all lengths are another size.
template <class Step>
Step scaled(Step step, double size)
{
    Vec3* points = &reinterpret_cast<Vec3&>(step);
    for (std::size_t i = 0; i < sizeof(Step) / sizeof(Vec3); ++i)
        points[i] *= size;
    return step;
}

/// Turns and moves a whole step.
template <class Step>
Step moved(const Step& step)
{
    const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, 2, -2) / 3).toRotationMatrix();
    Step result = step;
    Vec3* points = &reinterpret_cast<Vec3&>(result);
    for (std::size_t i = 0; i < sizeof(Step) / sizeof(Vec3); ++i)
        points[i] = turn * points[i] + Vec3(0.3, -2, 1);
    return result;
}

}  // namespace

TEST_CASE("vertex: it touches a face when it comes through, from above and from below")
{
    given("a vertex from (0.2, 1, 0.2) m to (0.2, -1, 0.2) m");
    expect_time(over_a_face({0.2, 1, 0.2}, {0.2, -1, 0.2}), 0.5);
    given("a vertex from (0.2, -1, 0.2) m to (0.2, 1, 0.2) m");
    expect_time(over_a_face({0.2, -1, 0.2}, {0.2, 1, 0.2}), 0.5);
    given("a vertex from (0.2, 1, 0.2) m to (0.2, -2, 0.2) m");
    expect_time(over_a_face({0.2, 1, 0.2}, {0.2, -2, 0.2}), 1 / 3.0);
    say("a vertex falls through a face: touch at ",
        textbook_time_of_impact(over_a_face({0.2, 1, 0.2}, {0.2, -1, 0.2})).value_or(-1));
}

TEST_CASE("vertex: it misses a face that it passes on any of three sides")
{
    for (const Vec3& beside : {Vec3(-0.1, 0, 0.5), Vec3(0.5, 0, -0.1), Vec3(0.6, 0, 0.6)}) {
        given("a vertex that falls through the face's plane at ", readable(beside), " m");
        expect_none(over_a_face(beside + Vec3(0, 1, 0), beside - Vec3(0, 1, 0)));
    }
}

TEST_CASE("vertex: one within the tolerance of a side touches, on any of three sides")
{
    for (const Vec3& beside : {Vec3(-0.1, 0, 0.5), Vec3(0.5, 0, -0.1), Vec3(0.6, 0, 0.5)}) {
        given("a vertex that falls through the face's plane at ", readable(beside),
              " m, tolerance 0.2 on the weights");
        expect_time(over_a_face(beside + Vec3(0, 1, 0), beside - Vec3(0, 1, 0)), 0.5, {.weight = 0.2});
    }
}

TEST_CASE("vertex: a meeting before or after the step does not count")
{
    given("a vertex that stops 0.1 m above the face");
    expect_none(over_a_face({0.2, 1, 0.2}, {0.2, 0.1, 0.2}));
    given("a vertex that begins 0.1 m below it and goes on down");
    expect_none(over_a_face({0.2, -0.1, 0.2}, {0.2, -1, 0.2}));
}

TEST_CASE("vertex: a meeting within the tolerance of the step's end counts, and is told as that end")
{
    given("a vertex that stops 0.1 m above the face, tolerance 0.2 on the time");
    expect_time(over_a_face({0.2, 1, 0.2}, {0.2, 0.1, 0.2}), 1.0, {.time = 0.2});
}

TEST_CASE("vertex: face and vertex may both move, and turning the whole world changes nothing")
{
    // The face rises by 1 while the vertex falls by 1; the face also spreads.
    const VertexFaceStep both{Vec3(0.2, 1, 0.2), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1),
                              Vec3(0.2, 0, 0.2), Vec3(0, 1, 0), Vec3(3, 1, 0), Vec3(0, 1, 3)};
    given("a vertex that falls by 1 m, a face that rises by 1 m and grows");
    expect_time(both, 0.5);
    given("the same, turned and moved");
    expect_time(moved(both), 0.5);
    // The face's plane is y = 0.4 tau (x + z): the vertex meets it when 1 - 2 tau = 0.2 tau.
    const VertexFaceStep tilting{Vec3(0.2, 1, 0.3),  Vec3(0, 0, 0), Vec3(1, 0, 0),   Vec3(0, 0, 1),
                                 Vec3(0.2, -1, 0.3), Vec3(0, 0, 0), Vec3(1, 0.4, 0), Vec3(0, 0.4, 1)};
    given("a vertex that falls by 2 m, a face that tilts about its corner f0");
    expect_time(tilting, 1 / 2.2);
}

TEST_CASE("vertex: of several meetings the first one inside the face counts")
{
    // The corner f2 swings, so the vertex lies in the face's plane at 0.2, where z is -1/4 and it is beside
    // the face, and at 0.8, where z is 1/2.
    const Vec3 f0(0, 0, 0), f1(1, 0, 0);
    const VertexFaceStep step{Vec3(0.25, -0.1, -0.5),  f0, f1, Vec3(0, 0.4, 1),
                              Vec3(0.25, 0.025, 0.75), f0, f1, Vec3(0, -0.1, 1)};
    given("a face whose corner swings while a vertex crosses its plane twice, first beside the face");
    expect_time(step, 0.8);
}

TEST_CASE(
    "vertex: a meeting at the very start or end of the step counts, and so does a side or a corner of the face")
{
    given("a vertex from (0.25, 0, 0.25) m, in the face, to (0.25, -1, 0.25) m, tolerances 0");
    expect_time(over_a_face({0.25, 0, 0.25}, {0.25, -1, 0.25}), 0.0, exact);
    given("a vertex from (0.25, 1, 0.25) m to (0.25, 0, 0.25) m, in the face, tolerances 0");
    expect_time(over_a_face({0.25, 1, 0.25}, {0.25, 0, 0.25}), 1.0, exact);
    for (const Vec3& border :
         {Vec3(0, 0, 0.5), Vec3(0.5, 0, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0, 0), Vec3(1, 0, 0)}) {
        given("a vertex that falls through the face's border at ", readable(border), " m, tolerances 0");
        expect_time(over_a_face(border + Vec3(0, 1, 0), border - Vec3(0, 1, 0)), 0.5, exact);
    }
}

TEST_CASE("vertex: a face that closes to a line, far from the vertex, is no touch")
{
    // The corner f2 goes through f0: at 0.5 the four points lie in one plane, and the weights are 0 / 0.
    const Vec3 v(2, 1, 0), f0(0, 0, 0), f1(1, 0, 0);
    given("a vertex that rests at (2, 1, 0) m; f2 goes from (0, 0, 1) to (0, 0, -1) m, through f0");
    expect_none(VertexFaceStep{v, f0, f1, Vec3(0, 0, 1), v, f0, f1, Vec3(0, 0, -1)});
}

TEST_CASE("edges: two that become parallel, far from each other, are no touch")
{
    const Vec3 a0(0, 0, 0), a1(1, 0, 0), b0(0, 1, 0);
    given("an edge from (0, 0, 0) to (1, 0, 0) m; another from (0, 1, 0) to (1, 1, 1 - 2 tau) m");
    expect_none(EdgeEdgeStep{a0, a1, b0, Vec3(1, 1, 1), a0, a1, b0, Vec3(1, 1, -1)});
}

TEST_CASE("edges: the very end of an edge belongs to it")
{
    for (const double first : {0.0, -1.0}) {
        given("an edge along x that falls on another with its end, from x = ", first, " m to ", first + 1,
              " m");
        expect_time(falling_edge(first, 1, -3), 0.25, exact);
        given("an edge that falls on the end of another, at z = ", first + 0.5, " m");
        EdgeEdgeStep on_the_end = falling_edge(-0.5, 1, -3);
        for (Vec3* end : {&on_the_end.ea0_t0, &on_the_end.ea1_t0, &on_the_end.ea0_t1, &on_the_end.ea1_t1})
            end->z() = first + 0.5;
        expect_time(on_the_end, 0.25, exact);
    }
}

TEST_CASE("size: millimetres and kilometres have the same times")
{
    const VertexFaceStep inside = over_a_face({0.2, 1, 0.2}, {0.2, -2, 0.2}),
                         outside = over_a_face({0.6, 1, 0.6}, {0.6, -1, 0.6});
    for (const double size : {1e-3, 1.0, 1e3}) {
        given("a face of sides ", size, " m; a vertex falls from ", size, " m over it to ", 2 * size,
              " m under it");
        expect_time(scaled(inside, size), 1 / 3.0);
        given("a face of sides ", size, " m; a vertex falls by ", 2 * size, " m beside it");
        expect_none(scaled(outside, size));
        given("two edges of length ", size, " m; one falls from ", size, " m over the other to ", 3 * size,
              " m under it");
        expect_time(scaled(falling_edge(-0.5, 1, -3), size), 0.25);
        given("two edges of length ", size, " m; one falls past the other's end, by a tenth of its length");
        expect_none(scaled(falling_edge(0.1, 1, -3), size));
    }
}

TEST_CASE("tolerance: it is yours to pass on, whatever its size: on the weights, and on the coefficients")
{
    for (const double tolerance : {1e-12, 1e-6, 1e-2}) {
        for (const Vec3& beside : {Vec3(-1, 0, 0.5), Vec3(0.5, 0, -1), Vec3(1, 0, 1)}) {
            const bool third = beside.x() > 0 && beside.z() > 0;
            const Vec3 place = third ? Vec3(0.5 + tolerance / 4, 0, 0.5 + tolerance / 4)
                                     : Vec3(beside.x() < 0 ? -tolerance / 2 : 0.25, 0,
                                            beside.z() < 0 ? -tolerance / 2 : 0.25),
                       farther = third ? Vec3(0.5 + tolerance, 0, 0.5 + tolerance)
                                       : Vec3(2.0 * place.cwiseMin(0) + place);
            given("a vertex that falls through the face's plane at ", readable(place),
                  " m, half the tolerance ", tolerance, " beside the face");
            expect_time(over_a_face(place + Vec3(0, 1, 0), place - Vec3(0, 1, 0)), 0.5,
                        {.weight = tolerance});
            given("a vertex that falls through the face's plane at ", readable(farther),
                  " m, farther beside the face than the tolerance ", tolerance);
            expect_none(over_a_face(farther + Vec3(0, 1, 0), farther - Vec3(0, 1, 0)), {.weight = tolerance});
        }
        given("an edge that passes the other's line by half the tolerance ", tolerance,
              " before its own end");
        expect_time(falling_edge(tolerance / 2, 1, -3), 0.25, {.weight = tolerance});
        given("an edge that passes the other's line by twice the tolerance ", tolerance,
              " before its own end");
        expect_none(falling_edge(2 * tolerance, 1, -3), {.weight = tolerance});
    }
    // The face's corner f1 moves along x, so the cubic is (1 - 2 tau)(1 + 0.1 tau): its last coefficient is
    // dropped where the tolerance is 0.2 of the largest, and what is left is 1 - 1.9 tau.
    VertexFaceStep growing = over_a_face({0.2, 1, 0.2}, {0.2, -1, 0.2});
    growing.f1_t1 = Vec3(1.1, 0, 0);
    given(
        "a vertex that falls through a growing face: the cubic is 1 - 1.9 tau - 0.2 tau^2, tolerance 0.01 on its coefficients");
    expect_time(growing, 0.5, {.coefficient = 0.01});
    given("the same, with tolerance 0.2 on the coefficients: what is left is 1 - 1.9 tau");
    expect_time(growing, 1 / 1.9, {.coefficient = 0.2});
}

TEST_CASE("edges: they touch when one falls on the other, and miss beyond an end of either")
{
    given("an edge along x that falls from 1 m to -3 m on an edge along z");
    expect_time(falling_edge(-0.5, 1, -3), 0.25);
    say("two edges cross: touch at ", textbook_time_of_impact(falling_edge(-0.5, 1, -3)).value_or(-1));
    given("the same, turned and moved");
    expect_time(moved(falling_edge(-0.3, 1, -3)), 0.25);
    given("the falling edge ends 0.1 m before the other");
    expect_none(falling_edge(0.1, 1, -3));
    given("the falling edge begins 0.1 m behind the other");
    expect_none(falling_edge(-1.1, 1, -3));
    EdgeEdgeStep past = falling_edge(-0.5, 1, -3);
    for (Vec3* end : {&past.ea0_t0, &past.ea1_t0, &past.ea0_t1, &past.ea1_t1})
        end->z() = 0.6;
    given("the falling edge passes 0.1 m beyond the other's end");
    expect_none(past);
}

TEST_CASE("edges: one within the tolerance of an end touches")
{
    given("an edge that passes the other's line 0.1 m before its own end, tolerance 0.2 on the weights");
    expect_time(falling_edge(0.1, 1, -3), 0.25, {.weight = 0.2});
}

}  // namespace enduring
