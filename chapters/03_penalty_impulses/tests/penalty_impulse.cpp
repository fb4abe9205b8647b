#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "chapters/01_particle_plane/plane_impulse.hpp"
#include "chapters/03_penalty_impulses/experiments/exact_impulse.hpp"
#include "chapters/03_penalty_impulses/tests/random_pairs.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <complex>

using namespace enduring;
using enduring::testing::random_pairs;
using enduring::testing::RandomPair;

namespace {

double depth_at(const RandomPair& pair, double tau)
{
    const PairInstant now = pair.at(tau);
    return now.side_1.cross(now.side_2).dot(now.offset);
}

/// Where the depth may change its sign: real parts of the roots of the cubic through
/// four of its values, as the eigenvalues of its companion matrix, between 0 and 1.
/// A piece between two of them lies inside or outside.
std::vector<double> breakpoints(const RandomPair& pair)
{
    Eigen::Matrix4d powers;
    Eigen::Vector4d values;
    for (int i = 0; i < 4; ++i) {
        const double tau = i / 3.0;
        powers.row(i) << 1, tau, tau * tau, tau * tau * tau;
        values[i] = depth_at(pair, tau);
    }
    const Eigen::Vector4d c = powers.fullPivLu().solve(values);
    Mat3 companion = Mat3::Zero();
    companion(1, 0) = companion(2, 1) = 1;
    companion.col(2) = -c.head<3>() / c[3];
    std::vector<double> points{0, 1};
    for (const std::complex<double> root : companion.eigenvalues())
        if (root.real() > 0 && root.real() < 1)
            points.push_back(root.real());
    std::sort(points.begin(), points.end());
    return points;
}

/// A vector integral over [0, 1] of what happens inside, piece by piece with 25 points each.
template <class Integrand>
Vec3 integral_inside(const RandomPair& pair, const Integrand& integrand)
{
    Vec3 sum = Vec3::Zero();
    const std::vector<double> points = breakpoints(pair);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (depth_at(pair, 0.5 * (points[i] + points[i + 1])) < 0)
            for (int axis = 0; axis < 3; ++axis)
                sum[axis] += boost::math::quadrature::gauss<double, 25>::integrate(
                    [&](double tau) { return integrand(tau)[axis]; }, points[i], points[i + 1]);
    return sum;
}

double mean_squared(const RandomPair& pair)
{
    return boost::math::quadrature::gauss<double, 15>::integrate(
        [&](double tau) { return pair.at(tau).side_1.cross(pair.at(tau).side_2).squaredNorm(); }, 0.0, 1.0);
}

}  // namespace

TEST_CASE("penalty impulses: the closed form equals a quadrature of its own integrand")
{
    for (const RandomPair& pair : random_pairs(1000, 40)) {
        CAPTURE(pair.t0);
        CAPTURE(pair.t1);
        const Vec3 exact = continuous_impulse(pair.step(), 0, 1, 1);
        const Vec3 summed = -integral_inside(pair, [&](double tau) {
            const PairInstant now = pair.at(tau);
            const Vec3 normal = now.side_1.cross(now.side_2);
            return Vec3(normal.dot(now.offset) * normal);
        }) / mean_squared(pair);
        CHECK((exact - summed).norm() <= 1e-12 * (1 + summed.norm()));
    }
}

TEST_CASE(
    "penalty impulses: the constant L_k is exact for normals that keep their length, and close for small motions")
{
    double worst_at_1_percent = 0, worst_at_10_percent = 0;
    for (const double motion : {0.0, 0.01, 0.1})
        for (const RandomPair& pair : random_pairs(400, 44, motion)) {
            // Only well shaped pairs: the motion must be small beside the normal.
            if (pair.at(0).side_1.cross(pair.at(0).side_2).norm() < 0.5)
                continue;
            const Vec3 exact = exact_impulse(pair.step(), 0, 1, 1),
                       ours = continuous_impulse(pair.step(), 0, 1, 1);
            const double error = (exact - ours).norm() / (1e-3 + exact.norm());
            if (motion == 0)
                CHECK(error < 1e-13);
            double& worst = motion < 0.05 ? worst_at_1_percent : worst_at_10_percent;
            worst = std::max(worst, error);
        }
    CHECK(worst_at_1_percent < 0.05);
    CHECK(worst_at_10_percent < 0.5);
    CHECK(worst_at_1_percent < 0.3 * worst_at_10_percent);
}

TEST_CASE("penalty impulses: the exact impulse is a quadrature of the unit normal's integrand")
{
    for (const RandomPair& pair : random_pairs(200, 45, 0.5)) {
        const Vec3 exact = exact_impulse(pair.step(), 0, 1, 1, 16);
        const Vec3 summed = -integral_inside(pair, [&](double tau) {
            const PairInstant now = pair.at(tau);
            const Vec3 normal = now.side_1.cross(now.side_2).normalized();
            return Vec3(normal.dot(now.offset) * normal);
        });
        // A normal that almost vanishes on its way makes the integrand steep for both.
        if (std::min({pair.at(0.25).side_1.cross(pair.at(0.25).side_2).norm(),
                      pair.at(0.5).side_1.cross(pair.at(0.5).side_2).norm(),
                      pair.at(0.75).side_1.cross(pair.at(0.75).side_2).norm()}) > 0.5)
            CHECK((exact - summed).norm() < 1e-10);
    }
}

