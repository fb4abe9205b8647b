#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// A ridge like a roof of 90 degrees: its edge 0 runs 1 m along z, through the origin, and both faces fall from it.
SurfaceMesh roof() { return {{{0, 0, -0.5}, {0, 0, 0.5}, {1, -1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}}; }

/// The same upside down, its edge along x, moved.
SurfaceMesh keel(const Vec3& place, double turned = 0)
{
    const Quaternion over(Eigen::AngleAxisd(std::numbers::pi, Vec3(1, 0, 1).normalized()));
    const Quaternion about(Eigen::AngleAxisd(turned, Vec3::UnitY()));
    return placed(roof(), 1, about * over, place);
}

SurfaceMesh scaled(const SurfaceMesh& mesh, double size, const Quaternion& turn = Quaternion::Identity())
{
    return placed(mesh, size, turn);
}

std::optional<Meeting> meeting_of(const MovingSurface& a, int edge_a, const MovingSurface& b, int edge_b,
                                  const Reach& reach, bool known = false)
{
    return find_edge_meeting(a.step(), edge_a, b.step(), edge_b, reach, known);
}

/// The keel comes down on the roof, from one height to another one.
std::optional<Meeting> on_roof(double from, double to, const Reach& reach, double size = 1,
                               const Quaternion& turn = Quaternion::Identity())
{
    const MovingSurface a(scaled(keel({0.1, from, 0.2}), size, turn), size * (turn * Vec3(0, to - from, 0))),
        b(scaled(roof(), size, turn));
    return meeting_of(a, a.edge_between(0, 1), b, b.edge_between(0, 1), reach);
}

/// The normal of a pair at the start of the step, out of B as its orientation says.
Vec3 normal_of(const MovingSurface& a, int edge_a, const MovingSurface& b, int edge_b, double orientation)
{
    const auto along = [](const MovingSurface& surface, int edge) {
        const auto [p, q] = surface.topology.edges()[static_cast<std::size_t>(edge)];
        return Vec3(surface.t0[static_cast<std::size_t>(q)] - surface.t0[static_cast<std::size_t>(p)]);
    };
    return orientation * along(a, edge_a).cross(along(b, edge_b)).normalized();
}

}  // namespace

TEST_CASE("edge meeting: near or inside at the start, and within the step, there is a pair")
{
    Draw draw(1);
    for (const double size : {1e-3, 1.0, 100.0}) {
        const Quaternion turn = draw.turn();
        const Reach reach{0.01 * size, 0.1 * size};
        const auto when = [&](double from, double to) -> int {
            const auto meeting = on_roof(from, to, reach, size, turn);
            if (!meeting)
                return -1;
            return meeting->tau > 0 ? 1 : 0;
        };
        CAPTURE(size);
        const int start = 0, crossing = 1;
        for (const double to : {-0.3, 0.001, 0.02, 0.5}) {
            CHECK(when(0.009, to) == start);
            CHECK(when(-0.01, to) == start);
            CHECK(when(-0.09, to) == start);
        }
        CHECK(when(0.5, -0.001) == crossing);
        CHECK(when(0.5, -0.9) == crossing);
        CHECK(when(0.5, 0.009) == crossing);  // it ends near
        CHECK(when(0.5, 0.011) == -1);
        CHECK(when(0.02, 0.5) == -1);
        CHECK(when(-0.11, -0.11) == -1);
        CHECK(when(-0.5, -0.005) == -1);
        CHECK(when(-0.5, 0.005) == -1);
    }
}

TEST_CASE("edge meeting: edges that slide may be deeper at the start by a hundredth of their way")
{
    Draw draw(6);
    for (const double size : {1e-3, 1.0, 100.0})
        for (const double way : {0.0, 0.2, 2.0})
            for (const double part : {0.9, 1.1}) {
                const Quaternion turn = draw.turn();
                const double inside = 0.01, deep = part * (inside + 0.01 * way);
                const MovingSurface a(scaled(keel({0.1, -deep, -0.2}), size, turn),
                                      size * (turn * Vec3(0, 0, way))),
                    b(scaled(roof(), size, turn));
                CAPTURE(size);
                CAPTURE(way);
                CAPTURE(part);
                CHECK(meeting_of(a, a.edge_between(0, 1), b, b.edge_between(0, 1),
                                 {0.001 * size, inside * size})
                          .has_value() == (part < 1));
            }
}

