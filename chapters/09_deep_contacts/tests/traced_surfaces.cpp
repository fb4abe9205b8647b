#include "chapters/09_deep_contacts/experiments/overlap_shape.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "chapters/09_deep_contacts/piercing.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"

#include <doctest/doctest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

/// Two boxes of 1 m, one over the other, with a gap between them, as one surface.
SurfaceMesh two_floors()
{
    SurfaceMesh mesh = box(Vec3::Ones());
    const int count = static_cast<int>(mesh.vertices.size());
    const SurfaceMesh upper = moved(box(Vec3::Ones()), {0, 2, 0});
    mesh.vertices.insert(mesh.vertices.end(), upper.vertices.begin(), upper.vertices.end());
    for (Face face : upper.faces) {
        for (int& vertex : face)
            vertex += count;
        mesh.faces.push_back(face);
    }
    return mesh;
}

}  // namespace

TEST_CASE("exit: faces are left from behind only, and of several the first one is")
{
    const OverlapShape still(two_floors());
    const Exit from_below = find_exit(still.still(), Vec3(0.1, -0.5, 0.2),
                                      Vec3::UnitY());  // on the lower side
    CHECK(from_below.distance == doctest::Approx(1));
    const Exit near_the_edge = find_exit(still.still(), Vec3(-0.45, -0.3, -0.4), Vec3::UnitY());
    CHECK(near_the_edge.distance == doctest::Approx(0.8));
    const Exit down = find_exit(still.still(), Vec3(0.2, 2.1, -0.3), -Vec3::UnitY());
    CHECK(down.distance == doctest::Approx(0.6));
    const Exit along = find_exit(OverlapShape(box({9, 1, 1})).still(), Vec3(-4.4, 0, 0.1), Vec3::UnitX());
    CHECK(along.distance == doctest::Approx(8.9));
}

TEST_CASE(
    "separation direction: where a beam goes through a plate the areas cancel, and the plate's normal is left")
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-1, 1);
    for (int trial = 0; trial < 10; ++trial) {
        const double angle = 3 * number(random), x = number(random), y = number(random), z = number(random);
        const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(x, y, z).normalized()).toRotationMatrix();
        const OverlapShape plate(turned(box({2, 0.1, 2}, {4, 1, 4}), turn)),
            beam(turned(moved(box({0.2, 3, 0.2}, {1, 6, 1}), {0.01, 0.02, 0.03}),
                        turn));  // with vertices in the plate
        CAPTURE(trial);
        const auto overlaps = find_overlaps(beam.still(), plate.still());
        REQUIRE(overlaps.size() == 1);
        CHECK(std::abs(overlaps[0].separation_direction.dot(turn * Vec3::UnitY())) > 1 - 1e-9);
    }
}

TEST_CASE("separation direction: a body that holds the other one wholly leaves it the opposite way")
{
    const OverlapShape room(box({4, 4, 4}, {3, 3, 3})), small(moved(box({0.5, 0.5, 0.5}), {1.2, 0.3, -0.2}));
    const auto from_small = find_overlaps(small.still(), room.still()),
               from_room = find_overlaps(room.still(), small.still());
    REQUIRE(from_small.size() == 1);
    REQUIRE(from_room.size() == 1);
    CHECK((from_small[0].separation_direction - Vec3::UnitX()).norm() < 1e-12);
    CHECK((from_room[0].separation_direction + Vec3::UnitX()).norm() < 1e-12);
}

TEST_CASE("tracing: an edge in the plane of a face pierces it in its middle, any other where it passes")
{
    const OverlapShape floor(box({4, 1, 4}));
    const auto point = [&](const Vec3& p, const Vec3& q) {
        const OverlapShape blade({{p, q, Vec3(0.1, 3, 0.2)}, {{0, 1, 2}}});
        int edge = 0;
        while (blade.topology().edges()[edge][0] + blade.topology().edges()[edge][1] != 1)
            ++edge;
        for (int face = 0; face < 12; ++face) {
            const auto [a, b, c] = floor.topology().faces()[face];
            const auto& x = floor.positions();
            if ((x[b] - x[a]).cross(x[c] - x[a]).normalized().y() > 0.999)
                return point_of({true, edge, face, 1}, blade.still(), floor.still());
        }
        return Vec3(Vec3::Zero());
    };
    CHECK((point({-0.3, 0.5, 0.1}, {0.7, 0.5, 0.1}) - Vec3(0.2, 0.5, 0.1)).norm() < 1e-12);
    CHECK((point({-0.3, 0.75, 0.1}, {0.7, -0.25, 0.1}) - Vec3(-0.05, 0.5, 0.1)).norm() < 1e-12);
    CHECK((point({-0.3, 0.25, 0.1}, {0.7, 1.25, 0.1}) - Vec3(-0.05, 0.5, 0.1)).norm() < 1e-12);
}

