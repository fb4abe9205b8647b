#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/08_speculative_contacts/meeting.hpp"
#include "chapters/08_speculative_contacts/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

/// One triangle in the plane y = 0, facing up, with its middle at the origin.
SurfaceMesh triangle(double size)
{
    return placed({{{0, 0, 1}, {0.9, 0, -0.5}, {-0.9, 0, -0.5}}, {{0, 1, 2}}}, size);
}

std::optional<Meeting> meeting_of(const MovingSurface& a, int vertex, const MovingSurface& b, int face,
                                  const Reach& reach, bool known = false)
{
    return find_meeting(a.step(), vertex, b.step(), face, reach, known);
}

/// A particle that moves from one place to another one in the step, and a triangle at rest.
std::optional<Meeting> over_triangle(const Vec3& from, const Vec3& to, const Reach& reach, double size = 1,
                                     bool known = false)
{
    return meeting_of(MovingSurface(particle(from), to - from), 0, MovingSurface(triangle(size)), 0, reach,
                      known);
}

/// The walls of an L that stand at its hollow edge: the one that faces +y, and the one that faces +x.
int wall_of_l(const MovingSurface& l, const Vec3& normal, const Vec3& over)
{
    for (int face = 0; face < static_cast<int>(l.topology.faces().size()); ++face) {
        const auto foot = foot_on_face(MovingSurface(particle(over)).start(), 0, l.start(), face);
        if (l.start().face_normal(face).normalized().dot(normal) > 0.999 && foot &&
            overshoot(foot->weights) == 0)
            return face;
    }
    return -1;
}

}  // namespace

TEST_CASE("vertex meeting: what begins behind the plane of a face that turns, beside it, may still pass it")
{
    for (const double size : {1e-3, 1.0, 100.0}) {
        MovingSurface face(triangle(size));
        for (Vec3& x : face.t1)
            x.y() += 0.4 * x.x();
        const MovingSurface vertex(particle(size * Vec3(-1, -0.01, -0.3)), size * Vec3(1.2, 0, 0));
        // its height over the face's plane is -0.01 + 0.4 tau - 0.48 tau^2
        const auto meeting = meeting_of(vertex, 0, face, 0, {0.005 * size, 0.005 * size});
        CAPTURE(size);
        REQUIRE(meeting);
        CHECK(meeting->tau == doctest::Approx((0.4 + std::sqrt(0.16 - 4 * 0.48 * 0.01)) / 0.96));
    }
}

TEST_CASE("vertex meeting: near or inside at the start there is a pair, however the vertex moves then")
{
    for (const double size : {1e-3, 1.0, 100.0}) {
        const Reach reach{0.01 * size, 0.1 * size};
        for (const double height : {-0.099, -0.02, 0.0, 0.002, 0.0099})
            for (const Vec3& path : {Vec3(0, 0, 0), Vec3(0, 0.2, 0), Vec3(0.1, -0.3, 0), Vec3(3, 0, 0)}) {
                const Vec3 from(0.1 * size, height * size, 0.05 * size);
                const auto meeting = over_triangle(from, from + size * path, reach, size);
                CAPTURE(size);
                CAPTURE(height);
                CAPTURE(path.transpose());
                REQUIRE(meeting);
                CHECK(meeting->tau == 0);
                CHECK(meeting->passes == (height > 0 && height + path.y() < 0));
                CHECK(meeting->cost == doctest::Approx(std::abs(height) * size).epsilon(1e-9));
            }
        for (const double height : {-0.101, -0.5, 0.0101, 0.5}) {
            const Vec3 at(0.1 * size, height * size, 0.05 * size);
            CAPTURE(size);
            CAPTURE(height);
            CHECK_FALSE(over_triangle(at, at, reach, size));
        }
    }
}

TEST_CASE(
    "vertex meeting: where faces do not tell the outer side, both sides of a flat surface push, and no side behind a neighbour")
{
    const SurfaceMesh sheet = plane_grid(0.2, 0.2, {2, 2});
    SurfaceMesh turned = sheet, led = sheet;
    for (Face& face : turned.faces)
        std::swap(face[0], face[1]);
    led.vertices[3] += Vec3(0, 0.1, 0);  // below the middle, once the sheet is turned over
    const Quaternion over(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitX()));  // its outer side looks down
    for (const double height : {-0.002, 0.0, 0.002})
        for (const bool faces_tell : {false, true}) {
            CAPTURE(height);
            CAPTURE(faces_tell);
            const auto meets = [&](const SurfaceMesh& mesh) {
                const MovingSurface above(placed(mesh, 1, over, Vec3(0, height, 0)));
                return meeting_of(above, 4, MovingSurface(triangle(1)), 0,
                                  {.margin = 0.01, .inside = 0.1, .faces_tell = faces_tell})
                    .has_value();
            };
            CHECK(meets(sheet));
            CHECK(meets(turned) == !faces_tell);
            CHECK_FALSE(meets(led));
        }
}

