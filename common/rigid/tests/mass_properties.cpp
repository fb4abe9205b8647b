#include "common/rigid/mass_properties.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace enduring;

namespace {

SurfaceMesh box_from(const Vec3& low, const Vec3& high)
{
    SurfaceMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.push_back({corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(),
                                 corner & 4 ? high.z() : low.z()});
    mesh.faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                  {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

/// The text-book moments of a box of mass 1.
Mat3 box_inertia(const Vec3& size)
{
    const Vec3 s = size.cwiseAbs2();
    return Vec3(s.y() + s.z(), s.z() + s.x(), s.x() + s.y()).asDiagonal() * Mat3(Mat3::Identity() / 12);
}

const Mat3 skewed = Eigen::AngleAxisd(0.7, Vec3(1, 2, -0.5).normalized()).toRotationMatrix();

}  // namespace

TEST_CASE("mass properties: a box has its text-book mass, centre and moments")
{
    const Vec3 low(-1, 2, 0.5), high(0.5, 2.25, 3);
    const Vec3 size = high - low;
    const MassProperties p = mass_properties(box_from(low, high), 700);
    CHECK(p.mass == doctest::Approx(700 * size.prod()).epsilon(1e-14));
    CHECK((p.centre - (low + high) / 2).norm() <= 1e-14);
    CHECK((p.inertia - p.mass * box_inertia(size)).norm() <= 1e-13 * p.inertia.norm());
}

TEST_CASE("mass properties: a tetrahedron at the origin has the moments of its own integrals")
{
    // Over the corner 0 <= x, y, z, x + y + z <= 1: volume 1/6, centre 1/4; int x^2 = 1/60, int x y = 1/120.
    SurfaceMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const MassProperties p = mass_properties(mesh, 6);
    CHECK(p.mass == doctest::Approx(1));
    CHECK((p.centre - Vec3::Constant(0.25)).norm() <= 1e-15);
    const double square = 6.0 / 60 - 1.0 / 16, mixed = 6.0 / 120 - 1.0 / 16;
    CHECK(p.inertia(0, 0) == doctest::Approx(2 * square).epsilon(1e-13));
    CHECK(p.inertia(1, 2) == doctest::Approx(-mixed).epsilon(1e-13));
}

TEST_CASE("mass properties: turning and moving a mesh turns the tensor and moves the centre, even far away")
{
    const Vec3 size(0.4, 0.2, 0.1), far(1e6, -2e6, 3e5);
    const MassProperties p = mass_properties(placed(box_from(-size / 2, size / 2), skewed, far),
                                             1 / size.prod());
    CHECK((p.centre - far).norm() <= 1e-9);
    const Mat3 expected = skewed * box_inertia(size) * skewed.transpose();
    // the vertices themselves are rounded at 1e6
    CHECK((p.inertia - expected).norm() <= 1e-8 * expected.norm());
}

TEST_CASE("mass properties: another mass scales the tensor and leaves the centre")
{
    const MassProperties p = mass_properties(box_from({0, 0, 0}, {1, 2, 3}), 10);
    const MassProperties q = with_mass(p, 5);
    CHECK(q.mass == 5);
    CHECK(q.centre == p.centre);
    CHECK((q.inertia - 5 * box_inertia({1, 2, 3})).norm() <= 1e-12);
}

TEST_CASE("mass properties: what encloses no volume is refused with a reason")
{
    const SurfaceMesh box = box_from({0, 0, 0}, {1, 1, 1});
    const double infinity = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(mass_properties(box, 0), doctest::Contains("density"), InputError);
    CHECK_THROWS_WITH_AS(mass_properties(box, infinity), doctest::Contains("density"), InputError);
    CHECK_THROWS_WITH_AS(with_mass(mass_properties(box, 1), -1), doctest::Contains("mass"), InputError);

    SurfaceMesh open = box;
    open.faces.pop_back();
    CHECK_THROWS_WITH_AS(mass_properties(open, 1), doctest::Contains("open"), InputError);

    SurfaceMesh one_flipped = box, inside_out = box;
    std::swap(one_flipped.faces[3][0], one_flipped.faces[3][1]);
    CHECK_THROWS_WITH_AS(mass_properties(one_flipped, 1), doctest::Contains("opposite"), InputError);
    for (Face& face : inside_out.faces)
        std::swap(face[0], face[1]);
    CHECK_THROWS_WITH_AS(mass_properties(inside_out, 1), doctest::Contains("volume"), InputError);
    CHECK_THROWS_WITH_AS(mass_properties(box_from({0, 0, 0}, {1, 1, 0}), 1), doctest::Contains("volume"),
                         InputError);
}

TEST_CASE("mass properties: the mass of a sheet lies on its faces, and an open box of plates adds them up")
{
    // the plate x in [0, 2], y in [0, 1] at z = 3: m (b^2, a^2, a^2 + b^2) / 12
    const SurfaceMesh plate{{{0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}}, {{0, 1, 2}, {0, 2, 3}}};
    const MassProperties p = sheet_properties(plate, 5);
    CHECK(p.mass == doctest::Approx(10));
    CHECK((p.centre - Vec3(1, 0.5, 3)).norm() < 1e-14);
    CHECK((p.inertia - Mat3(Vec3(10, 40, 50).asDiagonal()) / 12).norm() < 1e-13);

    // a cube's six sides of mass 1: four of them half a side from each axis through the middle
    const MassProperties cube = sheet_properties(box_from({0, 0, 0}, {1, 1, 1}), 1);
    CHECK(cube.mass == doctest::Approx(6));
    CHECK((cube.inertia - (4 * (1.0 / 12 + 0.25) + 2.0 / 6) * Mat3::Identity()).norm() < 1e-13);
    CHECK_THROWS_AS(sheet_properties(plate, 0), InputError);
}

TEST_CASE("mass properties: of a cloud each point has an equal share, of a wire each edge by its length")
{
    // eight corners of a cube of side 2: each is sqrt(2) away from an axis
    SurfaceMesh cloud;
    for (int i = 0; i < 8; ++i)
        cloud.vertices.emplace_back(i & 1 ? 3 : 1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const MassProperties of_cloud = frame_properties(cloud, 5);
    CHECK((of_cloud.centre - Vec3(2, 0, 0)).norm() <= 1e-14);
    CHECK((of_cloud.inertia - 5 * 2 * Mat3(Mat3::Identity())).norm() <= 1e-13);
    CHECK(of_cloud.mass == 5);

    // an L of 2 m and 1 m, against many points along it
    const SurfaceMesh wire{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {}, {{0, 1}, {1, 2}}};
    SurfaceMesh dense;
    for (int i = 0; i < 3000; ++i) {
        const double along = (i + 0.5) / 1000;
        dense.vertices.push_back(along < 2 ? Vec3(along, 0, 0) : Vec3(2, along - 2, 0));
    }
    const MassProperties one = frame_properties(wire, 3), other = frame_properties(dense, 3);
    CHECK((one.centre - other.centre).norm() <= 1e-9);
    CHECK((one.inertia - other.inertia).norm() <= 1e-6);
}

TEST_CASE(
    "mass properties: about a line on which all points lie stands the largest moment, so an inverse exists")
{
    const Vec3 along = Vec3(1, 2, 2) / 3;
    const SurfaceMesh rod{{Vec3::Zero(), 1.5 * along, 3 * along}, {}, {{0, 1}, {1, 2}}};
    const MassProperties of_rod = frame_properties(rod, 4);
    CHECK((of_rod.inertia - 4 * 9.0 / 12 * Mat3(Mat3::Identity())).norm() <= 1e-12);  // m l^2 / 12
    REQUIRE(common_line(rod.vertices));
    CHECK(std::abs(common_line(rod.vertices)->dot(along)) == doctest::Approx(1));
    const SurfaceMesh bent{
        {Vec3::Zero(), 1.5 * along + 1e-3 * Vec3::UnitZ(), 3 * along}, {}, {{0, 1}, {1, 2}}};
    CHECK_FALSE(common_line(bent.vertices));
    CHECK_THROWS_AS(frame_properties({{Vec3::Ones(), Vec3::Ones()}, {}, {}}, 1), InputError);
    CHECK_THROWS_AS(frame_properties(rod, 0), InputError);
}