TEST_CASE("exact side: whichever coordinate decides, and however small all are, the sign is right")
{
    std::mt19937_64 random(12);
    std::uniform_int_distribution<int> digit(-3, 3);
    const auto vector = [&](const Vec3& scale) {
        const int x = digit(random), y = digit(random), z = digit(random);
        return Vec3(scale.cwiseProduct(Vec3(x, y, z)));
    };
    const Vec3 zero = Vec3::Zero();
    for (const double least :
         {1.0, std::ldexp(1.0, -110), std::ldexp(1.0, -120)})  // their products hardly exist
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 300; ++i) {
                const Vec3 ones = Vec3::Ones();
                const Vec3 x = vector(ones), v = vector(ones), w = vector(ones);
                const double determinant = x.dot(v.cross(w));  // exact: small whole numbers
                const Vec3 sx = least * x, sv = least * v, sw = least * w;
                CAPTURE(i);
                CHECK(side_of_plane({sx, zero}, {sv, zero}, {sw, zero}, 0) ==
                      (determinant > 0) - (determinant < 0));
            }
    // Next to a plane nearly at right angles to each axis in turn.
    std::uniform_real_distribution<double> unit(0.5, 1);
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 300; ++i) {
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            Vec3 v = 1e-3 * Vec3::Random(), w = v, in = Vec3::Zero();
            const double a = unit(random), b = unit(random);
            v[next] = a;
            w[last] = b;
            w[axis] = v[axis] = 0;
            v[last] = w[next] = 0;
            in[next] = unit(random);
            in[last] = unit(random);
            CHECK(side_of_plane({in, zero}, {v, zero}, {w, zero}, 0) == 0);
            in[axis] = 1e-17;
            CHECK(side_of_plane({in, zero}, {v, zero}, {w, zero}, 0) == 1);
            in[axis] = -1e-17;
            CHECK(side_of_plane({in, zero}, {v, zero}, {w, zero}, 0) == -1);
        }
}

TEST_CASE(
    "separation direction: where a beam goes through a plate with no vertex inside, it has one way, along itself")
{
    const OverlapShape plate(box({2, 0.1, 2}, {4, 1, 4})),
        beam(moved(box({0.2, 3, 0.2}, {1, 5, 1}), {0.01, 0.02, 0.03}));
    for (const auto& overlaps :
         {find_overlaps(plate.still(), beam.still()), find_overlaps(beam.still(), plate.still())}) {
        REQUIRE(overlaps.size() == 1);
        CHECK(std::abs(overlaps[0].separation_direction.y()) > 1 - 1e-9);
        CHECK(overlaps[0].curves.size() == 2);
    }
}

TEST_CASE("tracing: two triangles cross in a piece of a line, which is no closed curve")
{
    const OverlapShape one({{{-1, 0, -1}, {1, 0, -1}, {0, 0, 2}}, {{0, 1, 2}}}),
        other({{{-0.3, -1, 0.1}, {0.4, -1, 0.1}, {0.1, 1, 0.2}}, {{0, 1, 2}}});
    const Intersection intersection = trace_intersection(one.still(), other.still());
    REQUIRE(intersection.curves.size() == 1);
    CHECK(intersection.curves[0].piercings.size() == 2);
    CHECK_FALSE(intersection.curves[0].closed);
}

TEST_CASE("exact side: the bound of rounding counts all coordinates, each of which may cancel")
{
    using Rational = boost::multiprecision::cpp_rational;
    std::mt19937_64 random(13);
    std::uniform_real_distribution<double> unit(0.5, 1);
    const Vec3 zero = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < 500; ++i) {
            const int next = (axis + 1) % 3, last = (axis + 2) % 3;
            Vec3 x, v, w;
            for (Vec3* of : {&v, &w})
                for (int k = 0; k < 3; ++k)
                    (*of)[k] = unit(random);
            w[last] = v[last] * w[next] / v[next];  // along the axis their product has cancelled
            x[axis] = unit(random);
            x[next] = 1e-18 * unit(random);
            x[last] = 1e-18 * unit(random);
            const auto term = [&](int a, int b, int c) {
                return Rational(x[a]) * Rational(v[b]) * Rational(w[c]);
            };
            const Rational determinant = term(0, 1, 2) - term(0, 2, 1) + term(1, 2, 0) - term(1, 0, 2) +
                                         term(2, 0, 1) - term(2, 1, 0);
            CAPTURE(axis);
            CHECK(side_of_plane({x, zero}, {v, zero}, {w, zero}, 0) == determinant.sign());
        }
}

TEST_CASE("exit: a path leaves through each face of a box, the first one of its list, too")
{
    const SurfaceMesh mesh = box(Vec3(1, 2, 3));
    const OverlapShape still(mesh);
    for (int face = 0; face < static_cast<int>(mesh.faces.size()); ++face) {
        Vec3 middle = Vec3::Zero();
        for (const int corner : mesh.faces[static_cast<std::size_t>(face)])
            middle += mesh.vertices[static_cast<std::size_t>(corner)] / 3;
        CHECK(find_exit(still.still(), Vec3::Zero(), middle.normalized()).face == face);
    }
}

TEST_CASE("tracing: a strip through one face crosses it in a curve that ends at both of its borders")
{
    const OverlapShape strip(SurfaceMesh{{{-0.1, -1, 0.02}, {0.1, -1, 0.03}, {0.1, 1, 0.05}, {-0.1, 1, 0.01}},
                                         {{0, 1, 2}, {0, 2, 3}}}),
        face(SurfaceMesh{{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}}, {{0, 1, 2}}});
    for (const bool strip_first : {true, false}) {
        const Intersection found = strip_first ? trace_intersection(strip.still(), face.still())
                                               : trace_intersection(face.still(), strip.still());
        REQUIRE(found.curves.size() == 1);
        CHECK(found.curves[0].piercings.size() == 3);
        CHECK_FALSE(found.curves[0].closed);
    }
}

TEST_CASE("exact side: differences that no number holds are not rounded")
{
    // 1 - 2^-80 above the diagonal plane through the origin
    const Vec3 zero = Vec3::Zero(), to(1, 1, 0), along(1, 1, 0), up(0, 0, 1);
    for (const double little : {0x1p-80, -0x1p-80}) {
        const Vec3 from(0, little, 0);
        CHECK(side_of_plane({to, from}, {along, zero}, {up, zero}, 0) == (little > 0 ? 1 : -1));
    }
}
