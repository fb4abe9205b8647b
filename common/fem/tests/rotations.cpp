#include "common/fem/polar_rotation.hpp"
#include "common/fem/tests/bodies.hpp"

#include <doctest/doctest.h>
#include <Eigen/LU>

#include <array>

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
    for (const Vec3& stretch :
         {Vec3(1, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, -1), Vec3(-1, -1, -1), Vec3(2, 1, -1e-9),
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

TEST_CASE("polar rotation: a bent quadratic element turns as at its centroid, not as at a corner")
{
    // x = X + (b.X)^2 d: its gradient 1 + 2 (b.X) d b^T is known
    // everywhere, and its control points by polarisation.
    const Vec3 b(2.2, -1, 1.7), d(0.3, 1.1, -0.7);
    const ElasticMesh mesh = elastic(small_bar(), Basis::quadratic);
    const auto gradient_at = [&](const Vec3& place) -> Mat3 {
        return Mat3::Identity() + 2 * b.dot(place) * d * b.transpose();
    };
    NodalVectors bent = mesh.rest();
    for (const ElasticElement& element : mesh.elements())
        for (std::size_t i = 0; i < 10; ++i) {
            const auto [one, other] = i < 4 ? std::array{int(i), int(i)} : tetrahedron_edges[i - 4];
            const Vec3 x_one = mesh.rest().col(element.nodes[one]),
                       x_other = mesh.rest().col(element.nodes[other]);
            bent.col(element.nodes[i]) = mesh.rest().col(element.nodes[i]) +
                                         b.dot(x_one) * b.dot(x_other) * d;
        }
    ElementRotations rotations;
    find_rotations(mesh, bent, rotations);
    for (std::size_t e = 0; e < rotations.size(); ++e) {
        CAPTURE(e);
        Vec3 centroid = Vec3::Zero();
        for (int i = 0; i < 4; ++i)
            centroid += mesh.rest().col(mesh.elements()[e].nodes[i]) / 4;
        CHECK((rotations[e] - polar_rotation(gradient_at(centroid))).norm() <= 1e-12);
        for (int i = 0; i < 4; ++i)
            CHECK((rotations[e] - polar_rotation(gradient_at(mesh.rest().col(mesh.elements()[e].nodes[i]))))
                      .norm() > 0.01);
    }
}
