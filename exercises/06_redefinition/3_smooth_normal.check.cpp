#include "exercises/06_redefinition/3_smooth_normal.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"

#include <cmath>
#include <numbers>

namespace enduring {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Still {
    SurfaceMesh mesh;
    SurfaceTopology topology{static_cast<int>(mesh.vertices.size()), mesh.faces};
    SurfaceMoment surface() const { return {{topology, mesh.vertices, mesh.vertices}, 0}; }
};

/// The face of a sphere-like mesh that a ray from the centre meets, and the weights there.
std::pair<int, std::array<double, 3>> hit(const Still& ball, const Vec3& direction)
{
    for (int face = 0; face < static_cast<int>(ball.mesh.faces.size()); ++face) {
        Mat3 corners;
        for (int i = 0; i < 3; ++i)
            corners.col(i) =
                ball.mesh
                    .vertices[ball.mesh.faces[static_cast<std::size_t>(face)][static_cast<std::size_t>(i)]];
        const Vec3 w = corners.inverse() * direction;
        if (w.minCoeff() >= -1e-12)
            return {face, {w.x() / w.sum(), w.y() / w.sum(), w.z() / w.sum()}};
    }
    throw std::logic_error("no face in that direction");
}

}  // namespace

TEST_CASE("vertex: at a cube's corner it looks along the diagonal, however the sides are cut")
{
    const Still cube{box({2, 2, 2})};
    for (int vertex = 0; vertex < 8; ++vertex) {
        given("corner ", vertex, " of a cube whose sides are two triangles each");
        expect("normal", vertex_normal(cube.surface(), vertex), Vec3(cube.mesh.vertices[vertex].normalized()),
               1e-12);
    }
}

TEST_CASE("vertex: a large side has no more to say than a small one")
{
    const Still plank{box({1, 0.2, 5})};
    for (int vertex = 0; vertex < 8; ++vertex) {
        given("corner ", vertex, " of a plank of 1 by 0.2 by 5 m");
        const Vec3 out = plank.mesh.vertices[vertex].cwiseSign();
        expect("normal", vertex_normal(plank.surface(), vertex), Vec3(out.normalized()), 1e-12);
    }
}

TEST_CASE("vertex: on a slope all normals are the slope's")
{
    Still hill{plane_grid(2, 2, {3, 3}, GridDiagonals::crossed)};
    for (Vec3& x : hill.mesh.vertices)
        x.y() = 0.75 * x.x();
    given("a grid on the slope y = 0.75 x");
    for (int vertex = 0; vertex < hill.topology.vertex_count(); ++vertex)
        expect("normal", vertex_normal(hill.surface(), vertex), Vec3(-0.6, 0.8, 0), 1e-12);
}

TEST_CASE("vertex: a regular tip looks along its axis, of however many faces and in whichever direction")
{
    for (const int count : {3, 7, 16})
        for (const Vec3& axis : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0.6, 0, -0.8)}) {
            const Vec3 across = axis.unitOrthogonal(), other = axis.cross(across);
            Still tip{{{Vec3::Zero()}, {}}};
            for (int i = 0; i < count; ++i) {
                const double turn = 2 * std::numbers::pi * i / count;
                tip.mesh.vertices.push_back(std::cos(turn) * across + std::sin(turn) * other - 0.7 * axis);
                tip.mesh.faces.push_back({0, 1 + i, 1 + (i + 1) % count});
            }
            tip.topology = SurfaceTopology(count + 1, tip.mesh.faces);
            given("a tip of ", count, " equal faces around the axis ", readable(axis));
            expect("normal", vertex_normal(tip.surface(), 0), axis, 1e-12);
        }
}

TEST_CASE("vertex: a face without area says nothing")
{
    const std::vector<Vec3> tip{Vec3(0, 0, 0), Vec3(1, -1, 0), Vec3(-0.5, -1, -0.8), Vec3(-0.5, -1, 0.8)};
    const Still three{{tip, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}}};
    std::vector<Vec3> twice = tip;
    twice.push_back(tip[3]);
    const Still four{{twice, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}}};
    given("a tip of three faces, and the same with a fourth face between two vertices at one place");
    expect("normal", vertex_normal(four.surface(), 0), vertex_normal(three.surface(), 0), 1e-12);
}

