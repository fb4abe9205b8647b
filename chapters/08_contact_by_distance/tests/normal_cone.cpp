#include "chapters/05_categorisation/category.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/feature_cones.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// The corners that share a face with one, from the list of faces alone.
std::set<int> neighbours_of(const SurfaceMesh& mesh, int vertex)
{
    std::set<int> neighbours;
    for (const Face& face : mesh.faces)
        if (std::find(face.begin(), face.end(), vertex) != face.end())
            neighbours.insert(face.begin(), face.end());
    neighbours.erase(vertex);
    return neighbours;
}

/// All neighbours behind a plane through the vertex that leans by an angle towards each, and a face that
/// looks out.
bool all_behind(const SurfaceMesh& mesh, int vertex, const Vec3& direction, double sine)
{
    const auto at = [&](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
    for (const int other : neighbours_of(mesh, vertex))
        if ((at(other) - at(vertex)).normalized().dot(direction) > sine)
            return false;
    return true;
}

}  // namespace

TEST_CASE("normal cone: the fold is the sine of the angle between two faces, positive in a valley")
{
    Draw draw(1);
    for (const double degrees : {-170.0, -90.0, -30.0, -0.01, 0.0, 0.01, 30.0, 90.0, 170.0})
        for (const double scale : {1e-3, 1.0, 100.0})
            for (const double skew : {0.0, 0.4}) {
                CAPTURE(degrees);
                CAPTURE(scale);
                CAPTURE(skew);
                const MovingSurface surface(
                    placed(hinge(degrees * degree, skew), scale, draw.turn(), scale * draw.direction()));
                CHECK(fold_at_edge(surface.start(), surface.edge_between(0, 1)) ==
                      doctest::Approx(std::sin(degrees * degree)).epsilon(1e-9));
            }
}

TEST_CASE("normal cone: a border folds as a ridge does, whatever its face")
{
    const MovingSurface surface(hinge(40 * degree));
    for (const auto& [p, q] : {std::pair(0, 2), {1, 2}, {0, 3}, {1, 3}})
        CHECK(fold_at_edge(surface.start(), surface.edge_between(p, q)) == -1);
}

TEST_CASE("normal cone: it is asked at a moment of the step, while the surface bends")
{
    MovingSurface surface(hinge(-30 * degree));
    surface.t1 = hinge(30 * degree).vertices;
    CHECK(fold_at_edge({surface.step(), 0}, 0) == doctest::Approx(-0.5));
    CHECK(fold_at_edge({surface.step(), 1}, 0) == doctest::Approx(0.5));
    CHECK(in_cone_of_edge({surface.step(), 0}, 0, Vec3::UnitY(), 1e-9, 1e-4));
    CHECK_FALSE(in_cone_of_edge({surface.step(), 1}, 0, Vec3::UnitY(), 1e-9, 1e-4));
}

TEST_CASE(
    "normal cone: a direction is in the cone of that vertex of a convex body that lies farthest along it")
{
    Draw draw(2);
    for (const double scale : {1e-3, 1.0, 100.0})
        for (const SurfaceMesh& shape : {box({1, 0.3, 2}), sphere(1, 1), tetrahedron(1)}) {
            const SurfaceMesh mesh = placed(shape, scale, draw.turn(), scale * draw.direction());
            const MovingSurface surface(mesh);
            for (int trial = 0; trial < 50; ++trial) {
                const Vec3 direction = draw.direction();
                const auto farthest = std::max_element(mesh.vertices.begin(), mesh.vertices.end(),
                                                       [&](const Vec3& one, const Vec3& other) {
                                                           return one.dot(direction) < other.dot(direction);
                                                       });
                CAPTURE(scale);
                CAPTURE(direction.transpose());
                for (int vertex = 0; vertex < surface.topology.vertex_count(); ++vertex) {
                    CAPTURE(vertex);
                    CHECK(is_foremost(surface.start(), vertex, direction, 0) ==
                          (vertex == farthest - mesh.vertices.begin()));
                }
            }
        }
}

