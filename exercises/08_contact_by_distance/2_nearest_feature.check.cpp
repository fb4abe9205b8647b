#include "exercises/08_contact_by_distance/2_nearest_feature.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

std::string named(const MeshFeature& feature)
{
    std::string words = "(";
    for (const int vertex : feature)
        words += (words.size() > 1 ? ", " : "") + std::to_string(vertex);
    return words + ")";
}

void expect_feature(const MeshFeature& got, const MeshFeature& expected)
{
    expect_that("the feature is " + named(expected) + "; got " + named(got), got == expected);
}

/// One pair with this normal, at this distance.
void expect_one(const SurfaceMesh& mesh, const Vec3& p, const Vec3& normal, double distance)
{
    const std::vector<PointPair> pairs = near_pairs(mesh, p, 2 * distance);
    given("a surface of ", mesh.faces.size(), " faces, the point ", readable(p));
    expect("number of pairs", pairs.size(), 1, 0);
    if (pairs.empty())
        return;
    expect("normal", pairs[0].normal, normal, 1e-9);
    expect("distance", pairs[0].distance, distance, 1e-9, "m");
    expect("nearest place", pairs[0].nearest, Vec3(p - distance * normal), 1e-9, "m");
}

int vertex_at(const SurfaceMesh& mesh, const Vec3& x)
{
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if ((mesh.vertices[v] - x).norm() < 1e-12)
            return static_cast<int>(v);
    return -1;
}

/// Two slopes that meet in the line x = 0: a valley for a positive rise, a roof for a negative one.
SurfaceMesh fold(double rise)
{
    return {{{-1, rise, -1}, {-1, rise, 1}, {0, 0, -1}, {0, 0, 1}, {1, rise, -1}, {1, rise, 1}},
            {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 5}}};
}

/// A ball some of whose vertices are pressed in or pulled out.
SurfaceMesh bumpy_ball()
{
    SurfaceMesh ball = sphere(1, 2);
    RandomInputs random(5);
    for (Vec3& x : ball.vertices)
        x *= random.number(0.85, 1.15);
    return ball;
}

int with_directions(const SurfaceMesh& mesh)
{
    int count = 0;
    for (int vertex = 0; vertex < static_cast<int>(mesh.vertices.size()); ++vertex)
        count += has_directions(mesh, vertex) ? 1 : 0;
    return count;
}

}  // namespace

TEST_CASE("feature: the corners with a weight, ascending")
{
    given("face (7, 2, 5), weights (0.2, 0.3, 0.5)");
    expect_feature(feature_at({7, 2, 5}, {0.2, 0.3, 0.5}), {2, 5, 7});
    given("face (7, 2, 5), weights (0.4, 0, 0.6)");
    expect_feature(feature_at({7, 2, 5}, {0.4, 0, 0.6}), {5, 7});
    given("face (7, 2, 5), weights (1e-12, 1 - 1e-12, 0)");
    expect_feature(feature_at({7, 2, 5}, {1e-12, 1 - 1e-12, 0}), {2, 7});
    given("face (7, 2, 5), weights (0, 0, 1)");
    expect_feature(feature_at({7, 2, 5}, {0, 0, 1}), {5});
}

TEST_CASE("locally nearest: a place on the ridge of a roof is, one at the bottom of a valley is not")
{
    const SurfaceMesh roof = fold(-1), valley = fold(1);
    const Vec3 above(0.1, 0.5, 0.2);  // nearest to the ridge
    given("a roof of 90 degrees with its ridge from (0, 0, -1) to (0, 0, 1), the point ", readable(above));
    expect_that("the ridge is locally nearest", is_locally_nearest(roof, {2, 3}, above, std::sqrt(0.26)));
    given("a valley of 90 degrees with its bottom from (0, 0, -1) to (0, 0, 1), the point (0, 1, 0.5)");
    expect_that("the bottom is not", !is_locally_nearest(valley, {2, 3}, {0, 1, 0.5}, 1));
    expect_that("its left side is", is_locally_nearest(valley, {0, 1, 2}, {0, 1, -0.2}, std::sqrt(0.5)));
    given("the same valley, the end of its bottom (0, 0, 1), the point (0, 0.1, 1.5)");
    expect_that("the end of its bottom is not",
                !is_locally_nearest(valley, {3}, {0, 0.1, 1.5}, std::hypot(0.1, 0.5)));
}