TEST_CASE("vertex meeting: the weights put its foot below the vertex, at the moment that tells")
{
    const MovingSurface face(triangle(1));
    const auto foot = [&](const PairWeights& weights) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            sum -= weights[i + 1] * face.t0[i];
        return sum;
    };
    const auto at_start = over_triangle({0.1, 0.005, 0.2}, {0.3, 0.005, 0.2}, {0.01, 0.1});
    REQUIRE(at_start);
    CHECK(at_start->weights[0] == 1);
    CHECK((foot(at_start->weights) - Vec3(0.1, 0, 0.2)).norm() < 1e-12);
    const auto in_between = over_triangle({0.1, 0.5, 0.2}, {-0.1, -0.5, 0}, {0.01, 0.1});
    REQUIRE(in_between);
    CHECK((foot(in_between->weights) - Vec3(0, 0, 0.1)).norm() < 1e-9);
}

TEST_CASE("vertex meeting: what passes the face within the step has a pair, as chapter 2's query has it")
{
    Draw draw(1);
    int met = 0, missed = 0, from_below = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const double size = std::pow(10, draw.between(-3, 2)), speed = std::pow(10, draw.between(-1, 3));
        MovingSurface face(placed(triangle(size), 1, draw.turn()));
        for (Vec3& x : face.t1)
            x += 0.3 * size * draw.between(0, 1) * draw.direction();
        // Through a place near the triangle, at any moment: fast ones begin and end far away.
        const Vec3 through = 0.6 * size * draw.direction(), path = speed * size * draw.direction();
        const double moment = draw.between(-0.2, 1.2);
        const MovingSurface vertex(particle(through - moment * path), path);
        const auto height_at = [&](double tau) {
            const SurfaceMoment still{face.step(), tau};
            return still.face_normal(0).normalized().dot(SurfaceMoment{vertex.step(), tau}.position(0) -
                                                         still.position(face.topology.faces()[0][0]));
        };
        const auto touch = time_of_impact(vertex_face_step(vertex.step(), 0, face.step(), 0));
        const auto meeting = meeting_of(vertex, 0, face, 0, {0, 0});
        CAPTURE(trial);
        CAPTURE(size);
        CAPTURE(speed);
        if (!touch) {
            CHECK_FALSE(meeting);
            ++missed;
        } else if (height_at(0) > 0 && height_at(*touch - 1e-6) > 0) {
            REQUIRE(meeting);
            CHECK(meeting->passes);
            CHECK(meeting->tau == doctest::Approx(*touch).epsilon(1e-6));
            CHECK(meeting->cost == doctest::Approx(*touch).epsilon(1e-6));
            ++met;
        } else if (height_at(0) < 0) {  // it comes out, or round an edge and then in
            CHECK((!meeting || height_at(meeting->tau - 1e-6) > 0));
            ++from_below;
        }
    }
    CHECK(met > 200);
    CHECK(missed > 1000);
    CHECK(from_below > 200);
}

TEST_CASE(
    "vertex meeting: what ends near the face has a pair, farther before it none, and what comes from below none")
{
    for (const double size : {1e-3, 1.0, 100.0}) {
        const Reach reach{0.01 * size, 0.1 * size};
        const auto moves = [&](double from, double to) {
            return over_triangle(Vec3(0.1, from, 0) * size, Vec3(0, to, 0.1) * size, reach, size);
        };
        CAPTURE(size);
        REQUIRE(moves(0.7, 0.004));
        CHECK(moves(0.7, 0.004)->tau == 1);
        CHECK_FALSE(moves(0.7, 0.011));
        CHECK_FALSE(moves(-0.7, 0.004));
        CHECK_FALSE(moves(0.02, 0.7));
        CHECK_FALSE(moves(-0.7, -0.005));
    }
}

