#include "chapters/08_speculative_contacts/meeting.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// Its edge 0 runs 1 m along z through the origin; both faces fall from it by this, over 1 m.
SurfaceMesh roof(double fall = 1)
{
    return {{{0, 0, -0.5}, {0, 0, 0.5}, {1, -fall, 0}, {-1, -fall, 0}}, {{0, 1, 2}, {1, 0, 3}}};
}

/// The same upside down, its edge along x, or turned about y from there.
SurfaceMesh keel(double height, double turned = 0)
{
    const Quaternion over(Eigen::AngleAxisd(std::numbers::pi, Vec3(1, 0, 1).normalized())),
        about(Eigen::AngleAxisd(turned, Vec3::UnitY()));
    return placed(roof(), 1, about * over, {0, height, 0});
}

/// From one shape to another one in the step.
MovingSurface moving(const SurfaceMesh& from, const SurfaceMesh& to)
{
    MovingSurface surface(from);
    surface.t1 = to.vertices;
    return surface;
}

std::optional<Meeting> edges_meet(const MovingSurface& a, const MovingSurface& b, bool known = false)
{
    return find_edge_meeting(a.step(), a.edge_between(0, 1), b.step(), b.edge_between(0, 1), {0.01, 0.1},
                             known);
}

}  // namespace

TEST_CASE("edge meeting: whether an edge is a ridge is asked when the other one passes it")
{
    // It passes at 0.75; the roof is flat in the middle of the step.
    const MovingSurface passes = moving(keel(0.75), keel(-0.25));
    CHECK(edges_meet(passes, moving(roof(-1), roof(1))));
    CHECK_FALSE(edges_meet(passes, moving(roof(1), roof(-1))));
    CHECK_FALSE(edges_meet(passes, moving(roof(-1), roof(-1))));
}

TEST_CASE("edge meeting: edges that a step turns until they are parallel have no pair")
{
    const double quarter = std::numbers::pi / 2;
    CHECK(edges_meet(moving(keel(0.005), keel(0.005, 0.9 * quarter)), MovingSurface(roof())));
    SurfaceMesh along = roof();  // over the first one, exactly along it
    for (Vec3& x : along.vertices)
        x.y() = 0.005 - x.y();
    for (Face& face : along.faces)
        std::swap(face[1], face[2]);
    MovingSurface turning(keel(0.005));
    for (std::size_t v = 0; v < 4; ++v)
        turning.t1[v] = along.vertices[v];
    CHECK_FALSE(edges_meet(turning, MovingSurface(roof())));
}

TEST_CASE("edge meeting: edges that lie deeper than a pair may be have none, also if they had one")
{
    const MovingSurface above(keel(-0.3)), below(roof());
    for (const bool known : {false, true})
        CHECK_FALSE(edges_meet(above, below, known));
}

TEST_CASE("vertex meeting: what counts first is near the face, and lies over it")
{
    // In an L, below the walls that meet at x = 1 and y = 1: behind the one, and beyond its rim.
    const MovingSurface l(prism_over_l()), vertex(particle({0.96, 0.95, 0.5}));
    int met = 0;
    for (int face = 0; face < static_cast<int>(l.topology.faces().size()); ++face) {
        if (l.start().face_normal(face).normalized().x() < 0.999 ||
            l.t0[static_cast<std::size_t>(l.topology.faces()[static_cast<std::size_t>(face)][0])].x() > 1.5)
            continue;
        if (const auto meeting = find_meeting(vertex.step(), 0, l.step(), face, {0.001, 0.1}, false)) {
            CHECK(meeting->cost == doctest::Approx(0.04 + 0.05));
            ++met;
        }
    }
    CHECK(met > 0);
}

TEST_CASE("vertex meeting: how far a face goes on beyond its rim does not depend on a motion of both bodies")
{
    for (const Vec3& common : {Vec3(0, 0, 0), Vec3(7, -5, 3), Vec3(-300, 20, 100)}) {
        const MovingSurface l(prism_over_l(), common);
        const auto slides = [&](double depth, double from, double to) {
            const MovingSurface vertex(particle({from, 1 - depth, 0.5}), Vec3(to - from, 0, 0) + common);
            int met = 0;
            for (int face = 0; face < static_cast<int>(l.topology.faces().size()); ++face)
                met += l.start().face_normal(face).normalized().x() > 0.999 &&
                       find_meeting(vertex.step(), 0, l.step(), face, {0.001, 0.1}, false).has_value();
            return met > 0;
        };
        CAPTURE(common.transpose());
        CHECK(slides(0.05, 1.2, 0.8));
        CHECK_FALSE(slides(0.5, 1.05, 0.95));
    }
}

TEST_CASE("vertex meeting: whether a corner is in its cone is asked when it passes the face")
{
    // The corner of a tent, which in the step turns inside out: it passes the floor at three quarters of it.
    const auto tent = [](double height, double rise) {
        SurfaceMesh mesh{{{0, height, 0}}, {}};
        for (const auto& [x, z] : {std::pair(1, 0), {0, 1}, {-1, 0}, {0, -1}})
            mesh.vertices.emplace_back(x, height + rise, z);
        for (int i = 0; i < 4; ++i)
            mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % 4});
        return mesh;
    };
    const MovingSurface floor({{{-3, 0, 3}, {3, 0, 3}, {0, 0, -4}}, {{0, 1, 2}}});
    REQUIRE(floor.start().face_normal(0).y() > 0);
    const auto meets = [&](double rise_t0, double rise_t1) {
        const MovingSurface corner = moving(tent(0.75, rise_t0), tent(-0.25, rise_t1));
        return find_meeting(corner.step(), 0, floor.step(), 0, {0.01, 0.1}, false).has_value();
    };
    CHECK(meets(-1, 1));
    CHECK_FALSE(meets(1, -1));
}

TEST_CASE("vertex meeting: in a corner of a room a face is as far off as the farther one of its two rims")
{
    SurfaceMesh room = box(Vec3::Ones());
    for (Face& face : room.faces)
        std::swap(face[1], face[2]);
    const MovingSurface inside(room);
    int met = 0;
    for (const auto& [x, z] : {std::pair(0.02, 0.03), {0.03, 0.02}})
        for (const double sx : {1.0, -1.0})
            for (const double sz : {1.0, -1.0}) {
                const MovingSurface vertex(particle({sx * (0.5 + x), -0.54, sz * (0.5 + z)}));
                for (int face = 0; face < 12; ++face)
                    if (inside.start().face_normal(face).normalized().y() > 0.999)
                        if (const auto meeting = find_meeting(vertex.step(), 0, inside.step(), face,
                                                              {0.001, 0.1}, false)) {
                            CHECK(meeting->cost == doctest::Approx(0.04 + 0.03));
                            ++met;
                        }
            }
    CHECK(met >= 4);
}