TEST_CASE("penalty impulses: the plane of chapter 1 is a pair with a face that does not move")
{
    std::mt19937_64 generator(41);
    std::uniform_real_distribution<double> unit(-1, 1);
    const double k = 700, dt = 0.02;
    for (int round = 0; round < 500; ++round) {
        const double y_t0 = unit(generator), y_t1 = unit(generator), start = 0;
        const PairVertices t0{Vec3(0.1, y_t0, 0.2), Vec3(-1, 0, -1), Vec3(-1, 0, 3), Vec3(3, 0, -1)};
        PairVertices t1 = t0;
        t1[0].y() = y_t1;
        const PairStep step{vertex_face_instant(t0), vertex_face_instant(t1)};
        const Vec3 continuous = continuous_impulse(step, start, k, dt),
                   discrete = discrete_impulse(step.t1, k, dt);
        CAPTURE(y_t0);
        CAPTURE(y_t1);
        CHECK((continuous - Vec3(0, continuous_plane_impulse(y_t0, y_t1, k, dt), 0)).norm() < 1e-12);
        CHECK((discrete - Vec3(0, discrete_plane_impulse(y_t1, k, dt), 0)).norm() < 1e-12);
    }
}

TEST_CASE("penalty impulses: (5.20) for a vertex that enters half-way, by hand")
{
    // From 1 above to 1 below: inside for tau in [1/2, 1], mean depth
    // there -1/2, so -k dt (1/2)(-1/2) = k dt / 4.
    const PairVertices t0{Vec3(0, 1, 0), Vec3(-1, 0, -1), Vec3(-1, 0, 3), Vec3(3, 0, -1)};
    PairVertices t1 = t0;
    t1[0].y() = -1;
    const PairStep step{vertex_face_instant(t0), vertex_face_instant(t1)};
    CHECK((continuous_impulse(step, 0, 8, 0.5) - Vec3(0, 1, 0)).norm() < 1e-15);
    CHECK((continuous_impulse(step, 0.5, 8, 0.5) - Vec3(0, 1, 0)).norm() < 1e-15);
    // the whole step at its deepest
    CHECK((discrete_impulse(step.t1, 8, 0.5) - Vec3(0, 4, 0)).norm() < 1e-15);
}

TEST_CASE("penalty impulses: for a pair inside throughout, the continuous impulse tends to the discrete one")
{
    for (const double motion : {1e-2, 1e-4, 1e-6}) {
        int inside = 0;
        for (const RandomPair& pair : random_pairs(400, 42, motion)) {
            const PairStep step = pair.step();
            const Vec3 discrete = discrete_impulse(step.t1, 1, 1);
            // Only well shaped pairs: the motion must be small beside every length of the pair.
            if (discrete.norm() < 0.1 || step.t1.side_1.cross(step.t1.side_2).norm() < 0.3)
                continue;
            ++inside;
            CAPTURE(motion);
            CHECK((continuous_impulse(step, 0, 1, 1) - discrete).norm() < 30 * motion);
        }
        CHECK(inside > 50);
    }
}

TEST_CASE("penalty impulses: they push p out of B, along the normal, and never pull")
{
    for (const RandomPair& pair : random_pairs(1000, 43, 0.2)) {
        const PairStep step = pair.step();
        const Vec3 normal = step.t1.side_1.cross(step.t1.side_2);
        const Vec3 impulse = discrete_impulse(step.t1, 1, 1);
        CHECK(impulse.dot(normal) >= 0);
        CHECK(impulse.cross(normal).norm() < 1e-14);
        if (depth_at(pair, 1) > 0)
            CHECK(impulse.norm() == 0);
        // The continuous one is a sum of pushes along normals of the step.
        const auto [n0, n1, n2] = contact_normal(step).coefficients;
        if (n0.dot(n1) > 0 && n1.dot(n2) > 0 && n0.dot(n2) > 0)
            CHECK(continuous_impulse(step, 0, 1, 1).dot(n1) >= 0);
    }
}

TEST_CASE("penalty impulses: sides without a normal give no impulse and no NaN")
{
    const PairInstant needle{Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, -1, 0)};
    CHECK(discrete_impulse(needle, 1, 1).norm() == 0);
    CHECK(continuous_impulse({needle, needle}, 0, 1, 1).norm() == 0);
    const PairInstant point{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    CHECK(continuous_impulse({point, point}, 0.5, 1, 1).norm() == 0);
}

TEST_CASE("errata: with the printed sign of (5.9) the impulse pushes the vertex further in")
{
    const PairVertices below{Vec3(0, -0.1, 0), Vec3(-1, 0, -1), Vec3(-1, 0, 3), Vec3(3, 0, -1)};
    const PairInstant pair = vertex_face_instant(below);
    const Vec3 normal = pair.side_1.cross(pair.side_2).normalized();
    const double depth = normal.dot(pair.offset), k = 10, dt = 1;
    const Vec3 as_printed = k * dt * depth * normal;
    CHECK(as_printed.dot(normal) < 0);
    CHECK(continuous_impulse({pair, pair}, 0, k, dt).dot(normal) > 0);
    CHECK((continuous_impulse({pair, pair}, 0, k, dt) + as_printed).norm() < 1e-15);
}
