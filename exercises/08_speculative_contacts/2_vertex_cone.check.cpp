#include "exercises/08_speculative_contacts/2_vertex_cone.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>

using namespace enduring;

namespace {

SurfaceMesh grid_with(double (*height)(double x, double z))
{
    SurfaceMesh mesh = plane_grid(2, 2, {2, 2});
    for (Vec3& x : mesh.vertices)
        x.y() = height(x.x(), x.z());
    return mesh;
}

constexpr int middle = 4;  // of the grid

}  // namespace

TEST_CASE("neighbours: who shares a face, each once, in order")
{
    const SurfaceMesh mesh{std::vector<Vec3>(6, Vec3::Zero()), {{0, 1, 2}, {0, 2, 4}, {3, 4, 5}, {5, 0, 1}}};
    const auto expect_list = [&](int vertex, const std::vector<int>& expected) {
        const std::vector<int> got = neighbours_of(mesh, vertex);
        given("faces (0, 1, 2), (0, 2, 4), (3, 4, 5), (5, 0, 1); vertex ", vertex);
        expect("number of neighbours", got.size(), expected.size(), 0);
        expect_that("they are the right ones, ascending", got == expected);
    };
    expect_list(0, {1, 2, 4, 5});
    expect_list(3, {4, 5});
    expect_list(2, {0, 1, 4});
}

TEST_CASE("worst sine: that of the neighbour which is farthest before the plane, in any size")
{
    for (const double scale : {1e-3, 1.0, 100.0}) {
        // Neighbours of the origin: along x, and 30 degrees above and 45 degrees below the plane of x and z.
        SurfaceMesh mesh{{{0, 0, 0}, {5, 0, 0}, {0, std::sqrt(3) / 3, 1}, {-2, -2, 0}},
                         {{0, 2, 1}, {0, 3, 2}}};
        for (Vec3& x : mesh.vertices)
            x *= scale;
        given("neighbours at ", scale, " times (5, 0, 0), (0, 0.577, 1) and (-2, -2, 0)");
        expect("sine along y", worst_sine(mesh, 0, Vec3::UnitY()), 0.5, 1e-9);
        expect("sine along -y", worst_sine(mesh, 0, -Vec3::UnitY()), std::sqrt(0.5), 1e-9);
        expect("sine along (0.6, 0.8, 0)", worst_sine(mesh, 0, {0.6, 0.8, 0}), 0.6, 1e-9);
        expect("sine along -z", worst_sine(mesh, 0, -Vec3::UnitZ()), 0, 1e-9);
    }
    const SurfaceMesh cube = box(Vec3::Ones());
    given("corner (-0.5, -0.5, -0.5) of a cube");
    expect("sine along (-1, -1, -1), all behind", worst_sine(cube, 0, Vec3(-1, -1, -1).normalized()),
           -std::sqrt(1.0 / 3), 1e-9);
}

TEST_CASE("cone: of a convex body it has a vertex just where this lies farthest along the direction")
{
    RandomInputs random(1);
    for (const SurfaceMesh& mesh : {box({1, 2, 0.3}), sphere(0.5, 1), tetrahedron(1)})
        for (int trial = 0; trial < 50; ++trial) {
            const Vec3 direction = random.direction();
            std::size_t farthest = 0;
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
                if (mesh.vertices[v].dot(direction) > mesh.vertices[farthest].dot(direction))
                    farthest = v;
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
                const bool got = in_cone(mesh, static_cast<int>(v), direction, 0);
                given("a body of ", mesh.vertices.size(), " vertices, vertex ", v, ", direction ",
                      readable(direction));
                if (got != (v == farthest)) {
                    expect_that("it is in the cone just if no vertex lies farther along the direction",
                                false);
                    return;
                }
            }
        }
}

TEST_CASE("cone: the sine says how far a neighbour may pass")
{
    const SurfaceMesh cube = box(Vec3::Ones());
    const Vec3 corner = cube.vertices[0];
    for (const double lean : {0.05, 0.19, 0.21, 0.5}) {
        const Vec3 direction(lean, -std::sqrt(1 - lean * lean), 0);  // one edge rises before the plane
        given("corner ", readable(corner), " of a cube, direction ", readable(direction), ", sine 0.2");
        expect_that(lean < 0.2 ? "it is in the cone" : "it is not in the cone",
                    in_cone(cube, 0, direction, 0.2) == (lean < 0.2));
    }
}

