#include "chapters/07_implicit_contact/pair_law.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include <random>

using namespace enduring;

namespace {

/// Pairs of all kinds: from outside and inside, holding and slipping, with friction and without.
struct Sample {
    PairLaw pair;
    Vec3 velocity;
};

std::vector<Sample> samples()
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    std::vector<Sample> all;
    for (int i = 0; i < 400; ++i) {
        PairLaw pair;
        pair.normal = vector().normalized();
        pair.depth_t0 = 0.01 * normal(random);
        pair.stiffness = 1000;
        pair.stretch = 0.01 * (Mat3::Identity() - pair.normal * pair.normal.transpose()) * vector();
        pair.mu = 0.5;
        pair.lagged_normal_impulse = i % 3 == 0 ? 0 : 0.2 * std::abs(normal(random));
        all.push_back({pair, vector()});
    }
    return all;
}

const StepLaw step{2.0 / 3, 0.01};

Vec3 impulse(const PairPush& made) { return made.normal_impulse + made.friction; }

}  // namespace

TEST_CASE("pair law: the stiffening is minus the derivative of the impulse, symmetric and never negative")
{
    for (const auto& [pair, velocity] : samples()) {
        const PairPush made = pushed(pair, velocity, step);
        const Mat3 hessian = hessian_of(pair, made, step);
        const double by = 1e-6;
        Mat3 measured;
        for (int axis = 0; axis < 3; ++axis)
            measured.col(axis) = (impulse(pushed(pair, velocity - by * Vec3::Unit(axis), step)) -
                                  impulse(pushed(pair, velocity + by * Vec3::Unit(axis), step))) /
                                 (2 * by);
        CHECK((measured - hessian).norm() <= 1e-6);
        CHECK((hessian - hessian.transpose()).norm() <= 1e-12);
        CHECK(Eigen::SelfAdjointEigenSolver<Mat3>(hessian).eigenvalues().minCoeff() >= -1e-12);
    }
}

TEST_CASE("pair law: while it holds, friction is the spring from its anchor to where p ends the step")
{
    int holding = 0;
    for (const auto& [pair, velocity] : samples()) {
        const PairPush made = pushed(pair, velocity, step);
        if (made.slips || pair.lagged_normal_impulse == 0)
            continue;
        ++holding;
        const Vec3 along = velocity - pair.normal.dot(velocity) * pair.normal;
        CHECK((made.friction + pair.stiffness * step.dt * (pair.stretch + step.dt * along)).norm() <= 1e-12);
    }
    CHECK(holding > 20);
}

TEST_CASE("pair law: two velocities and their impulses never agree in direction, so the potential is convex")
{
    const std::vector<Sample> all = samples();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        const Vec3 &one = all[i].velocity, &other = all[i + 1].velocity;
        const Vec3 change = impulse(pushed(all[i].pair, one, step)) -
                            impulse(pushed(all[i].pair, other, step));
        CHECK(change.dot(one - other) <= 1e-12);
    }
}

TEST_CASE(
    "pair law: it pushes out of B and never pulls, and friction lies along the surface within its limit")
{
    int pushing = 0, slipping = 0;
    for (const auto& [pair, velocity] : samples()) {
        const PairPush made = pushed(pair, velocity, step);
        CHECK(made.normal_impulse.dot(pair.normal) >= 0);
        CHECK(made.normal_impulse.cross(pair.normal).norm() <= 1e-12);
        CHECK(std::abs(made.friction.dot(pair.normal)) <= 1e-12);
        CHECK(made.friction.norm() <= pair.mu * pair.lagged_normal_impulse * (1 + 1e-12));
        if (made.slips)
            CHECK(made.friction.norm() == doctest::Approx(pair.mu * pair.lagged_normal_impulse));
        pushing += !made.normal_impulse.isZero();
        slipping += made.slips;
    }
    CHECK(pushing > 100);
    CHECK(slipping > 50);
}
