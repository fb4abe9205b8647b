#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/textbook.hpp"

#include <doctest/doctest.h>

#include <optional>

using namespace enduring;

namespace {

/// The left side of (4.11) with any vector between two edges in the place of c - a.
double printed_product(const EdgeEdgeStep& step, double tau, const Vec3& between)
{
    const Vec3 ab = at_time(step.ea1_t0, step.ea1_t1, tau) - at_time(step.ea0_t0, step.ea0_t1, tau);
    const Vec3 cd = at_time(step.eb1_t0, step.eb1_t1, tau) - at_time(step.eb0_t0, step.eb0_t1, tau);
    return ab.cross(cd).dot(between);
}

/// A point of an edge at tau.
Vec3 point(const Vec3& from_t0, const Vec3& from_t1, const Vec3& to_t0, const Vec3& to_t1, double tau,
           double w)
{
    return (1 - w) * at_time(from_t0, from_t1, tau) + w * at_time(to_t0, to_t1, tau);
}

}  // namespace

TEST_CASE("errata: (4.11) holds with a vector to E_cd, not with one to E_ac as its text says")
{
    // E_cd comes down on E_ab and meets it at tau = 1/2.
    const EdgeEdgeStep step{{0, 0, 0}, {2, 0, 0}, {1, 3, -1},  {1, 3, 1},
                            {0, 0, 0}, {2, 0, 0}, {1, -3, -1}, {1, -3, 1}};
    const std::optional<double> meeting = textbook_time_of_impact(step);
    REQUIRE(meeting);
    CHECK(*meeting == doctest::Approx(0.5).epsilon(1e-14));
    for (const double tau : {0.0, 0.25, 0.5, 1.0})
        for (const double s : {0.0, 0.5, 1.0})
            for (const double u : {0.0, 0.25, 1.0}) {
                CAPTURE(tau);
                CAPTURE(s);
                CAPTURE(u);
                const Vec3 on_ab = point(step.ea0_t0, step.ea0_t1, step.ea1_t0, step.ea1_t1, tau, s);
                const Vec3 on_cd = point(step.eb0_t0, step.eb0_t1, step.eb1_t0, step.eb1_t1, tau, u);
                const Vec3 on_ac = point(step.ea0_t0, step.ea0_t1, step.eb0_t0, step.eb0_t1, tau, u);
                // To E_cd, any vector gives the same volume: the edges'
                // distance times 4, zero when they meet.
                CHECK(printed_product(step, tau, on_cd - on_ab) == doctest::Approx(-4 * (3 - 6 * tau)));
                // To E_ac it shrinks with the way to a, where it vanishes at any time.
                CHECK(printed_product(step, tau, on_ac - on_ab) == doctest::Approx(-4 * u * (3 - 6 * tau)));
            }
}

TEST_CASE(
    "errata: with p(t) = p_0 + t v from (4.3)'s t_0 on, a vertex starts elsewhere and its touch is missed")
{
    const double t0 = 10, dt = 1;
    const Vec3 p0{0.2, 0.5, 0.2}, v{0, -1, 0};
    const auto fall = [&](auto&& place) {  // onto a triangle at rest in y = 0
        return time_of_impact(VertexFaceStep{
            place(t0), {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, place(t0 + dt), {0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
    };
    const auto printed = fall([&](double t) { return Vec3(p0 + t * v); });
    const auto meant = fall([&](double t) { return Vec3(p0 + (t - t0) * v); });
    CHECK(!printed);
    REQUIRE(meant);
    CHECK(t0 + dt * *meant == doctest::Approx(10.5));
}