TEST_CASE("normal cone: on any surface, all neighbours of the vertex lie behind the plane, but for the sine")
{
    Draw draw(3);
    int inside = 0;
    for (int shape = 0; shape < 20; ++shape) {
        SurfaceMesh mesh = sphere(1, 1);
        for (Vec3& x : mesh.vertices)
            x *= draw.between(0.7, 1.3);  // hills, hollows and what is between them
        const MovingSurface surface(mesh);
        for (int trial = 0; trial < 1000; ++trial) {
            const int vertex = trial % surface.topology.vertex_count();
            const double sine = trial % 3 * 0.1;
            const Vec3 direction = (mesh.vertices[static_cast<std::size_t>(vertex)].normalized() +
                                    draw.between(0, 1) * draw.direction())
                                       .normalized();
            const bool expected = all_behind(mesh, vertex, direction, sine);
            CAPTURE(shape);
            CAPTURE(trial);
            CHECK(is_foremost(surface.start(), vertex, direction, sine) == expected);
            inside += expected;
        }
    }
    CHECK(inside > 1000);
    CHECK(inside < 19000);
}

TEST_CASE("normal cone: a cube's corner takes the octant of its three normals, and the sine widens it")
{
    const SurfaceMesh mesh = box(Vec3::Ones());
    const MovingSurface surface(mesh);
    for (int vertex = 0; vertex < 8; ++vertex) {
        const Vec3 outwards = mesh.vertices[static_cast<std::size_t>(vertex)].normalized();
        CAPTURE(vertex);
        CHECK(is_foremost(surface.start(), vertex, outwards, 0));
        CHECK_FALSE(is_foremost(surface.start(), vertex, -outwards, 0.2));
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 along = Vec3::Zero(), beside = Vec3::Zero();
            along[axis] = outwards[axis] > 0 ? 1 : -1;
            beside[(axis + 1) % 3] = outwards[(axis + 1) % 3] > 0 ? 1 : -1;
            const auto leaning = [&](double sine) {  // past the octant, along the edge that leaves the corner
                return Vec3(std::sqrt(1 - sine * sine) * along - sine * beside);
            };
            CHECK(is_foremost(surface.start(), vertex, along, 0));
            CHECK_FALSE(is_foremost(surface.start(), vertex, leaning(0.1), 0));
            CHECK(is_foremost(surface.start(), vertex, leaning(0.1), 0.15));
            CHECK_FALSE(is_foremost(surface.start(), vertex, leaning(0.2), 0.15));
        }
    }
}

TEST_CASE("normal cone: the vertex of a hollow has none, and that of a saddle none but across a flat side")
{
    SurfaceMesh bowl = plane_grid(2, 2, {2, 2});
    for (Vec3& x : bowl.vertices)
        x.y() = 0.2 * x.squaredNorm();
    SurfaceMesh saddle = plane_grid(2, 2, {2, 2});
    for (Vec3& x : saddle.vertices)
        x.y() = 0.3 * (x.x() * x.x() - x.z() * x.z());
    const MovingSurface in_hollow(bowl), on_saddle(saddle), on_l(prism_over_l());
    Draw draw(4);
    for (int trial = 0; trial < 2000; ++trial) {
        const Vec3 direction = draw.direction();
        CAPTURE(direction.transpose());
        CHECK_FALSE(
            is_foremost(in_hollow.start(), 4, direction.y() > 0 ? direction : Vec3(-direction), 0.05));
        CHECK_FALSE(is_foremost(on_saddle.start(), 4, direction, 0.05));
        CHECK_FALSE(is_foremost(on_l.start(), 9, direction, 0));
    }
    CHECK(is_foremost(on_l.start(), 9, Vec3::UnitZ(), 1e-12));  // its upper side can lie on a floor
    CHECK_FALSE(is_foremost(on_l.start(), 9, Vec3(0, 1, 1).normalized(), 0.2));
}

