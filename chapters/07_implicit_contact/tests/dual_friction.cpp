#include "chapters/07_implicit_contact/dual_friction.hpp"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <random>

using namespace enduring;

namespace {

/// Particles that are pressed and slip, each on its own plane.
ContactProblem slipping_particles()
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    ContactProblem problem;
    problem.step = {1, 0.01};
    for (int i = 0; i < 50; ++i) {
        BodyBlock block{problem.size, Mat3::Identity(), {}};
        block.response = block.mass.inverse();
        problem.blocks.push_back(block);
        PairRow& row = problem.rows.emplace_back();
        row.law.normal = vector().normalized();
        row.law.stiffness = 1e6;
        row.law.mu = 0.5;
        row.law.lagged_normal_impulse = 1;
        row.velocity = vector() - row.law.normal;
        row.parts[0] = {problem.size, Mat3::Identity()};
        row.part_count = 1;
        problem.size += 3;
    }
    return problem;
}

Mat3 own_stiffening(const ContactProblem& problem, std::size_t pair)
{
    const PairRow& row = problem.rows[pair];
    return hessian_of(row.law, pushed(row.law, row.velocity, problem.step), problem.step);
}

double least_eigenvalue(const Mat3& matrix)
{
    return Eigen::SelfAdjointEigenSolver<Mat3>(matrix).eigenvalues().minCoeff();
}

}  // namespace

TEST_CASE("dual friction: a guess that fits has the stiffening of the law, and one of zero is stiffer")
{
    const ContactProblem problem = slipping_particles();
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(problem.size);
    const std::vector<Vec3> velocities = velocities_after(problem, nothing);
    DualFriction friction(problem);
    const std::vector<Mat3> of_zero = friction.hessians(answers_at(problem, velocities).pushes, velocities);
    friction.follow(velocities, rates_of(problem, nothing));
    const std::vector<Mat3> of_fitting = friction.hessians(answers_at(problem, velocities).pushes,
                                                           velocities);
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const Mat3 own = own_stiffening(problem, i);
        CHECK((of_fitting[i] - own).norm() <= 1e-12 * own.norm());
        CHECK((of_zero[i] - own).norm() > 1e-4 * own.norm());
        CHECK(least_eigenvalue(of_zero[i] - own) >= -1e-9);
    }
}

TEST_CASE("dual friction: where the impulses that act are the answers, the first guesses fit")
{
    ContactProblem problem = slipping_particles();
    for (PairRow& row : problem.rows)
        row.acting = pushed(row.law, row.velocity, problem.step).total();
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(problem.size);
    const std::vector<Mat3> all = DualFriction(problem).hessians(answers_to(problem, nothing).pushes,
                                                                 velocities_after(problem, nothing));
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const Mat3 own = own_stiffening(problem, i);
        CHECK((all[i] - own).norm() <= 1e-12 * own.norm());
    }
}

TEST_CASE("dual friction: wherever the guesses have been led, the stiffening is symmetric and never negative")
{
    const ContactProblem problem = slipping_particles();
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    const auto vector = [&] {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(problem.size, [&] { return normal(random); }));
    };
    DualFriction friction(problem);
    for (int step = 0; step < 10; ++step) {
        const std::vector<Vec3> velocities = velocities_after(problem, vector());
        for (const Mat3& hessian : friction.hessians(answers_at(problem, velocities).pushes, velocities)) {
            CHECK((hessian - hessian.transpose()).norm() <= 1e-12 * hessian.norm());
            CHECK(least_eigenvalue(hessian) >= -1e-9);
        }
        friction.follow(velocities, rates_of(problem, vector()));
    }
}

TEST_CASE(
    "dual friction: with its guess for f the stiffening is the symmetric part of what |s| f = limit s gives")
{
    // |s| df + (d . ds) f = limit ds, where the spring answers a velocity along the surface with ds = -k dt^2
    // dv
    ContactProblem problem = slipping_particles();
    for (PairRow& row : problem.rows)
        row.acting = 0.4 * (Vec3(1, 2, -2) - row.velocity);
    const std::vector<Vec3> velocities = velocities_after(problem, Eigen::VectorXd::Zero(problem.size));
    const std::vector<Mat3> all = DualFriction(problem).hessians(answers_at(problem, velocities).pushes,
                                                                 velocities);
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
        const PairRow& row = problem.rows[i];
        const double limit = row.law.mu * row.law.lagged_normal_impulse;
        const Mat3 along = Mat3::Identity() - row.law.normal * row.law.normal.transpose();
        const Vec3 spring = spring_impulse(row.law, velocities[i], problem.step);
        Vec3 guess = along * row.acting;
        guess *= std::min(1.0, limit / guess.norm());
        const Mat3 slope = (limit * along - guess * spring.normalized().transpose()) / spring.norm() *
                           row.law.stiffness * problem.step.dt * problem.step.dt;
        const Mat3 expected = 0.5 * (slope + slope.transpose());
        CHECK((along * all[i] * along - expected).norm() <= 1e-9 * expected.norm());
    }
}
