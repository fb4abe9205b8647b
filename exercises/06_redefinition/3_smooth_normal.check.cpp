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