TEST_CASE("vertex meeting: beside a face there is no pair, but for a pair of the last step within a hair")
{
    const MovingSurface edge_on(triangle(1));
    const Vec3 middle = (edge_on.t0[1] + edge_on.t0[2]) / 2;  // of the edge at z = -0.5, 1.8 m long
    for (const double parts : {0.2, 0.9, 1.1, 20.0})
        for (const bool known : {false, true}) {
            const Vec3 at = middle + Vec3(0, 0.001, -parts * search_parts.hysteresis * 1.8);
            CAPTURE(parts);
            CAPTURE(known);
            CHECK(over_triangle(at, at, {0.01, 0.1}, 1, known).has_value() == (known && parts < 1));
        }
}

TEST_CASE("vertex meeting: a corner of a body pushes only what is in its normal cone")
{
    for (const double size : {1e-3, 1.0, 100.0}) {
        // A cube stands on a thin plate: its lower corners are near the upper side, and not far from the lower one.
        const MovingSurface plate(placed(box({4, 0.02, 4}), size));
        const MovingSurface cube(
            placed(box(Vec3::Ones()), size, Quaternion::Identity(), Vec3(0, 0.511, 0) * size));
        const Reach reach{0.01 * size, 0.1 * size};
        int pairs = 0;
        for (int vertex = 0; vertex < 8; ++vertex)
            for (int face = 0; face < 12; ++face) {
                if (!meeting_of(cube, vertex, plate, face, reach))
                    continue;
                CAPTURE(size);
                CAPTURE(vertex);
                CAPTURE(face);
                CHECK(plate.start().face_normal(face).y() > 0);
                CHECK(cube.t0[static_cast<std::size_t>(vertex)].y() < 0.1 * size);
                ++pairs;
            }
        CHECK(pairs >= 4);
    }
    // Its upper corners fall through a floor in the step, behind the lower ones, which push.
    const MovingSurface floor(plane_grid(4, 4, {1, 1})),
        falling(placed(box(Vec3::Ones()), 1, Quaternion::Identity(), {0.1, 0.9, 0}), Vec3(0, -3, 0));
    for (int vertex = 0; vertex < 8; ++vertex) {
        const bool is_lower = falling.t0[static_cast<std::size_t>(vertex)].y() < 0.9;
        CAPTURE(vertex);
        CHECK((meeting_of(falling, vertex, floor, 0, {0.001, 0.1}) ||
               meeting_of(falling, vertex, floor, 1, {0.001, 0.1})) == is_lower);
    }
}

TEST_CASE(
    "vertex meeting: sliding below one wall into a corner, a vertex meets the other wall beyond its rim")
{
    Draw draw(2);
    for (const double size : {1e-3, 1.0, 100.0}) {
        const Quaternion turn = draw.turn();
        const SurfaceMesh shape = prism_over_l();
        const MovingSurface plain(shape), l(placed(shape, size, turn));
        const int floor = wall_of_l(plain, Vec3::UnitY(), {1.2, 1, 0.5}),
                  wall = wall_of_l(plain, Vec3::UnitX(), {1, 1.02, 0.5});
        REQUIRE(floor >= 0);
        REQUIRE(wall >= 0);
        const auto slides = [&](double depth, double from, double to) {
            const Vec3 start(from, 1 - depth, 0.5), end(to, 1 - depth, 0.5);
            const MovingSurface vertex(particle(size * (turn * start)), size * (turn * (end - start)));
            return meeting_of(vertex, 0, l, wall, {0.001 * size, 0.1 * size});
        };
        CAPTURE(size);
        for (const double depth : {-0.01, 1e-4, 0.01, 0.05}) {
            CAPTURE(depth);
            const auto meeting = slides(depth, 1.2, 0.8);
            REQUIRE(meeting);
            CHECK(meeting->tau > 0);
            CHECK(meeting->tau == doctest::Approx(0.5).epsilon(1e-6));
            CHECK(meeting->cost == doctest::Approx(0.5).epsilon(1e-6));
            CHECK(slides(depth, 0.96, 0.95));  // and where it is as deep since the last step
        }
        CHECK_FALSE(slides(0.05, 1.2, 1.1));
        CHECK_FALSE(slides(0.5, 1.05, 0.95));  // far below its rim, by more than the vertex moves
    }
}