TEST_CASE("edge meeting: the normal points out of B, whichever edge is whose and however they are numbered")
{
    for (const double height : {-0.01, 0.005, 0.3})
        for (const double turned : {0.0, 0.7, -0.7, 3.0}) {
            const MovingSurface upper(keel({0, height, 0}, turned), Vec3(0, -0.32, 0)), lower(roof());
            const int edge_u = upper.edge_between(0, 1), edge_l = lower.edge_between(0, 1);
            CAPTURE(height);
            CAPTURE(turned);
            const auto down = meeting_of(upper, edge_u, lower, edge_l, {0.01, 0.1}),
                       up = meeting_of(lower, edge_l, upper, edge_u, {0.01, 0.1});
            REQUIRE(down);
            REQUIRE(up);
            CHECK(normal_of(upper, edge_u, lower, edge_l, down->orientation).y() > 0.99);
            CHECK(normal_of(lower, edge_l, upper, edge_u, up->orientation).y() < -0.99);
        }
}

TEST_CASE("edge meeting: what passes within the step has a pair, as chapter 2's query has it")
{
    Draw draw(2);
    int met = 0, missed = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const double size = std::pow(10, draw.between(-3, 2)), speed = std::pow(10, draw.between(-1, 3));
        const Quaternion turn = draw.turn();
        // Down on the roof at any place; fast ones begin and end far away.
        const Vec3 place(draw.between(-0.8, 0.8), 0, draw.between(-0.8, 0.8));
        const Vec3 path = speed * (Vec3(0, -1, 0) + 0.3 * draw.direction());
        const double before = draw.between(0.02, 1.2);
        const MovingSurface a(scaled(keel(place - before * path, draw.between(-60, 60) * degree), size, turn),
                              size * (turn * path)),
            b(scaled(roof(), size, turn));
        const int edge_a = a.edge_between(0, 1), edge_b = b.edge_between(0, 1);
        const auto touch = time_of_impact(edge_edge_step(a.step(), edge_a, b.step(), edge_b));
        const auto meeting = meeting_of(a, edge_a, b, edge_b, {0, 0});
        CAPTURE(trial);
        CAPTURE(size);
        CAPTURE(speed);
        if (!touch) {
            CHECK_FALSE(meeting);
            ++missed;
            continue;
        }
        REQUIRE(meeting);
        CHECK(meeting->tau > 0);
        CHECK(meeting->tau == doctest::Approx(before).epsilon(1e-6));
        // Both feet are the place where they meet.
        const auto along = [](const MovingSurface& surface, int edge) {
            const auto [p, q] = surface.topology.edges()[static_cast<std::size_t>(edge)];
            return std::pair(p, q);
        };
        const auto [a0, a1] = along(a, edge_a);
        const auto [b0, b1] = along(b, edge_b);
        const SurfaceMoment still_a{a.step(), meeting->tau}, still_b{b.step(), meeting->tau};
        const Vec3 on_a = meeting->weights[0] * still_a.position(a0) +
                          meeting->weights[1] * still_a.position(a1);
        const Vec3 on_b = -meeting->weights[2] * still_b.position(b0) -
                          meeting->weights[3] * still_b.position(b1);
        CHECK((on_a - on_b).norm() < 1e-6 * size * std::max(1.0, speed));
        ++met;
    }
    CHECK(met > 500);
    CHECK(missed > 500);
}

TEST_CASE(
    "edge meeting: past the end of an edge at a convex vertex there is none, but for a known pair a hair past it")
{
    const MovingSurface roof_below(roof());
    const auto beside = [&](double past, bool known) {
        const MovingSurface above(keel({0, -0.005, 0.5 + past}));
        return meeting_of(above, above.edge_between(0, 1), roof_below, roof_below.edge_between(0, 1),
                          {0.01, 0.1}, known)
            .has_value();
    };
    CHECK(beside(-1e-6, false));
    CHECK_FALSE(beside(1e-6, false));
    CHECK_FALSE(beside(0.005, false));
    CHECK(beside(0.5 * search_parts.hysteresis, true));
    CHECK_FALSE(beside(2 * search_parts.hysteresis, true));
    for (const double past : {1e-6, 0.005}) {  // the same past the end of the other one
        const MovingSurface above(keel({0.5 + past, -0.005, 0}));
        CAPTURE(past);
        CHECK_FALSE(meeting_of(above, above.edge_between(0, 1), roof_below, roof_below.edge_between(0, 1),
                               {0.01, 0.1}));
    }
}

TEST_CASE("edge meeting: parallel edges have no pair, at either end of the step")
{
    const MovingSurface below(roof());
    for (const double turned : {90.0, 90 + 1e-4}) {
        const MovingSurface above(keel({0, 0.001, 0}, turned * degree), Vec3(0, -0.01, 0));
        CAPTURE(turned);
        CHECK_FALSE(meeting_of(above, above.edge_between(0, 1), below, 0, {0.01, 0.1}));
    }
    const MovingSurface above(keel({0, 0.001, 0}, 80 * degree), Vec3(0, -0.01, 0));
    CHECK(meeting_of(above, above.edge_between(0, 1), below, below.edge_between(0, 1), {0.01, 0.1}));
}

