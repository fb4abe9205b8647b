#include "chapters/07_implicit_contact/limit_search.hpp"
#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "chapters/07_implicit_contact/tests/random_problem.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// One pair whose normal impulse a test chooses, by the velocity that it gives its body.
struct OnePair {
    ContactProblem problem;
    LimitSearch search;

    OnePair()
    {
        problem.step = {1, 0.004};
        problem.blocks.push_back({0, Mat3::Identity(), Mat3::Identity()});
        problem.size = 3;
        PairRow& row = problem.rows.emplace_back();
        row.law.stiffness = 1e5;
        row.law.mu = 0.5;
        row.law.lagged_normal_impulse = 1;
        row.parts[0] = {0, Mat3::Identity()};
        row.part_count = 1;
    }
    double limit() const { return problem.rows[0].law.lagged_normal_impulse; }
    /// A round whose answer presses with this [N s].
    void round(double impulse)
    {
        const double dt = problem.step.dt;
        search.advance(problem, Vec3(0, -impulse / (1e5 * dt * dt), 0));
    }
};

/// Bodies that are pressed onto planes and slide there; each second one has a pair with the next one.
ContactProblem sliding_bodies(int bodies)
{
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    ContactProblem problem;
    problem.step = {1, 0.004};
    for (int i = 0; i < bodies; ++i) {
        problem.blocks.push_back({problem.size, (1 + i) * Mat3::Identity(), Mat3::Identity() / (1 + i)});
        problem.size += 3;
    }
    for (int i = 0; i < bodies; ++i) {
        PairRow& row = problem.rows.emplace_back();
        row.law.normal = vector().normalized();
        row.law.stiffness = 1e6;
        row.law.mu = 0.4;
        row.law.lagged_normal_impulse = 0.5;
        row.velocity = 2 * vector() - 2 * row.law.normal;
        row.parts[0] = {3 * i, Mat3::Identity()};
        row.parts[1] = {3 * ((i + 1) % bodies), -Mat3::Identity()};
        row.part_count = i % 2 == 0 ? 1 : 2;
    }
    return problem;
}

}  // namespace

TEST_CASE("limit search: where limits follow their answer by a factor, few rounds find where they agree")
{
    for (const double factor : {-8.0, -0.5, 0.3, 0.9}) {
        OnePair pair;
        const double agree = 5;
        for (int round = 0; round < 12; ++round)
            pair.round(std::max(0.0, agree + factor * (pair.limit() - agree)));
        CAPTURE(factor);
        CHECK(pair.limit() == doctest::Approx(agree).epsilon(1e-6));
    }
}

TEST_CASE(
    "limit search: the part of an error that a round takes at most doubles, and is at most 64, and no limit is negative")
{
    OnePair pair;
    double part = 1;
    for (int round = 0; round < 12; ++round) {  // an error that hardly changes
        const double before = pair.limit(), error = 1e-3 * std::pow(0.8, round);
        pair.round(before + error);
        const double now = (pair.limit() - before) / error;
        CAPTURE(round);
        CHECK(now == doctest::Approx(part).epsilon(1e-6));
        part = std::min(64.0, 2 * part);
    }
    OnePair falling;
    for (int round = 0; round < 3; ++round) {
        falling.round(std::max(0.0, falling.limit() - 0.3));
        CHECK(falling.limit() >= 0);
    }
    CHECK(falling.limit() == 0);
}

TEST_CASE(
    "limit search: it begins with the limits that it is given, and counts each step of Newton's method once")
{
    const ContactProblem problem = sliding_bodies(20);
    NewtonMatrix matrix, other;
    const ProblemSolution plain = solve_convex(problem, other, unchanged(problem), 1e-9, 1e-9);
    REQUIRE(plain.newton_steps > 2);
    const ProblemSolution first = solve_with_limit_search(problem, matrix, unchanged(problem), 1e-9, 1e-9, 1),
                          once = solve_convex(problem, other, unchanged(problem), 1e-9, 1e-9, 1);
    CHECK((first.change - once.change).norm() <= 1e-12 * once.change.norm());
    for (const int most : {1, 3, 7, 500}) {
        NewtonMatrix counting;
        const ProblemSolution solution = solve_with_limit_search(problem, counting, unchanged(problem), 1e-9,
                                                                 1e-9, most);
        CAPTURE(most);
        CHECK(solution.newton_steps == counting.solves());
        CHECK(solution.newton_steps <= most);
    }
}

