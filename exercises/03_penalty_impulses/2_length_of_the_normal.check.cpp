#include "exercises/03_penalty_impulses/2_length_of_the_normal.hpp"
#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

constexpr double k = 800, dt = 0.01, depth = 0.002;

/// A vertex under the corner of a face with two sides of 1 m, which a
/// motion of the corner's neighbours takes along.
PairVertices under_face(double height, double growth = 1, double turn_deg = 0)
{
    const double turn = turn_deg * std::numbers::pi / 180;
    return {Vec3(0, height, 0), Vec3(0, 0, 0), Vec3(0, 0, growth),
            growth * Vec3(std::cos(turn), std::sin(turn), 0)};
}

PairStep step_between(const PairVertices& t0, const PairVertices& t1)
{
    return {vertex_face_instant(t0), vertex_face_instant(t1)};
}

/// The vertex stays 2 mm under the face while the face's sides grow.
PairStep growing(double growth) { return step_between(under_face(-depth), under_face(-depth, growth)); }

/// The vertex stays where it is while the face turns about its own corner.
PairStep turning(double degrees, double height = -0.1)
{
    return step_between(under_face(height), under_face(height, 1, degrees));
}

/// A face that sways while a vertex passes over it: inside twice, see the chapter's figure of shapes.
PairStep two_visits()
{
    return step_between({Vec3(0.45, 0.005, 0), Vec3(-1, -0.06, -1), Vec3(-1, -0.06, 1), Vec3(1, 0.06, 0)},
                        {Vec3(-0.45, 0.01, 0), Vec3(-1, 0.08, -1), Vec3(-1, 0.08, 1), Vec3(1, -0.08, 0)});
}

PairInstant instant(const PairStep& step, double tau)
{
    const auto mix = [tau](const Vec3& t0, const Vec3& t1) { return Vec3((1 - tau) * t0 + tau * t1); };
    return {mix(step.t0.side_1, step.t1.side_1), mix(step.t0.side_2, step.t1.side_2),
            mix(step.t0.offset, step.t1.offset)};
}

/// The impulse of the unit normal from its definition: many equal pieces, each looked at in its middle.
Vec3 summed_impulse(const PairStep& step)
{
    const int count = 20000;
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < count; ++i) {
        const PairInstant now = instant(step, (i + 0.5) / count);
        const Vec3 unit = now.side_1.cross(now.side_2).normalized();
        sum += std::min(0.0, unit.dot(now.offset)) * unit;
    }
    return -k * dt / count * sum;
}

double percent_off(const Vec3& impulse, const Vec3& right)
{
    return 100 * (impulse - right).norm() / right.norm();
}

}  // namespace

TEST_CASE("rest: a face that does not move gives k dt times the depth, whatever its size")
{
    for (const double size : {1e3, 1.0, 1e-3, 1e-6}) {
        given("a vertex 2 mm under a resting face with sides of ", size, " m, k = 800 N/m, dt = 0.01 s");
        const PairStep rest = step_between(under_face(-depth, size), under_face(-depth, size));
        const Vec3 right(0, k * dt * depth, 0);
        expect("by the length of the visit", impulse_by_length_of_visit(rest, 0, k, dt), right, 1e-12, "N s");
        expect("by unit normals", impulse_by_unit_normals(rest, 0, k, dt, 1), right, 1e-12, "N s");
    }
}

TEST_CASE("rest: what lies before the start does not count")
{
    given("a vertex 2 mm under a resting face, start = 0.75: a quarter of the step is left");
    const PairStep rest = step_between(under_face(-depth), under_face(-depth));
    const Vec3 right(0, 0.25 * k * dt * depth, 0);
    expect("by the length of the visit", impulse_by_length_of_visit(rest, 0.75, k, dt), right, 1e-12, "N s");
    expect("by unit normals", impulse_by_unit_normals(rest, 0.75, k, dt, 3), right, 1e-12, "N s");
}