TEST_CASE("cone: of a flat surface only the outer side is in it")
{
    const SurfaceMesh flat = grid_with([](double, double) { return 0.0; });
    given("a flat grid that faces up");
    expect_that("up is in the cone", in_cone(flat, middle, Vec3::UnitY(), 1e-9));
    expect_that("down is not", !in_cone(flat, middle, -Vec3::UnitY(), 1e-9));
    expect_that("up is in the cone with a sine of 0: no neighbour passes",
                in_cone(flat, middle, Vec3::UnitY(), 0));
    const SurfaceMesh cube = box(Vec3::Ones(), {2, 2, 2});
    for (std::size_t v = 0; v < cube.vertices.size(); ++v)
        if (const Vec3& place = cube.vertices[v]; std::abs(place.norm() - 0.5) < 1e-9) {
            given("the middle of a side of a closed cube, at ", readable(place));
            expect_that("out is in the cone", in_cone(cube, static_cast<int>(v), place.normalized(), 1e-9));
            expect_that("in is not, though another side of the cube looks that way",
                        !in_cone(cube, static_cast<int>(v), -place.normalized(), 1e-9));
        }
}

TEST_CASE("a direction: hills have one, flat ground has one, hollows and saddles have none")
{
    const SurfaceMesh hill = grid_with([](double x, double z) { return -0.2 * (x * x + z * z); }),
                      hollow = grid_with([](double x, double z) { return 0.2 * (x * x + z * z); }),
                      saddle = grid_with([](double x, double z) { return 0.3 * (x * x - z * z); }),
                      shallow = grid_with([](double x, double z) { return 0.02 * (x * x + z * z); }),
                      flat = grid_with([](double, double) { return 0.0; });
    const auto expect_one = [](const std::string& name, const SurfaceMesh& mesh, bool expected) {
        const auto direction = direction_in_cone(mesh, middle);
        given("the middle of a ", name);
        expect_that(expected ? "there is a direction" : "there is none", direction.has_value() == expected);
        if (direction && expected) {
            expect("its length", direction->norm(), 1, 1e-9);
            expect_that("it points up", direction->y() > 0);
            for (const int other : {0, 1, 2, 3, 5, 6, 7, 8}) {
                const Vec3 path =
                    (mesh.vertices[static_cast<std::size_t>(other)] - mesh.vertices[middle]).normalized();
                expect_that("every corner of the grid is behind it", path.dot(*direction) < 1e-6);
            }
        }
        return direction.has_value();
    };
    expect_one("hill", hill, true);
    expect_one("flat grid", flat, true);
    expect_one("hollow", hollow, false);
    expect_one("saddle", saddle, false);
    expect_one("shallow hollow", shallow, false);
}

TEST_CASE("a direction: every vertex of a convex body has one, and it is in its cone")
{
    int count = 0;
    for (const SurfaceMesh& mesh : {box({1, 2, 0.3}), sphere(0.5, 1), tetrahedron(1)})
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            const auto direction = direction_in_cone(mesh, static_cast<int>(v));
            given("vertex ", v, " of a convex body of ", mesh.vertices.size());
            if (!direction) {
                expect_that("there is a direction", false);
                return;
            }
            for (const Vec3& other : mesh.vertices)
                if ((other - mesh.vertices[v]).dot(*direction) > 1e-8) {
                    expect_that("no vertex lies farther along it", false);
                    return;
                }
            ++count;
        }
    say("convex bodies: ", count, " vertices, each with a direction");
}

TEST_CASE("a direction: of a bumpy ball, as many have one as can touch a plane with their neighbours")
{
    RandomInputs random(5);
    SurfaceMesh ball = sphere(1, 2);
    for (Vec3& x : ball.vertices)
        x *= random.number(0.8, 1.2);
    int with = 0;
    for (std::size_t v = 0; v < ball.vertices.size(); ++v) {
        // Slower and without a border: many directions.
        std::vector<Vec3> paths;
        for (const Face& face : ball.faces)
            if (face[0] == static_cast<int>(v) || face[1] == static_cast<int>(v) ||
                face[2] == static_cast<int>(v))
                for (const int other : face)
                    paths.emplace_back(ball.vertices[static_cast<std::size_t>(other)] - ball.vertices[v]);
        bool touches = false;
        RandomInputs directions(7);
        for (int trial = 0; trial < 20000 && !touches; ++trial) {
            const Vec3 direction = directions.direction();
            touches = direction.dot(ball.vertices[v]) > 0 &&
                      std::all_of(paths.begin(), paths.end(),
                                  [&](const Vec3& path) { return path.dot(direction) <= 0; });
        }
        const bool got = direction_in_cone(ball, static_cast<int>(v)).has_value();
        with += got;
        given("vertex ", v, " of a bumpy ball");
        if (touches && !got) {
            expect_that("there is a direction", false);
            return;
        }
    }
    say("a bumpy ball: ", with, " of ", ball.vertices.size(), " vertices have one");
}