TEST_CASE("normal cone: a particle without a surface can be pushed anywhere")
{
    const MovingSurface lone(particle({1, 2, 3}));
    Draw draw(5);
    for (int trial = 0; trial < 20; ++trial)
        CHECK(is_foremost(lone.start(), 0, draw.direction(), 0));
}

TEST_CASE("normal cone: a ridge takes the directions between its two normals, whatever their part along it")
{
    Draw draw(6);
    int inside = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const double bend = draw.between(5, 170) * degree;
        const Quaternion turn = draw.turn();
        const double scale = std::pow(10, draw.between(-3, 2));
        const MovingSurface surface(placed(hinge(-bend, draw.between(-0.4, 0.4)), scale, turn));
        // By their angle about the edge: the normals are those of 90 and of 90 + bend degrees.
        const double angle = draw.between(0, 360) * degree;
        const Vec3 across(std::cos(angle), std::sin(angle), 0);
        const Vec3 direction = turn * (across + draw.between(-0.5, 0.5) * Vec3::UnitZ()).normalized();
        const bool expected = std::numbers::pi / 2 <= angle && angle <= std::numbers::pi / 2 + bend;
        CAPTURE(bend / degree);
        CAPTURE(angle / degree);
        CHECK(in_cone_of_edge(surface.start(), surface.edge_between(0, 1), direction, 1e-9, 1e-4) ==
              expected);
        inside += expected;
    }
    CHECK(inside > 200);
}

TEST_CASE(
    "normal cone: an edge that is flat or a valley has no directions, nor one less of a ridge than asked")
{
    Draw draw(7);
    for (const double degrees : {-0.5, 0.0, 0.5, 30.0, 120.0}) {
        const MovingSurface surface(hinge(degrees * degree));
        CAPTURE(degrees);
        CHECK_FALSE(in_cone_of_edge(surface.start(), 0, Vec3::UnitY(), 0.2, 0.01));
        for (int trial = 0; trial < 200; ++trial)
            CHECK_FALSE(in_cone_of_edge(surface.start(), 0, draw.direction(), 0.2, 0.01));
    }
    const MovingSurface ridge(hinge(-0.7 * degree));
    CHECK(in_cone_of_edge(ridge.start(), 0, Vec3::UnitY(), 0.2, 0.01));
}

TEST_CASE("normal cone: the sine widens the cone of an edge on both sides")
{
    const MovingSurface surface(hinge(-90 * degree));  // normals at 90 and at 180 degrees
    const auto is_in = [&](double degrees, double sine) {
        const Vec3 direction(std::cos(degrees * degree), std::sin(degrees * degree), 0);
        return in_cone_of_edge(surface.start(), 0, direction, sine, 1e-4);
    };
    const double sine_of_10 = std::sin(10 * degree);
    CHECK(is_in(81, sine_of_10));
    CHECK_FALSE(is_in(79, sine_of_10));
    CHECK(is_in(189, sine_of_10));
    CHECK_FALSE(is_in(191, sine_of_10));
    CHECK_FALSE(is_in(81, 0));
    CHECK_FALSE(is_in(315, 0.99));  // into the body
}

TEST_CASE(
    "errata: the face normals and their average do not stand for the span of 6.2.2: a spike that meets a wall with an edge would be hooked")
{
    SurfaceMesh spike{{Vec3::Zero()}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};  // its tip is up
    for (int i = 0; i < 3; ++i) {
        const double around = 120 * degree * i;
        spike.vertices.emplace_back(std::sin(0.1) * std::cos(around), -std::cos(0.1),
                                    -std::sin(0.1) * std::sin(around));
    }
    const MovingSurface surface(spike);
    int hooked = 0;
    for (int degrees = 0; degrees < 360; degrees += 5) {
        const Vec3 wall(std::cos(degrees * degree), 0, std::sin(degrees * degree));
        hooked += is_hooked_vertex(surface.start(), 0, wall);
        CHECK(is_foremost(surface.start(), 0, -wall, distance_parts.cone_sine));
    }
    CHECK(hooked > 12);
}