TEST_CASE("size: normals are the same from micrometres to kilometres")
{
    Still unit{sphere(1, 1)};
    for (Vec3& x : unit.mesh.vertices)
        x.x() *= 1.7;  // so that angles differ
    for (const double size : {1e-6, 1e-3, 1e3}) {
        Still sized = unit;
        for (Vec3& x : sized.mesh.vertices)
            x *= size;
        for (const int face : {0, 11, 37}) {
            given("face ", face, " of an egg of ", size, " m, at the weights 0.2, 0.3 and 0.5");
            expect("normal", smooth_normal(sized.surface(), face, {0.2, 0.3, 0.5}),
                   smooth_normal(unit.surface(), face, {0.2, 0.3, 0.5}), 1e-9);
        }
    }
}

TEST_CASE("moment: of a surface that moves in the step it is the shape at the moment that counts")
{
    const Still start{sphere(1, 1)};
    std::vector<Vec3> end = start.mesh.vertices;
    for (Vec3& x : end)
        x = Vec3(3 * x.x(), x.y() + x.x(), x.z());
    for (const double tau : {0.25, 1.0}) {
        Still now = start;
        for (std::size_t i = 0; i < end.size(); ++i)
            now.mesh.vertices[i] = (1 - tau) * start.mesh.vertices[i] + tau * end[i];
        const SurfaceMoment moving{{start.topology, start.mesh.vertices, end}, tau};
        for (int vertex = 0; vertex < start.topology.vertex_count(); vertex += 5) {
            given("vertex ", vertex, " of a ball that is stretched and sheared in the step, at tau ", tau);
            expect("normal", vertex_normal(moving, vertex), vertex_normal(now.surface(), vertex), 1e-12);
        }
    }
}

TEST_CASE("vertex: each face counts by its angle, wide or narrow")
{
    // Two faces at one edge: across it, one has a right angle and the other any.
    for (const double degrees : {10.0, 60.0, 120.0, 170.0}) {
        const double turn = degrees * degree;
        const Still book{
            {{Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(2, 0, 0), Vec3(0, 3 * std::sin(turn), 3 * std::cos(turn))},
             {{0, 1, 2}, {0, 3, 1}}}};
        given("a vertex with an angle of 90 degrees in the face y = 0 and one of ", degrees,
              " degrees in the face x = 0");
        // The first looks to +y, the second to +x.
        expect("normal", vertex_normal(book.surface(), 0), Vec3(degrees, 90, 0).normalized().eval(), 1e-12);
    }
}

TEST_CASE("smooth: the vertices' normals are mixed by just the weights")
{
    const Still plank{box({1, 0.2, 5})};
    const std::array<double, 3> weights{0.1, 0.25, 0.65};
    for (int face = 0; face < 12; ++face) {
        Vec3 mixed = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            mixed += weights[i] * plank.mesh.vertices[plank.mesh.faces[static_cast<std::size_t>(face)][i]]
                                      .cwiseSign()
                                      .normalized();
        given("face ", face, " of a plank, at the weights 0.1, 0.25 and 0.65");
        expect("normal", smooth_normal(plank.surface(), face, weights), Vec3(mixed.normalized()), 1e-12);
    }
}

TEST_CASE("smooth: on an edge both of its faces say the same")
{
    const Still ball{sphere(1, 1)};
    for (int edge = 0; edge < static_cast<int>(ball.topology.edges().size()); edge += 3) {
        const auto [v0, v1] = ball.topology.edges()[edge];
        const auto [one, other] = ball.topology.faces_at_edge(edge);
        const auto on = [&](int face) {
            std::array<double, 3> weights{};
            for (std::size_t i = 0; i < 3; ++i)
                weights[i] = ball.topology.faces()[face][i] == v0   ? 0.3
                             : ball.topology.faces()[face][i] == v1 ? 0.7
                                                                    : 0;
            return smooth_normal(ball.surface(), face, weights);
        };
        given("a point on edge ", edge, " of a sphere, asked of both faces");
        expect("normal of the one against the other", on(one), on(other), 1e-12);
        expect("length", on(one).norm(), 1.0, 1e-12);
    }
}

