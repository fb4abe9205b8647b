#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "exercises/checking.hpp"

namespace enduring {
namespace {

constexpr double k = 1000, dt = 0.01;  // N/m, s

/// The discrete impulse of a great many short steps along the same line: its limit is the continuous one.
double many_looks(double depth_t0, double depth_t1)
{
    const int looks = 100000;
    double sum = 0;
    for (int i = 0; i < looks; ++i)
        sum += discrete_plane_impulse(depth_t0 + (i + 0.5) / looks * (depth_t1 - depth_t0), k, dt / looks);
    return sum;
}

}  // namespace

TEST_CASE("interval: a line that crosses is inside on one side of its crossing")
{
    given("depth from 0.03 m to -0.01 m");
    const auto in = find_plane_interval(0.03, -0.01);
    REQUIRE(in.has_value());
    expect("begin of the interval", in->begin, 0.75, 1e-15);
    expect("end of the interval", in->end, 1.0, 0);
    given("depth from -0.01 m to 0.03 m");
    const auto out = find_plane_interval(-0.01, 0.03);
    REQUIRE(out.has_value());
    expect("begin of the interval", out->begin, 0.0, 0);
    expect("end of the interval", out->end, 0.25, 1e-15);
}

TEST_CASE("interval: a line that stays inside is inside all the time")
{
    given("depth from -0.03 m to -0.01 m");
    const auto all = find_plane_interval(-0.03, -0.01);
    REQUIRE(all.has_value());
    expect("begin of the interval", all->begin, 0.0, 0);
    expect("end of the interval", all->end, 1.0, 0);
}

TEST_CASE("interval: a line that stays outside, or only touches, is never inside")
{
    for (const auto& [depth_t0, depth_t1] :
         {std::pair(0.03, 0.01), std::pair(0.0, 0.02), std::pair(0.02, 0.0), std::pair(0.0, 0.0)}) {
        given("depth from ", depth_t0, " m to ", depth_t1, " m");
        expect_that("there is no interval", !find_plane_interval(depth_t0, depth_t1).has_value());
    }
}

TEST_CASE("interval: a line that begins or ends on the plane is inside all the rest of its way")
{
    for (const auto& [depth_t0, depth_t1] : {std::pair(0.0, -0.02), std::pair(-0.02, 0.0)}) {
        given("depth from ", depth_t0, " m to ", depth_t1, " m");
        const auto all = find_plane_interval(depth_t0, depth_t1);
        REQUIRE(all.has_value());
        expect("begin of the interval", all->begin, 0.0, 1e-15);
        expect("end of the interval", all->end, 1.0, 1e-15);
    }
}

TEST_CASE("discrete: the impulse is the force at the end of the step times its length")
{
    given("depth at the end -0.02 m, k 1000 N/m, dt 0.01 s");
    expect("impulse", discrete_plane_impulse(-0.02, k, dt), 0.2, 1e-15, "N s");
    given("depth at the end 0.02 m");
    expect("impulse", discrete_plane_impulse(0.02, k, dt), 0.0, 0, "N s");
}

TEST_CASE("continuous: at a constant depth it is the force times the step")
{
    given("depth -0.02 m throughout, k 1000 N/m, dt 0.01 s");
    expect("impulse", continuous_plane_impulse(-0.02, -0.02, k, dt), 0.2, 1e-15, "N s");
}

TEST_CASE("continuous: inside throughout it is the force of the mean depth times the step")
{
    given("depth from -0.03 m to -0.01 m, k 1000 N/m, dt 0.01 s");
    expect("impulse", continuous_plane_impulse(-0.03, -0.01, k, dt), 0.2, 1e-15, "N s");
}

TEST_CASE("continuous: half a step inside charges a triangle, on the way in and on the way out")
{
    given("depth from 0.02 m to -0.02 m and back, k 1000 N/m, dt 0.01 s");
    const double in = continuous_plane_impulse(0.02, -0.02, k, dt),
                 out = continuous_plane_impulse(-0.02, 0.02, k, dt);
    expect("impulse on the way in", in, 0.05, 1e-15, "N s");
    expect("impulse on the way out", out, 0.05, 1e-15, "N s");

    const auto inside = find_plane_interval(0.02, -0.02);
    REQUIRE(inside.has_value());
    say("going in, from 0.02 m to -0.02 m: inside from ", inside->begin, " to ", inside->end);
    say("  continuous ", in, " N s, discrete ", discrete_plane_impulse(-0.02, k, dt), " N s");
    say("coming out again: continuous ", out, " N s, discrete ", discrete_plane_impulse(0.02, k, dt), " N s");
}

TEST_CASE("continuous: it is what many short discrete steps along the way add up to")
{
    for (const auto& [depth_t0, depth_t1] :
         {std::pair(0.07, -0.02), std::pair(-0.05, 0.01), std::pair(-0.04, -0.013)}) {
        given("depth from ", depth_t0, " m to ", depth_t1, " m, k 1000 N/m, dt 0.01 s");
        expect("impulse", continuous_plane_impulse(depth_t0, depth_t1, k, dt), many_looks(depth_t0, depth_t1),
               1e-8, "N s");
    }
}

TEST_CASE("size: the share of the step that is inside decides, from nanometres to kilometres")
{
    for (const double share : {0.001, 0.25, 0.75})
        for (const double deepest : {1e-9, 1e-3, 1e3}) {
            const double highest = deepest * (1 - share) / share;
            given("depth from ", highest, " m to ", -deepest, " m: inside for the last ", share,
                  " of the step");
            const auto in = find_plane_interval(highest, -deepest);
            REQUIRE(in.has_value());
            expect("begin of the interval", in->begin, 1 - share, 1e-12);
            given("depth from ", -deepest, " m to ", highest, " m: inside for the first ", share,
                  " of the step");
            const auto out = find_plane_interval(-deepest, highest);
            REQUIRE(out.has_value());
            expect("end of the interval", out->end, share, 1e-12);
        }
}

TEST_CASE("size: an impulse goes with the stiffness, the step and the depth")
{
    const double share = 0.2;
    for (const double stiffness : {50.0, 2e6})
        for (const double length : {1e-5, 0.5})
            for (const double deepest : {1e-9, 1e-3, 1e3}) {
                const double highest = deepest * (1 - share) / share,
                             force_times_dt = stiffness * length * deepest;
                given("depth ", -deepest, " m at the end, k ", stiffness, " N/m, dt ", length, " s");
                expect("discrete impulse", discrete_plane_impulse(-deepest, stiffness, length),
                       force_times_dt, 1e-12 * force_times_dt, "N s");
                given("depth from ", highest, " m to ", -deepest, " m: ", share,
                      " of the step inside, at half of this depth on average; k ", stiffness, " N/m, dt ",
                      length, " s");
                expect("continuous impulse", continuous_plane_impulse(highest, -deepest, stiffness, length),
                       0.5 * share * force_times_dt, 1e-12 * force_times_dt, "N s");
            }
}

}  // namespace enduring
