#include "chapters/03_penalty_impulses/penetration.hpp"
#include "chapters/03_penalty_impulses/tests/random_pairs.hpp"

#include <doctest/doctest.h>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>

using namespace enduring;
using enduring::testing::random_pairs;

TEST_CASE("contact normal: the Bernstein form is the cross product of the moving sides")
{
    for (const auto& pair : random_pairs(500, 31)) {
        const Bernstein<Vec3, 2> normal = contact_normal(pair.step());
        for (double tau : {0.0, 0.1, 0.25, 0.5, 0.9, 1.0}) {
            CAPTURE(tau);
            const PairInstant now = pair.at(tau);
            CHECK((normal(tau) - now.side_1.cross(now.side_2)).norm() < 1e-14 * 20);
        }
    }
}

TEST_CASE("contact normal: the cubic depth is n . (p - q), wherever p and q lie on their features")
{
    std::mt19937_64 generator(32);
    std::uniform_real_distribution<double> weight(-0.5, 1.5);
    for (const auto& pair : random_pairs(500, 33)) {
        const Bernstein<double, 3> depth = penetration_depth(contact_normal(pair.step()), pair.step());
        const double s = weight(generator), t = weight(generator);
        for (double tau : {0.0, 0.3, 0.7, 1.0}) {
            CAPTURE(tau);
            PairVertices x;
            for (std::size_t i = 0; i < 4; ++i)
                x[i] = (1 - tau) * pair.t0[i] + tau * pair.t1[i];
            const Vec3 p = pair.edge_edge ? Vec3((1 - s) * x[0] + s * x[1]) : x[0];
            const Vec3 q = pair.edge_edge ? Vec3((1 - t) * x[2] + t * x[3])
                                          : Vec3((1 - s - t) * x[1] + s * x[2] + t * x[3]);
            const Vec3 normal = pair.edge_edge ? (x[1] - x[0]).cross(x[3] - x[2])
                                               : (x[2] - x[1]).cross(x[3] - x[1]);
            CHECK(std::abs(depth(tau) - normal.dot(p - q)) < 1e-12);
        }
    }
}

TEST_CASE("contact normal: the L_i of the corrected (5.13) give the squared length over the step")
{
    for (const auto& pair : random_pairs(200, 34)) {
        const Bernstein<Vec3, 2> normal = contact_normal(pair.step());
        const Bernstein<double, 4> squared = squared_length(normal);
        for (double tau : {0.0, 0.2, 0.5, 0.8, 1.0})
            CHECK(std::abs(squared(tau) - normal(tau).squaredNorm()) < 1e-12);
    }
}

TEST_CASE("contact normal: L_k squared is the mean of the squared length over the step")
{
    for (const auto& pair : random_pairs(200, 35)) {
        const Bernstein<Vec3, 2> normal = contact_normal(pair.step());
        const double mean = boost::math::quadrature::gauss<double, 15>::integrate(
            [&](double tau) { return pair.at(tau).side_1.cross(pair.at(tau).side_2).squaredNorm(); }, 0.0,
            1.0);
        CHECK(std::abs(mean_squared_length(normal) - mean) <= 1e-12 * mean);
    }
}

TEST_CASE("errata: (5.13) as printed, a root of products, is not the length of the normal")
{
    // A triangle at rest with an area of 1/2 has a normal of length 1 all the time; all five L_i are 1.
    const PairInstant rest{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    const auto L = squared_length(contact_normal({rest, rest})).coefficients;
    const double tau = 0.5;
    const std::array<double, 5> basis{1 / 16.0, 4 / 16.0, 6 / 16.0, 4 / 16.0, 1 / 16.0};  // B_i^4(1/2)
    double product = 1, sum = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        product *= L[i] * basis[i];
        sum += L[i] * basis[i];
    }
    CHECK(std::abs(std::sqrt(sum) - 1) < 1e-15);
    // the printed form: far from 1, and it vanishes at both ends of every step
    CHECK(std::sqrt(product) < 0.01);
    CHECK(squared_length(contact_normal({rest, rest}))(tau) == doctest::Approx(1));
}

TEST_CASE(
    "errata: what (5.18) calls n_T is the normal of two edges, and that of a triangle of their ends is another")
{
    int edge_pairs = 0, triangles = 0;
    for (const auto& pair : random_pairs(200, 36)) {
        if (!pair.edge_edge)
            continue;
        const Bernstein<Vec3, 2> printed = contact_normal(pair.step());  // its right-hand side, times L(t)
        for (double tau : {0.0, 0.4, 1.0}) {
            std::array<Vec3, 4> x;
            for (std::size_t i = 0; i < 4; ++i)
                x[i] = (1 - tau) * pair.t0[i] + tau * pair.t1[i];
            const Vec3 n_E = (x[1] - x[0]).cross(x[3] - x[2]), n_T = (x[1] - x[0]).cross(x[2] - x[0]);
            edge_pairs += (printed(tau) - n_E).norm() < 1e-13;
            triangles += (printed(tau) - n_T).norm() < 1e-3;
        }
    }
    CHECK(edge_pairs == 300);
    CHECK(triangles == 0);
}

TEST_CASE("contact normal: an edge pair keeps its orientation while it is pushed through")
{
    // Edge a over edge b, and then under it: the depth changes sign, the normal does not.
    const PairVertices above{Vec3(-1, 0.1, 0), Vec3(1, 0.1, 0), Vec3(0, 0, -1), Vec3(0, 0, 1)};
    PairVertices below = above;
    below[0].y() = below[1].y() = -0.1;
    const double orientation = (above[1] - above[0]).cross(above[3] - above[2]).y() > 0 ? 1 : -1;
    const PairStep step{edge_edge_instant(above, orientation), edge_edge_instant(below, orientation)};
    const Bernstein<Vec3, 2> normal = contact_normal(step);
    const Bernstein<double, 3> depth = penetration_depth(normal, step);
    for (double tau : {0.0, 0.5, 1.0})
        CHECK(normal(tau).y() > 0);
    CHECK(depth(0) > 0);
    CHECK(depth(1) < 0);
}
