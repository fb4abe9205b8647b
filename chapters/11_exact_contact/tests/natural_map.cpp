#include "chapters/11_exact_contact/natural_map.hpp"

#include "chapters/11_exact_contact/tests/one_block.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;

namespace {

/// Where a function is least, by a grid that becomes finer.
template <class Function>
double least_at(double low, double high, const Function& function)
{
    for (int level = 0; level < 60; ++level) {
        double best = low;
        for (int i = 0; i <= 20; ++i)
            if (const double x = low + (high - low) * i / 20; function(x) < function(best))
                best = x;
        const double range = (high - low) / 5;
        low = best - range;
        high = best + range;
    }
    return 0.5 * (low + high);
}

/// The nearest point of the cone's side: first the angle, which is the same at every height, then the height.
Vec3 nearest_by_search(const Vec3& impulse, double mu)
{
    if (std::hypot(impulse.y(), impulse.z()) <= mu * impulse.x())
        return impulse;
    const auto point = [&](double height, double angle) {
        return Vec3(height, mu * height * std::cos(angle), mu * height * std::sin(angle));
    };
    const double size = impulse.norm();
    const double angle = least_at(-M_PI, M_PI, [&](double x) { return (point(size, x) - impulse).norm(); });
    // by the root of the height, which may have either sign
    const double root = least_at(-2, 2,
                                 [&](double x) { return (point(x * x * size, angle) - impulse).norm(); });
    return point(root * root * size, angle);
}

}  // namespace

TEST_CASE("natural map: the nearest point of the cone is the one that a search finds")
{
    std::mt19937 random(11);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 300; ++i) {
        const Vec3 impulse(normal(random), normal(random), normal(random));
        const double mu = std::exp(normal(random) - 1);
        CAPTURE(impulse.transpose());
        CAPTURE(mu);
        CHECK((nearest_in_cone(impulse, mu) - nearest_by_search(impulse, mu)).norm() <=
              1e-6 * impulse.norm());
    }
}

TEST_CASE("natural map: it is zero at a block that holds, slides or flies, and at nothing near it")
{
    for (const HandSolved& block : hand_solved_blocks()) {
        CAPTURE(block.name);
        CHECK(natural_map_error(block.problem, block.impulse) <= 1e-14);
        CHECK((contact_velocities(block.problem, block.impulse) - block.velocity).norm() <= 1e-14);
        for (int i = 0; i < 3; ++i)
            for (const double by : {-0.01, 0.01}) {
                Eigen::VectorXd wrong = block.impulse;
                wrong[i] += by;
                CHECK(natural_map_error(block.problem, wrong) >= 1e-3);
            }
    }
}

TEST_CASE(
    "natural map: friction along the slip, less friction than its limit, and a contact that pulls are wrong")
{
    CHECK(natural_map(Vec3(1, 0.5, 0), Vec3(0, -2, 0), 0.5).norm() <= 1e-15);
    CHECK(natural_map(Vec3(1, -0.5, 0), Vec3(0, -2, 0), 0.5).norm() >= 0.5);  // along the slip
    CHECK(natural_map(Vec3(1, 0.4, 0), Vec3(0, -2, 0), 0.5).norm() >= 0.08);  // less than its limit
    CHECK(natural_map(Vec3(-1, 0, 0), Vec3(0, 0, 0), 0.5).norm() == doctest::Approx(1));
    CHECK(natural_map(Vec3(0, 0, 0), Vec3(-1, 0, 0), 0.5).norm() == doctest::Approx(1));  // goes in
}

TEST_CASE("natural map: it is measured by the free velocity")
{
    FrictionProblem problem = hand_solved_blocks().front().problem;
    problem.free_velocity *= 1000;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(3);
    // nothing pushes: r - P(r - u~) is the impulse that is missing
    const Vec3 missing = natural_map(Vec3::Zero(), problem.free_velocity, problem.mu[0]);
    CHECK(natural_map_error(problem, none) == doctest::Approx(missing.norm() / problem.free_velocity.norm()));
}
