#include "bodies.hpp"

#include "common/fem/polar_rotation.hpp"

#include <Eigen/LU>
#include <doctest/doctest.h>


using namespace enduring;
using namespace enduring::test;

namespace {

double departure_from_rotation(const Mat3& r)
{
    return (r.transpose() * r - Mat3::Identity()).norm() + std::abs(r.determinant() - 1);
}

}  // namespace

TEST_CASE("polar rotation: F = R S is taken apart into the R and S it was made of")
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const Mat3 r = random_rotation(seed), axes = random_rotation(seed + 1000);
        const Vec3 stretch = (random_field(1, 3.0, seed + 2000).array().exp()).matrix();  // 0.05 to 20
        const Mat3 s = axes * stretch.asDiagonal() * axes.transpose();
        CHECK((polar_rotation(r * s) - r).norm() <= 1e-12 * stretch.maxCoeff() / stretch.minCoeff());
    }
}

TEST_CASE("polar rotation: flat, inverted, tiny, huge and zero gradients still give a rotation")
{
    const Mat3 r = random_rotation(7);
    for (const Vec3& stretch : {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -1), Vec3(-1, -1, -1), Vec3(2, 1, -1e-9),
                                Vec3(1e-150, 1e-150, 1e-150), Vec3(1e90, 1e90, 1e90), Vec3(1, 1e-9, 1e-9)}) {
        CAPTURE(stretch.transpose());
        CHECK(departure_from_rotation(polar_rotation(r * stretch.asDiagonal())) <= 1e-12);
    }
}

TEST_CASE("polar rotation: an inverted gradient is mirrored along its thinnest direction")
{
    const Mat3 r = random_rotation(3);
    const Mat3 f = r * Vec3(1.3, 1.1, -0.4).asDiagonal();
    CHECK((polar_rotation(f) - r).norm() <= 1e-12);
}

TEST_CASE("polar rotation: it does not jump where the way of computing changes")
{
    const Mat3 r = random_rotation(5), axes = random_rotation(6);
    for (double thin = 0.02; thin < 0.3; thin *= 1.05) {
        CAPTURE(thin);
        const Mat3 s = axes * Vec3(1.2, 0.9, thin).asDiagonal() * axes.transpose();
        CHECK((polar_rotation(r * s) - r).norm() <= 1e-12);
    }
}

TEST_CASE("polar rotation: an element turns with its body, whatever its shape")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(small_bar(), basis);
        const NodalVectors bent = mesh.rest() + random_field(mesh.node_count(), 0.02, 1);
        const Mat3 turn = random_rotation(11);
        ElementRotations before, after;
        find_rotations(mesh, bent, before);
        find_rotations(mesh, (turn * bent).colwise() + Vec3(3, 1, 2), after);
        for (std::size_t e = 0; e < before.size(); ++e)
            CHECK((after[e] - turn * before[e]).norm() <= 1e-12);
    }
}