TEST_CASE("rest: the last instant of a step counts by its length")
{
    for (const double left : {0.1, 1e-5}) {
        given("a vertex 2 mm under a resting face, start = 1 - ", left);
        const PairStep rest = step_between(under_face(-depth), under_face(-depth));
        const Vec3 right(0, k * dt * depth, 0);
        expect("by the length of the visit, over what is left",
               Vec3(impulse_by_length_of_visit(rest, 1 - left, k, dt) / left), right, 1e-10, "N s");
        expect("by unit normals, over what is left",
               Vec3(impulse_by_unit_normals(rest, 1 - left, k, dt, 3) / left), right, 1e-10, "N s");
    }
}

TEST_CASE("visit: a face that grows under a vertex at constant depth makes no error")
{
    // depth times normal is the depth times the squared length: divided by
    // the mean of just that, only the depth is left.
    for (const double start : {0.0, 0.5, 0.9}) {
        given("2 mm under a face whose sides grow from 1 m to 1.1 m, start = ", start);
        expect("by the length of the visit", impulse_by_length_of_visit(growing(1.1), start, k, dt),
               Vec3(0, k * dt * depth * (1 - start), 0), 1e-12, "N s");
    }
}

TEST_CASE("unit normals: a face that grows under a vertex at constant depth makes no error")
{
    for (const double start : {0.0, 0.5, 0.9}) {
        given("2 mm under a face whose sides grow from 1 m to 1.1 m, start = ", start, ", 4 pieces");
        expect("by unit normals", impulse_by_unit_normals(growing(1.1), start, k, dt, 4),
               Vec3(0, k * dt * depth * (1 - start), 0), 1e-12, "N s");
    }
}

TEST_CASE("visit: where the pair is inside all the time, it is the chapter's own impulse")
{
    given("a face that turns by 45 degrees over a vertex that stays inside");
    expect("by the length of the visit", impulse_by_length_of_visit(turning(45), 0, k, dt),
           continuous_impulse(turning(45), 0, k, dt), 1e-12, "N s");
}

TEST_CASE("unit normals: a face that turns gives the sum of pushes along the unit normals")
{
    given("a face that turns by 45 degrees over a vertex that stays inside, 8 pieces");
    expect("by unit normals", impulse_by_unit_normals(turning(45), 0, k, dt, 8), summed_impulse(turning(45)),
           1e-7, "N s");
}

TEST_CASE("unit normals: three points of Gauss are much better than their middle")
{
    given("a face that turns by 20 degrees over a vertex that stays inside, 1 piece");
    const Vec3 right = summed_impulse(turning(20));
    expect("by unit normals", impulse_by_unit_normals(turning(20), 0, k, dt, 1), right, 1e-5 * right.norm(),
           "N s");
}

TEST_CASE("unit normals: twice as many pieces make the error 64 times smaller, as three points of Gauss do")
{
    const PairStep step = turning(60);
    const double start = 0.25;
    const Vec3 right = impulse_by_unit_normals(step, start, k, dt, 200);
    for (const int pieces : {2, 3, 4}) {
        const double error = (impulse_by_unit_normals(step, start, k, dt, pieces) - right).norm(),
                     half = (impulse_by_unit_normals(step, start, k, dt, 2 * pieces) - right).norm();
        given("a face that turns by 60 degrees over a vertex that stays inside, start = ", start, ", ",
              pieces, " pieces and twice as many");
        expect("error over error", error / half, 64.0, 20);
    }
}

TEST_CASE("two visits: both count, in both ways")
{
    given("a face that sways while a vertex passes over it, 16 pieces");
    const Vec3 right = summed_impulse(two_visits());
    expect("by unit normals", impulse_by_unit_normals(two_visits(), 0, k, dt, 16), right, 1e-6, "N s");
    expect("by the length of the visit", impulse_by_length_of_visit(two_visits(), 0, k, dt), right,
           0.01 * right.norm(), "N s");
}

