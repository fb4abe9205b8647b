#include "exercises/09_deep_contacts/91_solid_angle.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

const double pi = 4 * std::atan(1.0);

SurfaceMesh moved(SurfaceMesh mesh, const Vec3& by)
{
    for (Vec3& x : mesh.vertices)
        x += by;
    return mesh;
}

SurfaceMesh inside_out(SurfaceMesh mesh)
{
    for (Face& face : mesh.faces)
        std::swap(face[1], face[2]);
    return mesh;
}

SurfaceMesh both(SurfaceMesh one, const SurfaceMesh& other)
{
    const int behind = static_cast<int>(one.vertices.size());
    one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.faces)
        one.faces.push_back({a + behind, b + behind, c + behind});
    return one;
}

}  // namespace

TEST_CASE("solid angle: a side of a cube is a sixth of all directions from its middle, an octant an eighth")
{
    const double half = 0.7;
    given("the side x = ", half, " m of a cube around the origin, cut into two triangles");
    const Vec3 a(half, -half, -half), b(half, half, -half), c(half, half, half), d(half, -half, half);
    expect("solid angle", solid_angle(a, b, c, Vec3::Zero()) + solid_angle(a, c, d, Vec3::Zero()), 4 * pi / 6,
           1e-12, "sr");
    given("the triangle between the ends of the three unit vectors, from the origin");
    expect("solid angle", solid_angle(Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3::Zero()), 4 * pi / 8,
           1e-12, "sr");
}

TEST_CASE(
    "solid angle: it grows beyond half of all directions' half, changes its sign with the face, and knows no size")
{
    const double near = 0.01;
    const Vec3 a(1, -0.5, near), b(0, 1, near), c(-1, -0.5, near);
    given("a triangle of about 2 m that a point sees from a distance of ", near, " m");
    const double seen = solid_angle(a, b, c, Vec3::Zero());
    expect_that("it covers nearly half of all directions", seen > 1.9 * pi && seen < 2 * pi);
    expect("the same with its corners the other way round", solid_angle(a, c, b, Vec3::Zero()), -seen, 1e-12,
           "sr");
    expect("the same, a thousand times as large", solid_angle(1000 * a, 1000 * b, 1000 * c, Vec3::Zero()),
           seen, 1e-12, "sr");
    expect("the same, elsewhere",
           solid_angle(a + Vec3(3, 1, 2), b + Vec3(3, 1, 2), c + Vec3(3, 1, 2), Vec3(3, 1, 2)), seen, 1e-9,
           "sr");
}

TEST_CASE("winding: 1 in a body, 0 beside it, 2 in two of them, and 0 in a hollow")
{
    const double size = 1.3;
    const SurfaceMesh block = box(Vec3(size, size, size), {2, 2, 2});
    RandomInputs random(91);
    double off = 0, off_twice = 0, off_hollow = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Vec3 inner = random.point(-0.24 * size, 0.24 * size),
                   outer = (0.9 * size + 0.2 * random.number(0, 1)) * random.direction();
        off = std::max({off, std::abs(winding(block, inner) - 1), std::abs(winding(block, outer))});
        off_twice = std::max(off_twice,
                             std::abs(winding(both(block, moved(block, {0.2 * size, 0, 0})), inner) - 2));
        off_hollow = std::max(
            off_hollow,
            std::abs(winding(both(block, inside_out(box(Vec3(size, size, size) / 2, {1, 1, 1}))), inner)));
    }
    given("a cube of ", size, " m, 60 places inside and 60 outside; the worst of them");
    expect("winding, off 1 and 0", off, 0, 1e-9);
    expect("winding in a cube and a second one that is shifted by a fifth, off 2", off_twice, 0, 1e-9);
    expect("winding in the hollow of a cube, off 0", off_hollow, 0, 1e-9);
}

TEST_CASE("inside: the vertices of a cube in a ball, and no other")
{
    const double radius = 1.0;
    const double shift = 0.6;
    const SurfaceMesh ball = sphere(radius, 3), block = moved(box(Vec3::Ones(), {3, 3, 3}), {shift, 0, 0});
    std::vector<int> expected;
    double nearest = 1;
    for (std::size_t v = 0; v < block.vertices.size(); ++v) {
        nearest = std::min(nearest, std::abs(block.vertices[v].norm() - radius));
        if (block.vertices[v].norm() < radius)
            expected.push_back(static_cast<int>(v));
    }
    given("a ball of ", radius, " m, and a cube of 1 m with its middle ", shift,
          " m beside that of the ball");
    if (nearest > 0.01 * radius)  // the ball of triangles lies up to half a percent inside the round one
        expect_that("the vertices nearer than the radius, ascending",
                    vertices_inside(block, ball) == expected);
    expect_that("none of the cube far away", vertices_inside(moved(block, {5, 0, 0}), ball).empty());
}

TEST_CASE("inside: beams that cross have no vertex inside, and middles of edges")
{
    const double length = 2.0;
    const SurfaceMesh beam = box(Vec3(length, 0.2, 0.2), {1, 1, 1}),
                      other = moved(box(Vec3(0.2, 0.2, length), {1, 1, 1}), {0, 0.1, 0});
    given("two beams of ", length, " m that cross in their middles, one 10 cm higher");
    expect("vertices of the one in the other", vertices_inside(beam, other).size(), 0, 0);
    const auto middles = middles_inside(beam, other);
    double highest = 1, farthest = 0;
    for (const Vec3& middle : middles) {
        highest = std::min(highest, middle.y());
        farthest = std::max(farthest, std::max(std::abs(middle.x()), std::abs(middle.z())));
    }
    expect("middles of its edges in the other", middles.size(), 3, 0);
    expect_that("they are the upper ones, in the middle of the beam", highest > 0.05 && farthest < 0.11);
    say(middles.size(), " middles of edges are inside, and no vertex");
}
