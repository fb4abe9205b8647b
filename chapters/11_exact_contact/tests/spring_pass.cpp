#include "chapters/11_exact_contact/spring_pass.hpp"

#include "chapters/11_exact_contact/tests/one_block.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace enduring;

TEST_CASE("spring pass: the slope of what a spring pushes is that of differences, held, slipping and open")
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int slips = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 wish(normal(random), normal(random), normal(random));
        const double mu = 0.3 + std::abs(normal(random)), step = 1e-7;
        slips += wish.x() > 0 && wish.tail<2>().norm() > mu * wish.x();
        const Mat3 slope = push_slope(wish, mu);
        for (int k = 0; k < 3; ++k) {
            const Vec3 change = step * Vec3::Unit(k);
            const Vec3 expected = (push(wish + change, mu) - push(wish - change, mu)) / (2 * step);
            CAPTURE(wish.transpose());
            CHECK((slope.col(k) - expected).norm() <= 1e-5);
        }
    }
    CHECK(slips > 20);
}

TEST_CASE("spring pass: a contact pushes, and never pulls, and friction is at most mu of what it pushes")
{
    CHECK(push({-1, 3, 4}, 0.5) == Vec3(0, 0, 0));
    CHECK(push({10, 3, 4}, 0.5) == Vec3(10, 3, 4));
    CHECK((push({2, 3, 4}, 0.5) - Vec3(2, 0.6, 0.8)).norm() <= 1e-15);
}

TEST_CASE(
    "spring pass: masses are counted along the normal and along the surface, and a contact that nothing moves has one")
{
    FrictionProblem problem = one_block({-1, 0, 0}, 0.5);
    problem.response.coeffRef(1, 1) = 0.1;
    problem.response.coeffRef(2, 2) = 0.3;
    CHECK((felt_masses(problem) - Vec3(2, 5, 5)).norm() <= 1e-14);
    problem.response.setZero();
    CHECK(felt_masses(problem) == Vec3(1, 1, 1));
}