TEST_CASE("vertex meeting: beyond the rim of a ridge a vertex does not meet the side that ends there")
{
    const MovingSurface body(box(Vec3::Ones()));
    for (int face = 0; face < 12; ++face) {
        const Vec3 normal = body.start().face_normal(face).normalized();
        if (normal.x() < 0.9)
            continue;
        CAPTURE(face);
        for (const double over : {1e-4, 0.01, 0.1}) {
            CAPTURE(over);
            // It passes the plane of the side at x = 0.5 over its upper rim at y = 0.5.
            const MovingSurface vertex(particle({0.6, 0.5 + over, 0}), Vec3(-0.2, 0, 0));
            CHECK_FALSE(meeting_of(vertex, 0, body, face, {0.001, 0.1}));
        }
    }
}

TEST_CASE("vertex meeting: a face without area has no pair")
{
    const MovingSurface flat({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}});
    CHECK_FALSE(meeting_of(MovingSurface(particle({1, 0.001, 0})), 0, flat, 0, {0.01, 0.1}));
}

TEST_CASE("vertex meeting: how far a face goes on below its neighbour does not depend on its first corner")
{
    Draw draw(3);
    int met = 0, missed = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        SurfaceMesh valley = hinge(draw.between(0.1, 1));
        const Vec3 beside(-draw.between(0, 0.3), -draw.between(0, 0.1), draw.between(0.3, 0.7));
        const MovingSurface vertex(particle(beside), draw.between(0, 0.1) * draw.direction());
        std::vector<Vec3> paths;
        for (std::size_t i = 0; i < valley.vertices.size(); ++i)
            paths.emplace_back(draw.between(0, 0.3) * draw.direction());
        std::array<bool, 3> found{};
        for (bool& one : found) {
            MovingSurface surface(valley);
            for (std::size_t i = 0; i < paths.size(); ++i)
                surface.t1[i] += paths[i];
            one = meeting_of(vertex, 0, surface, 0, {0.01, 0.1}).has_value();
            std::rotate(valley.faces[0].begin(), valley.faces[0].begin() + 1, valley.faces[0].end());
        }
        CAPTURE(trial);
        CHECK(found[0] == found[1]);
        CHECK(found[0] == found[2]);
        ++(found[0] ? met : missed);
    }
    CHECK(met > 200);
    CHECK(missed > 200);
}

namespace {

/// Sheets of every size, turned at random: visits a point of each rim that two faces share, the faces' numbers and their normal.
template <class Visit>
void on_common_rims(Draw& draw, int sheets, const Visit& visit)
{
    for (int trial = 0; trial < sheets; ++trial) {
        const double size = std::pow(10, draw.between(-3, 2));
        const MovingSurface sheet(
            placed(plane_grid(2, 2, {1, 1}), size, draw.turn(), size * draw.direction()));
        const auto edges = sheet.topology.edges();
        for (int edge = 0; edge < static_cast<int>(edges.size()); ++edge) {
            const auto [one, other] = sheet.topology.faces_at_edge(edge);
            if (other < 0)
                continue;
            const auto [p, q] = edges[static_cast<std::size_t>(edge)];
            const Vec3 place = lerp(sheet.t0[static_cast<std::size_t>(p)],
                                    sheet.t0[static_cast<std::size_t>(q)], draw.between(0.1, 0.9));
            CAPTURE(trial);
            visit(sheet, one, other, size, place, sheet.start().face_normal(one).normalized());
        }
    }
}

}  // namespace

TEST_CASE(
    "vertex meeting: on the common rim of two faces a vertex meets one of them, however rounding turns out")
{
    Draw draw(4);
    on_common_rims(
        draw, 500,
        [](const MovingSurface& sheet, int one, int other, double size, const Vec3& place,
           const Vec3& normal) {
            const MovingSurface vertex(particle(place + 0.005 * size * normal));
            const Reach reach{0.01 * size, 0.1 * size};
            CHECK((meeting_of(vertex, 0, sheet, one, reach) || meeting_of(vertex, 0, sheet, other, reach)));
        });
}

TEST_CASE("vertex meeting: through the common rim of two faces no vertex slips, however rounding turns out")
{
    Draw draw(5);
    on_common_rims(
        draw, 2000,
        [&](const MovingSurface& sheet, int one, int other, double size, const Vec3& place,
            const Vec3& normal) {
            const Vec3 path = size * (-normal + 0.4 * draw.direction());
            const MovingSurface vertex(particle(place - draw.between(0.2, 0.8) * path), path);
            CHECK((meeting_of(vertex, 0, sheet, one, {0, 0}) || meeting_of(vertex, 0, sheet, other, {0, 0})));
        });
}