TEST_CASE("smooth: at a vertex it is the vertex', in the middle of a face the mean of three")
{
    const Still cube{box({2, 2, 2})};
    const Face& face = cube.mesh.faces[0];
    given("face 0 of a cube");
    expect("at its first corner", smooth_normal(cube.surface(), 0, {1, 0, 0}),
           vertex_normal(cube.surface(), face[0]), 1e-12);
    Vec3 mean = Vec3::Zero();
    for (const int corner : face)
        mean += cube.mesh.vertices[corner].normalized();
    expect("in its middle", smooth_normal(cube.surface(), 0, {1 / 3.0, 1 / 3.0, 1 / 3.0}),
           Vec3(mean.normalized()), 1e-12);
}

TEST_CASE("leap: it is the largest angle between neighbours, small ones and wide ones")
{
    const auto at = [](double degrees) {
        return Vec3(std::cos(degrees * degree), std::sin(degrees * degree), 0);
    };
    const std::vector<Vec3> path = {at(0), at(10), at(-25), at(-20)}, tiny = {at(0), at(1e-6)},
                            wide = {at(0), at(170)};
    given("directions at 0, 10, -25 and -20 degrees");
    expect("largest leap", largest_leap(path) / degree, 35.0, 1e-9, "degrees");
    given("two directions a millionth of a degree apart");
    expect("largest leap", 1e6 * largest_leap(tiny) / degree, 1.0, 1e-6, "millionths of a degree");
    given("two directions 170 degrees apart");
    expect("largest leap", largest_leap(wide) / degree, 170.0, 1e-9, "degrees");
}

TEST_CASE("leap: the first and the last pair count as all others, but the path is no ring")
{
    const auto at = [](double degrees) {
        return Vec3(0, std::cos(degrees * degree), std::sin(degrees * degree));
    };
    const std::vector<Vec3> first = {at(0), at(30), at(40), at(45)}, last = {at(0), at(5), at(8), at(38)},
                            open = {at(0), at(10), at(20), at(30), at(40)};
    given("directions at 0, 30, 40 and 45 degrees");
    expect("largest leap", largest_leap(first) / degree, 30.0, 1e-9, "degrees");
    given("directions at 0, 5, 8 and 38 degrees");
    expect("largest leap", largest_leap(last) / degree, 30.0, 1e-9, "degrees");
    given("directions at 0, 10, 20, 30 and 40 degrees");
    expect("largest leap", largest_leap(open) / degree, 10.0, 1e-9, "degrees");
}

TEST_CASE("leap: a single normal has none, nor has an empty list")
{
    const std::vector<Vec3> one = {Vec3::UnitX()}, none;
    given("one direction");
    expect("largest leap", largest_leap(one), 0.0, 0, "rad");
    given("an empty list of directions");
    expect("largest leap", largest_leap(none), 0.0, 0, "rad");
}

TEST_CASE("path: along a sphere the faces' normals leap and the smooth one does not")
{
    const Still ball{sphere(1, 2)};
    std::vector<Vec3> of_faces, smooth;
    for (int i = 0; i <= 400; ++i) {
        const double turn = i * 0.25 * degree;
        const auto [face, weights] = hit(ball, Vec3(std::cos(turn), 0.2, std::sin(turn)));
        of_faces.push_back(ball.surface().face_normal(face).normalized());
        smooth.push_back(smooth_normal(ball.surface(), face, weights));
    }
    given("400 steps of a quarter degree along a sphere of 320 faces");
    expect_that("the smooth normal never leaps by more than half a degree",
                largest_leap(smooth) < 0.5 * degree);
    expect_that("the faces' normals leap by more than 5 degrees", largest_leap(of_faces) > 5 * degree);
    say("along a sphere's side: largest leap of the faces' normals ", largest_leap(of_faces) / degree,
        " degrees, of the smooth one ", largest_leap(smooth) / degree, " degrees");
}

}  // namespace enduring