TEST_CASE("without a normal: no impulse, and no NaN")
{
    const PairInstant needle{Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, -1, 0)};
    given("sides (1, 0, 0) m and (2, 0, 0) m, at both ends of the step");
    expect("by the length of the visit", impulse_by_length_of_visit({needle, needle}, 0, k, dt),
           Vec3(0, 0, 0), 0, "N s");
    expect("by unit normals", impulse_by_unit_normals({needle, needle}, 0, k, dt, 2), Vec3(0, 0, 0), 0,
           "N s");
}

TEST_CASE("cost: the pieces suffice, and half as many would not")
{
    for (const double degrees : {20.0, 80.0, 120.0})
        for (const double tolerance : {1e-4, 1e-9}) {
            const PairStep step = turning(degrees);
            const auto change = [&](int pieces) {
                const Vec3 fine = impulse_by_unit_normals(step, 0, 1, 1, 2 * pieces);
                return (fine - impulse_by_unit_normals(step, 0, 1, 1, pieces)).norm() / fine.norm();
            };
            const int pieces = pieces_for(step, tolerance);
            given("a face that turns by ", degrees, " degrees, tolerance ", tolerance, "; you say ", pieces,
                  " pieces");
            expect_that("twice as many pieces change the impulse by at most the tolerance",
                        change(pieces) <= tolerance);
            expect_that("half as many pieces are not enough", pieces == 1 || change(pieces / 2) > tolerance);
            expect_that("it is one of 1, 2, 4, 8, 16 and 32",
                        pieces >= 1 && pieces <= 32 && (pieces & (pieces - 1)) == 0);
        }
}

TEST_CASE("cost: what counts is the change that twice as many make, to the last part")
{
    const PairStep step = turning(80);
    for (const int pieces : {2, 4}) {
        const Vec3 fine = impulse_by_unit_normals(step, 0, 1, 1, 2 * pieces);
        const double change = (fine - impulse_by_unit_normals(step, 0, 1, 1, pieces)).norm() / fine.norm();
        given("a face that turns by 80 degrees; from ", pieces, " to ", 2 * pieces,
              " pieces the impulse changes by the part ", change);
        expect("pieces for a tolerance a thousandth above it", pieces_for(step, 1.001 * change), pieces, 0);
        expect("pieces for a tolerance a thousandth below it", pieces_for(step, 0.999 * change), 2 * pieces,
               0);
    }
}

TEST_CASE("cost: where 32 pieces are not enough, it is 64")
{
    given("a face that turns by 179 degrees over a vertex that stays inside, tolerance 1e-9");
    expect("pieces", pieces_for(turning(179), 1e-9), 64, 0);
}

TEST_CASE("cost: a pair that is never inside takes one piece, for nothing changes at all")
{
    given("a face that turns by 45 degrees, a vertex 10 cm above it");
    expect("pieces", pieces_for(turning(45, 0.1), 1e-6), 1, 0);
}

TEST_CASE("cost: a shallow pair takes as many pieces as a deep one")
{
    given("a face that turns by 80 degrees, a vertex 1 um or 10 cm deep, tolerance 1e-9");
    expect("pieces for 1 um, as for 10 cm", pieces_for(turning(80, -1e-6), 1e-9),
           pieces_for(turning(80), 1e-9), 0);
}

TEST_CASE("comparison: for a late visit to a growing face only the length of the step is wrong")
{
    given("2 mm under a face whose sides grow from 1 m to 1.1 m, start = 0.5");
    const Vec3 right(0, k * dt * depth * 0.5, 0);
    const double by_step = percent_off(continuous_impulse(growing(1.1), 0.5, k, dt), right);
    const double by_visit = percent_off(impulse_by_length_of_visit(growing(1.1), 0.5, k, dt), right);
    expect_that("the length of the step is off by more than 5 %, that of the visit by none",
                by_step > 5 && by_visit < 1e-9);
    const Vec3 turned = summed_impulse(turning(45));
    say("grows by 10 %, start 0.5: off by ", by_step,
        " % with the length of the step, 0 % with that of the visit");
    say("turns by 45 degrees:      off by ", percent_off(continuous_impulse(turning(45), 0, k, dt), turned),
        " % with either; for 1e-6, unit normals take ", pieces_for(turning(45), 1e-6), " pieces");
}