TEST_CASE("pairs: what is flat is flat, however a side is cut into triangles")
{
    for (const int cells : {1, 2, 4}) {
        const SurfaceMesh block = box(Vec3(2, 2, 2), {cells, cells, cells});
        for (const Vec3& p :
             {Vec3(0.3, 1.25, 0.2), Vec3(0.5, 1.25, 0.5), Vec3(0, 1.25, 0), Vec3(-0.5, 1.25, 0)})
            expect_one(block, p, Vec3::UnitY(), 0.25);
    }
    for (const GridDiagonals cut :
         {GridDiagonals::same, GridDiagonals::alternating, GridDiagonals::crossed}) {
        const SurfaceMesh sheet = plane_grid(4, 4, {4, 4}, cut);
        for (const Vec3& p : {Vec3(0.5, 0.25, 0.5), Vec3(1, 0.25, 1), Vec3(0.25, 0.25, -0.75)}) {
            expect_one(sheet, p, Vec3::UnitY(), 0.25);
            expect_one(sheet, p - Vec3(0, 0.5, 0), -Vec3::UnitY(), 0.25);
        }
    }
}

TEST_CASE("pairs: beyond an edge and a corner of a cube the normal leads from point to point")
{
    const SurfaceMesh cube = box(Vec3::Ones());
    expect_one(cube, {0.5 + 0.3, 0.5 + 0.4, 0.1}, {0.6, 0.8, 0}, 0.5);
    expect_one(cube, {0.5 + 0.2, -0.5 - 0.2, 0.5 + 0.1}, Vec3(2, -2, 1) / 3, 0.3);
    const auto pairs = near_pairs(cube, {0.7, 0.7, 0.1}, 1);
    const int end = vertex_at(cube, {0.5, 0.5, -0.5}), other = vertex_at(cube, {0.5, 0.5, 0.5});
    given("a cube of 1 m, the point (0.7, 0.7, 0.1)");
    if (!pairs.empty())
        expect_feature(pairs[0].feature, {std::min(end, other), std::max(end, other)});
    expect("number of pairs", pairs.size(), 1, 0);
}

TEST_CASE("pairs: in a valley both sides have one, and its bottom has none")
{
    const SurfaceMesh valley = fold(1);
    const auto pairs = near_pairs(valley, {0.1, 0.9, 0.1}, 1);
    given("a valley of 90 degrees with its bottom along z, the point (0.1, 0.9, 0.1)");
    expect("number of pairs", pairs.size(), 2, 0);
    if (pairs.size() == 2) {
        expect("first normal", pairs[0].normal, Vec3(1, 1, 0).normalized(), 1e-9);
        expect("second normal", pairs[1].normal, Vec3(-1, 1, 0).normalized(), 1e-9);
        expect("first distance", pairs[0].distance, 1 / std::sqrt(2), 1e-9, "m");
        expect("second distance", pairs[1].distance, 0.8 / std::sqrt(2), 1e-9, "m");
    }
    given("the same, and only up to 0.6 m");
    expect("number of pairs", near_pairs(valley, {0.1, 0.9, 0.1}, 0.6).size(), 1, 0);
    given("the same, and only up to 0.5 m");
    expect("number of pairs", near_pairs(valley, {0.1, 0.9, 0.1}, 0.5).size(), 0, 0);
}

