#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/dual_friction.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <limits>
#include <random>

using namespace enduring;

namespace {

/// Bodies of several vertices whose masses are coupled with each other, and pairs that touch two or three
/// vertices of one of them, some with a rigid body as well.
struct CoupledBodies {
    ContactProblem problem;
    std::mt19937 random{11};

    explicit CoupledBodies(double dt)
    {
        problem.step = {1, dt};
        for (const int size : {12, 6, 9})
            add_body(size);
        add_pair({{0, 3}, {3, 3}});
        add_pair({{0, 3}, {6, 3}, {9, 3}, {12, 6}});
        add_pair({{12, 6}, {18, 3}, {24, 3}});
        add_pair({{21, 3}});
    }

    Eigen::MatrixXd matrix(int rows, int columns)
    {
        std::normal_distribution<double> normal;
        return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
    }
    void add_body(int size)
    {
        const Eigen::MatrixXd root = matrix(size, size);
        const Eigen::MatrixXd mass = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
        problem.blocks.push_back({problem.size, mass, mass.inverse()});
        problem.size += size;
    }
    void add_pair(std::initializer_list<std::pair<int, int>> parts)  // first coordinate, and how many
    {
        PairRow& row = problem.rows.emplace_back();
        for (const auto& [first, count] : parts)
            row.parts[static_cast<std::size_t>(row.part_count++)] = {first, matrix(3, count)};
    }
    /// J of a pair over all coordinates.
    Eigen::MatrixXd rates_of(const PairRow& row) const
    {
        Eigen::MatrixXd j = Eigen::MatrixXd::Zero(3, problem.size);
        for (const VertexMotion& part : row.moving())
            j.middleCols(part.first, part.rate.cols()) += part.rate;
        return j;
    }
};

/// A particle of 2 kg on a plane, which comes down at an angle.
ContactProblem sliding_particle(double dt, double stiffness)
{
    ContactProblem problem;
    problem.step = {1, dt};
    problem.blocks.push_back({0, 2 * Mat3::Identity(), 0.5 * Mat3::Identity()});
    problem.size = 3;
    PairRow& row = problem.rows.emplace_back();
    row.law.stiffness = stiffness;
    row.law.mu = 0.5;
    row.velocity = Vec3(0.3, -1, 0.1);
    row.parts[0] = {0, Mat3::Identity()};
    row.part_count = 1;
    return problem;
}

}  // namespace

TEST_CASE(
    "contact problem: a pair's response is J A^-1 J^T, also where it touches coupled vertices of one body")
{
    const CoupledBodies bodies(0.004);
    const ContactProblem& problem = bodies.problem;
    Eigen::MatrixXd response = Eigen::MatrixXd::Zero(problem.size, problem.size);
    for (const BodyBlock& block : problem.blocks)
        response.block(block.first, block.first, block.size(), block.size()) = block.mass.inverse();
    for (const PairRow& row : problem.rows) {
        const Eigen::MatrixXd j = bodies.rates_of(row);
        const Mat3 expected = j * response * j.transpose();
        CHECK((row.response(problem.blocks) - expected).norm() <= 1e-9 * expected.norm());
    }
}

TEST_CASE("contact problem: the residual is measured against the least speed where pairs push less than that")
{
    const ContactProblem problem = sliding_particle(0.004, 1e3);
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(3);
    const Answers answers = answers_to(problem, none);
    const double speed = answers.total.norm() / std::sqrt(2.0);  // A^-1 is a half
    CHECK(residual_of(problem, none, 0) == doctest::Approx(1));
    CHECK(residual_of(problem, none, 10 * speed) == doctest::Approx(0.1));
}

TEST_CASE("newton matrix: what cannot be factored or solved moves nothing")
{
    CoupledBodies bodies(0.01);
    const std::vector<Mat3> stiff(bodies.problem.rows.size(), 10 * Mat3::Identity());
    Eigen::VectorXd b = Eigen::VectorXd::Ones(bodies.problem.size);
    b[2] = std::numeric_limits<double>::quiet_NaN();
    NewtonMatrix matrix;
    CHECK(matrix.solve(bodies.problem, stiff, b).isZero(0));
    bodies.problem.blocks[0].mass *= -1;
    NewtonMatrix not_positive;
    const std::vector<Mat3> soft(bodies.problem.rows.size(), 1e-6 * Mat3::Identity());
    CHECK(not_positive.solve(bodies.problem, soft, Eigen::VectorXd::Ones(bodies.problem.size)).isZero(0));
}

TEST_CASE("newton matrix: another number of pairs needs another factor, though the first ones are as before")
{
    CoupledBodies bodies(0.01);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(bodies.problem.size, -1, 1);
    std::vector<Mat3> stiff(bodies.problem.rows.size(), 10 * Mat3::Identity());
    NewtonMatrix kept, fresh;
    ContactProblem fewer = bodies.problem;
    fewer.rows.pop_back();
    kept.solve(bodies.problem, stiff, b);
    stiff.pop_back();
    CHECK((kept.solve(fewer, stiff, b) - fresh.solve(fewer, stiff, b)).norm() <= 1e-12);
    CHECK(kept.solves() == 2);
    kept.begin_response(2);
    CHECK(kept.solves() == 2);
    kept.begin_response(0);
    CHECK(kept.solves() == 0);
}

TEST_CASE("dual friction: a guess that is led from a pair that holds to one that slips fits there")
{
    ContactProblem problem = sliding_particle(0.004, 1e5);
    problem.rows[0].law.lagged_normal_impulse = 0.3;
    const Vec3 along(0.3, 0, 0.1);                  // it would slip
    const Vec3 nearly = -along + Vec3(0, 0, 2e-3);  // with this it holds
    DualFriction friction(problem);
    const Vec3 before = problem.rows[0].velocity;
    friction.follow({before + Vec3(1, 0, -2)}, {Vec3(0.1, 0, 0.2)});  // led elsewhere before
    friction.follow({before + nearly}, {-nearly});
    const PairPush own = pushed(problem.rows[0].law, problem.rows[0].velocity, problem.step);
    const Mat3 hessian = hessian_of(problem.rows[0].law, own, problem.step);
    REQUIRE(own.slips);
    REQUIRE_FALSE(pushed(problem.rows[0].law, problem.rows[0].velocity + nearly, problem.step).slips);
    CHECK((friction.hessians(answers_at(problem, {before}).pushes, {before})[0] - hessian).norm() <=
          1e-9 * hessian.norm());
}