TEST_CASE("limit search: as many rounds as steps of Newton's method may be taken, each round counts as one")
{
    ContactProblem problem = sliding_bodies(20);
    for (PairRow& row : problem.rows)
        row.law.mu = 3;
    for (const int most : {4, 10, 20}) {
        NewtonMatrix counting;
        const ProblemSolution solution = solve_with_limit_search(problem, counting, unchanged(problem), 1e-14,
                                                                 1e-9, most);
        CAPTURE(most);
        CHECK(solution.newton_steps < most);  // the rounds themselves are the rest
    }
}

TEST_CASE("contact problem: every random one is solved with the limits of friction that its answer makes")
{
    for (unsigned seed = 0; seed < 60; ++seed)
        for (const double stiffness : {1e2, 1e5}) {
            ContactProblem problem = random_problem(seed, 3 + static_cast<int>(seed % 10),
                                                    20 + static_cast<int>(seed), stiffness);
            NewtonMatrix matrix;
            const ProblemSolution solution = solve_with_limit_search(problem, matrix, unchanged(problem),
                                                                     1e-9, 1e-9, 500);
            CAPTURE(seed);
            CAPTURE(stiffness);
            CHECK(true_residual(problem, solution.change, 1e-9) <= 1e-9);
            for (PairRow& row : problem.rows) {
                row.law.lagged_normal_impulse = normal_impulse(row.law, row.velocity_after(solution.change),
                                                               problem.step);
                const PairPush made = pushed(row.law, row.velocity_after(solution.change), problem.step);
                CHECK(made.friction.norm() <= row.law.mu * made.normal_impulse.norm() * (1 + 1e-6) + 1e-9);
            }
        }
}

TEST_CASE(
    "contact problem: random pairs that jam, as stiff as a ton asks for and as rough as rubber, are solved, nine of ten")
{
    int solved = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        ContactProblem problem = random_problem(seed, 3 + static_cast<int>(seed % 10),
                                                20 + static_cast<int>(seed), 1e8);
        for (PairRow& row : problem.rows)
            row.law.mu = 1;
        NewtonMatrix matrix;
        const ProblemSolution solution = solve_with_limit_search(problem, matrix, unchanged(problem), 1e-9,
                                                                 1e-9, 1000);
        solved += true_residual(problem, solution.change, 1e-9) <= 1e-8;
    }
    CHECK(solved >= 27);
}

TEST_CASE("limit search: where an error of the limits returns enlarged, it finds the limits all the same")
{
    // A body slides down between two sides, each of which it presses by its weight less what friction holds.
    const double rub = 5;  // mu over the tangent of half the angle
    ContactProblem problem;
    problem.step = {1, 0.01};
    BodyBlock block{0, Mat3::Identity(), {}};
    block.response = block.mass.inverse();
    problem.blocks.push_back(block);
    problem.size = 3;
    const double angle = std::atan(1 / rub);
    for (const double side : {-1.0, 1.0}) {
        PairRow row;
        row.law.normal = Vec3(-side * std::cos(angle), std::sin(angle), 0);
        row.law.stiffness = 1e6;
        row.law.mu = 1;
        row.law.lagged_normal_impulse = 1;
        row.law.stretch = -0.01 * Vec3(side * std::sin(angle), std::cos(angle), 0);
        row.velocity = Vec3(0, -1, 0);
        row.parts[0] = {0, Mat3::Identity()};
        row.part_count = 1;
        problem.rows.push_back(row);
    }
    LimitSearch limits;
    double error = 0;
    for (int round = 0; round < 12; ++round) {
        const Eigen::VectorXd change = solved(problem, 1e-12).change;
        const PairRow& row = problem.rows[0];
        error = std::abs(pushed(row.law, row.velocity_after(change), problem.step).normal_impulse.norm() -
                         row.law.lagged_normal_impulse);
        limits.advance(problem, change);
    }
    CHECK(problem.rows[0].law.lagged_normal_impulse > 0);
    CHECK(error <= 1e-6 * problem.rows[0].law.lagged_normal_impulse);
}