TEST_CASE("pairs: the nearest place of all is among them, and beside each the surface is farther away")
{
    const SurfaceMesh ball = bumpy_ball();
    RandomInputs random(6);
    int most = 0;
    double off_length = 0, off_place = 0, off_least = 0;
    bool any_nearer = false;
    for (int trial = 0; trial < 40; ++trial) {
        const Vec3 p = random.number(1.2, 1.6) * random.direction();
        double least = 10;
        for (int face = 0; face < static_cast<int>(ball.faces.size()); ++face)
            least = std::min(least, closest_on_face(ball, face, p).distance);
        const auto pairs = near_pairs(ball, p, 1);
        double found = 10;
        for (const PointPair& pair : pairs) {
            found = std::min(found, pair.distance);
            off_length = std::max(off_length, std::abs(pair.normal.norm() - 1));
            off_place = std::max(off_place, (pair.nearest + pair.distance * pair.normal - p).norm());
            for (const int face : faces_at(ball, pair.feature)) {
                const auto [a, b, c] = ball.faces[static_cast<std::size_t>(face)];
                const Vec3 middle = (position(ball, a) + position(ball, b) + position(ball, c)) / 3;
                any_nearer = any_nearer ||
                             (lerp(pair.nearest, middle, 1e-3) - p).norm() < pair.distance - 1e-9;
            }
        }
        off_least = std::max(off_least, std::abs(found - least));
        most = std::max(most, static_cast<int>(pairs.size()));
    }
    given("a bumpy ball of 320 faces, 40 points around it; the worst of them");
    expect("length of a normal less 1", off_length, 0, 1e-9);
    expect("nearest place + distance x normal, from the point", off_place, 0, 1e-9, "m");
    expect_that("a little beside a nearest place the surface is not nearer", !any_nearer);
    expect("least distance of the pairs, off the least of all faces", off_least, 0, 1e-12, "m");
    say("around a bumpy ball a point has up to ", most, " pairs");
}

TEST_CASE("ridges: a corner of a cube has three, a vertex on its edge two, one inside a side none")
{
    const SurfaceMesh cube = box(Vec3(2, 2, 2), {2, 2, 2});
    const auto expect_ridges = [&](const Vec3& x, int expected) {
        given("a cube of 2 m, each side cut into four cells; its vertex ", readable(x));
        expect("ridges", ridges_at(cube, vertex_at(cube, x)), expected, 0);
        expect_that(expected > 2 ? "it has directions of its own" : "it has no directions of its own",
                    has_directions(cube, vertex_at(cube, x)) == (expected > 2));
    };
    expect_ridges({1, 1, 1}, 3);
    expect_ridges({-1, 1, -1}, 3);
    expect_ridges({1, 0, 1}, 2);
    expect_ridges({0, 1, 0}, 0);
}

TEST_CASE("ridges: valleys do not count, and of a flat dent not even its bottom can touch")
{
    SurfaceMesh cube = box(Vec3(2, 2, 2), {2, 2, 2});
    const int middle = vertex_at(cube, {0, 1, 0});
    cube.vertices[static_cast<std::size_t>(middle)].y() = 0.5;
    given("a cube of 2 m with a dent: the vertex in the middle of its upper side is 0.5 m lower");
    expect("ridges at the bottom of the dent", ridges_at(cube, middle), 0, 0);
    expect_that("it has no directions of its own", !has_directions(cube, middle));
    cube.vertices[static_cast<std::size_t>(middle)].y() = 1.2;
    given("a cube of 2 m with a hill: the vertex in the middle of its upper side is 0.2 m higher");
    expect_that("it has directions of its own", has_directions(cube, middle));
}

TEST_CASE("ridges: of a cube only the corners are left, of a ball all vertices, of a bumpy one some")
{
    for (const int cells : {1, 3}) {
        given("a cube, each side cut into ", cells * cells, " cells");
        expect("vertices with directions", with_directions(box(Vec3::Ones(), {cells, cells, cells})), 8, 0);
    }
    for (const double radius : {1e-3, 1.0, 100.0}) {
        given("a ball of 162 vertices, radius ", radius, " m");
        expect("vertices with directions", with_directions(sphere(radius, 2)), 162, 0);
    }
    const SurfaceMesh cube = box(Vec3::Ones(), {3, 3, 3}), ball = bumpy_ball();
    say("a cube of ", cube.vertices.size(), " vertices: ", with_directions(cube),
        " can touch; a bumpy ball of ", ball.vertices.size(), ": ", with_directions(ball));
}
