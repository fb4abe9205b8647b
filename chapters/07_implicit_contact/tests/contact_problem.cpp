#include "chapters/07_implicit_contact/contact_problem.hpp"

#include "chapters/07_implicit_contact/implicit_particle.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"
#include "chapters/07_implicit_contact/tests/random_problem.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

TEST_CASE("contact problem: one particle on a plane moves as the implicit particle does")
{
    for (const double h : {0.1, 16.0, 1000.0})
        for (const double height : {0.01, 0.0, -0.02}) {
            ImplicitParticle particle{2,       h * 2 / (0.01 * 0.01),        9.81,
                                      2.0 / 3, PositionUpdate::end_velocity, 0.01};
            const ParticleState expected = step({height, -1.5}, particle);

            ContactProblem problem;
            problem.step = {particle.centre, particle.dt};
            BodyBlock block{0, 2 * Mat3::Identity(), {}};
            block.response = block.mass.inverse();
            problem.blocks.push_back(block);
            problem.size = 3;
            PairRow row;
            row.law.depth_t0 = height;
            row.law.stiffness = particle.stiffness;
            row.velocity = Vec3(0, -1.5 - 9.81 * particle.dt, 0);
            row.parts[0] = {0, Mat3::Identity()};
            row.part_count = 1;
            problem.rows.push_back(row);
            const ProblemSolution solution = solved(problem, 1e-12);
            CHECK(solution.converged);
            CHECK(row.velocity_after(solution.change).y() ==
                  doctest::Approx(expected.velocity).epsilon(1e-9));
        }
}

TEST_CASE("contact problem: every random one is solved, whatever the stiffness and the masses")
{
    for (unsigned seed = 0; seed < 60; ++seed)
        for (const double stiffness : {1e2, 1e5, 1e8}) {
            const ContactProblem problem = random_problem(seed, 3 + static_cast<int>(seed % 10),
                                                          20 + static_cast<int>(seed), stiffness);
            const ProblemSolution solution = solved(problem, 1e-8);
            CAPTURE(seed);
            CAPTURE(stiffness);
            CHECK(solution.converged);
            CHECK(residual_of(problem, solution.change, 1e-9) <= 1e-8);
            CHECK(solution.newton_steps <= 25);
        }
}

TEST_CASE("contact problem: its impulses make its change, also where it is solved roughly")
{
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const double tolerance : {0.3, 0.01, 1e-6}) {
            ContactProblem problem = random_problem(seed, 5, 30, 1e5);
            for (PairRow& row : problem.rows)
                row.acting = 0.1 * row.law.normal;
            const ProblemSolution solution = solved(problem, tolerance);
            Eigen::VectorXd momentum = Eigen::VectorXd::Zero(problem.size);
            for (std::size_t i = 0; i < problem.rows.size(); ++i)
                problem.rows[i].add_impulse(
                    solution.impulses.segment<3>(static_cast<Eigen::Index>(3 * i)) - problem.rows[i].acting,
                    momentum);
            const Eigen::VectorXd wanted = times_mass(problem, solution.change);
            CHECK((momentum - wanted).norm() <= 1e-6 * wanted.norm());
            CHECK(solution.change.norm() > 0);
        }
}

TEST_CASE("contact problem: impulses that act already are not given twice")
{
    ContactProblem problem = random_problem(4, 5, 20, 1e4);
    const ProblemSolution first = solved(problem, 1e-12);
    for (PairRow& row : problem.rows) {
        const PairPush made = pushed(row.law, row.velocity_after(first.change), problem.step);
        row.acting = made.normal_impulse + made.friction;
        row.velocity = row.velocity_after(first.change);
    }
    CHECK(residual_of(problem, Eigen::VectorXd::Zero(problem.size), 1e-9) <= 1e-10);
    CHECK(solved(problem, 1e-9).newton_steps == 0);
}