TEST_CASE(
    "edge meeting: edges of flat sides and of valleys have no pair, and none that would push into its body")
{
    const auto meets = [](const SurfaceMesh& mesh) {
        const MovingSurface above(keel({0, -0.001, 0})), below(mesh);
        return meeting_of(above, above.edge_between(0, 1), below, below.edge_between(0, 1), {0.01, 0.1})
            .has_value();
    };
    const auto roof_of = [](double fall) {
        SurfaceMesh mesh = roof();
        for (const std::size_t i : {2U, 3U})
            mesh.vertices[i].y() = -fall;
        return mesh;
    };
    CHECK(meets(roof_of(1)));
    CHECK(meets(roof_of(0.01)));
    CHECK_FALSE(meets(roof_of(0)));
    CHECK_FALSE(meets(roof_of(-0.5)));
    SurfaceMesh inside_out = roof();
    for (Face& face : inside_out.faces)
        std::swap(face[0], face[1]);
    CHECK_FALSE(meets(inside_out));
}

TEST_CASE("edge meeting: a known pair stays where elements have bent an edge inwards by less than a cone may")
{
    const MovingSurface above(keel({0, -0.001, 0}));
    const auto meets = [&](double fall, bool known) {
        SurfaceMesh mesh = roof();
        for (const std::size_t i : {2U, 3U})
            mesh.vertices[i].y() = -fall;
        const MovingSurface below(mesh);
        return meeting_of(above, above.edge_between(0, 1), below, below.edge_between(0, 1), {0.01, 0.1},
                          known)
                   .has_value() &&
               meeting_of(below, below.edge_between(0, 1), above, above.edge_between(0, 1), {0.01, 0.1},
                          known)
                   .has_value();
    };
    for (const double fall : {0.0, -1e-3, -0.05, -0.09}) {  // both sides rise: it folds by twice the angle
        CAPTURE(fall);
        CHECK_FALSE(meets(fall, false));
        CHECK(meets(fall, true));
    }
    CHECK_FALSE(meets(-0.12, true));
}

namespace {

/// A notch with a ridge beyond the end of one of its edges.
/// @param tip     which vertex of the prism over an L ends the edge at the hollow's vertex 9: 8 or 10
/// @param beyond  how far the ridge crosses the edge's line beyond that end, in sizes
/// @param height  of the ridge over that line at both ends of the step, in sizes
std::optional<Meeting> beyond_notch(int tip, double beyond, double from, double to, double size)
{
    const Vec3 outwards = tip == 8 ? Vec3(-1, 0, 0) : Vec3(0, -1, 0),
               normal = (tip == 8 ? Vec3(0, 1, 1) : Vec3(1, 0, 1)).normalized();
    Mat3
        turn;  // the ridge's top, +y, comes against the normal; its edge crosses the other one at right angles
    turn << normal.cross(outwards).cross(normal), -normal, -(normal.cross(outwards));
    turn.col(0) = turn.col(1).cross(turn.col(2));
    const auto at = [&](double height) {
        return Vec3(size * (Vec3(1, 1, 1) + beyond * outwards + height * normal));
    };
    const MovingSurface notch(placed(prism_over_l(), size)),
        ridge(placed(roof(), size, Quaternion(turn), at(from)), at(to) - at(from));
    return meeting_of(ridge, ridge.edge_between(0, 1), notch, notch.edge_between(9, tip),
                      {0.01 * size, 0.1 * size});
}

}  // namespace

TEST_CASE("edge meeting: at a notch an edge goes on, as far as a pair is deep and moves, and no further")
{
    for (const int tip : {8, 10})
        for (const double size : {0.01, 1.0, 100.0}) {
            CAPTURE(tip);
            CAPTURE(size);
            // twice the depth and a tenth of the margin ...
            CHECK(beyond_notch(tip, 0.006, -0.004, -0.004, size));
            CHECK_FALSE(beyond_notch(tip, 0.012, -0.004, -0.004, size));
            // ... and the path
            CHECK(beyond_notch(tip, 0.012, -0.004, 0.006, size));
            CHECK_FALSE(beyond_notch(tip, 0.025, -0.004, 0.006, size));
            // what passes the line beyond the end
            const auto passes = beyond_notch(tip, 0.05, 0.04, -0.04, size);
            REQUIRE(passes);
            CHECK(passes->tau == doctest::Approx(0.5));
            CHECK_FALSE(beyond_notch(tip, 0.15, 0.04, -0.04, size));
        }
}
