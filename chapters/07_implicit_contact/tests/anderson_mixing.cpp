#include "chapters/07_implicit_contact/anderson_mixing.hpp"

#include <doctest/doctest.h>

#include <Eigen/QR>

#include <cmath>
#include <random>

using namespace enduring;

TEST_CASE("anderson mixing: rounds of a linear map end, also where alone they would grow")
{
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int n = 1; n <= 6; ++n) {
        const auto number = [&] { return normal(random); };
        const Eigen::MatrixXd axes =
            Eigen::MatrixXd::NullaryExpr(n, n, number).householderQr().householderQ();
        const Eigen::VectorXd factors = Eigen::VectorXd::LinSpaced(n, -1.5, 0.99),
                              expected = Eigen::VectorXd::NullaryExpr(n, number);
        const Eigen::MatrixXd map = axes * factors.asDiagonal() * axes.transpose();
        AndersonMixing mixing(8);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
        for (int round = 0; round < n + 3; ++round)
            x = mixing.next(x, expected + map * (x - expected));
        CAPTURE(n);
        CHECK((x - expected).norm() <= 1e-8);
    }
}

TEST_CASE("anderson mixing: rounds that only change the sign of the error end in the middle")
{
    AndersonMixing mixing(8);
    Eigen::VectorXd x = Eigen::VectorXd::Constant(3, 5);
    for (int round = 0; round < 2; ++round)
        x = mixing.next(x, Eigen::VectorXd(2 - x.array()));
    CHECK((x.array() - 1).matrix().norm() <= 1e-14);
}

TEST_CASE("anderson mixing: rounds of a linear map of more unknowns than it looks back end, too")
{
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    for (const int n : {12, 20, 40}) {
        const auto number = [&] { return normal(random); };
        const Eigen::MatrixXd axes =
            Eigen::MatrixXd::NullaryExpr(n, n, number).householderQr().householderQ();
        const Eigen::VectorXd factors = Eigen::VectorXd::LinSpaced(n, -1.2, 0.8),
                              expected = Eigen::VectorXd::NullaryExpr(n, number);
        const Eigen::MatrixXd map = axes * factors.asDiagonal() * axes.transpose();
        AndersonMixing mixing(8);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
        for (int round = 0; round < 60; ++round)
            x = mixing.next(x, expected + map * (x - expected));
        CAPTURE(n);
        CHECK((x - expected).norm() <= 1e-8);
    }
}

TEST_CASE("anderson mixing: rounds that hardly change any more, or not at all, end at a number")
{
    for (const double change : {0.0, 1e-18, 1e-160, 1e-200, 1e-320}) {
        CAPTURE(change);
        AndersonMixing mixing(8);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
        for (int round = 0; round < 20; ++round) {
            const Eigen::VectorXd image = Eigen::Vector3d(change * round, change * (round % 2), 0);
            x = mixing.next(x, image);
            CHECK(x.allFinite());
        }
    }
}

TEST_CASE(
    "anderson mixing: where the rounds turn into others when they have ended, they end at a number again")
{
    for (unsigned seed = 1; seed <= 5; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        const auto number = [&] { return normal(random); };
        AndersonMixing mixing(8);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(4);
        for (int turn = 0; turn < 3; ++turn) {
            const Eigen::MatrixXd axes =
                Eigen::MatrixXd::NullaryExpr(4, 4, number).householderQr().householderQ();
            const Eigen::MatrixXd map = axes * Eigen::VectorXd::LinSpaced(4, -0.8, 0.8).asDiagonal() *
                                        axes.transpose();
            const Eigen::VectorXd expected = Eigen::VectorXd::NullaryExpr(4, number);
            for (int round = 0; round < 40; ++round)
                x = mixing.next(x, expected + map * (x - expected));
            CAPTURE(seed);
            CAPTURE(turn);
            CHECK((x - expected).norm() <= 1e-8);
        }
    }
}

TEST_CASE("anderson mixing: rounds that turn into others end as soon as those would from the beginning")
{
    constexpr int n = 4;
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        const auto number = [&] { return normal(random); };
        AndersonMixing mixing(8);
        Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
        for (const double size : {1e-3, 1.0}) {  // of the second ones the error is larger
            const Eigen::MatrixXd axes =
                Eigen::MatrixXd::NullaryExpr(n, n, number).householderQr().householderQ();
            const Eigen::MatrixXd map = axes * Eigen::VectorXd::LinSpaced(n, -0.8, 0.8).asDiagonal() *
                                        axes.transpose();
            const Eigen::VectorXd expected = size * Eigen::VectorXd::NullaryExpr(n, number);
            for (int round = 0; round < n + 1; ++round)
                x = mixing.next(x, expected + map * (x - expected));
            CAPTURE(seed);
            CAPTURE(size);
            CHECK((x - expected).norm() <= 1e-8);
        }
    }
}

TEST_CASE("anderson mixing: with none of the rounds before, each round is taken as it comes")
{
    AndersonMixing none(0);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(1);
    for (int round = 0; round < 5; ++round) {
        x = none.next(x, Eigen::VectorXd(1 - 2 * x.array()));
        CHECK(x[0] == doctest::Approx((1 - std::pow(-2, round + 1)) / 3));
    }
}
