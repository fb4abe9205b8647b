#include "chapters/11_exact_contact/force_memory.hpp"

#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "chapters/11_exact_contact/spring_pass.hpp"
#include "chapters/11_exact_contact/tests/one_block.hpp"
#include "chapters/11_exact_contact/tests/row_of_blocks.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace enduring;

namespace {

FrictionProblem public_problem(const char* name)
{
    return read_problem(source_directory() / "chapters/11_exact_contact/problems" / name);
}

}  // namespace

TEST_CASE("force memory: one block holds, slides and flies as with pencil and paper, from h = 1e2 to 1e6")
{
    for (const HandSolved& block : hand_solved_blocks())
        for (const double h : {1e2, 1e4, 1e6}) {
            CAPTURE(block.name);
            CAPTURE(h);
            const ExactSolution solution = solve_exactly(block.problem, {.h = h, .tolerance = 1e-12});
            CHECK((solution.impulses - block.impulse).norm() <= 1e-10);
            CHECK(natural_map_error(block.problem, solution.impulses) == solution.error);
        }
}

TEST_CASE(
    "force memory: a block that holds on springs moves by 1 / (1 + h) of its speed, and a pass leaves this part of it")
{
    // m (u - q) = -k dt^2 u, so u = q / (1 + h), and the next pass begins with this error
    const HandSolved block = hand_solved_blocks().front();
    for (const double h : {10.0, 1e2, 1e3}) {
        ExactSettings settings{.h = h, .keeps_h = true, .tolerance = 1e-13};
        settings.max_passes = 3;
        const ExactSolution solution = solve_exactly(block.problem, settings);
        REQUIRE(solution.errors.size() == 3);
        for (int pass = 0; pass < 3; ++pass) {
            const double left = std::pow(1 / (1 + h), pass + 1);
            // r is short by m u; natural map of a contact that holds: the lifted velocity where the cone does
            // not bend it
            const Vec3 velocity = left * block.problem.free_velocity;
            const Vec3 impulse = 2 * (velocity - block.problem.free_velocity);
            const double expected = natural_map(impulse, velocity, block.problem.mu[0]).norm() /
                                    block.problem.free_velocity.norm();
            CHECK(solution.errors[static_cast<std::size_t>(pass)] == doctest::Approx(expected).epsilon(1e-3));
        }
    }
}

TEST_CASE("force memory: a remembered spring pushes the same impulse where nothing moves")
{
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 20; ++i) {
        const double along = std::abs(normal(random)), angle = normal(random), part = 0.49 * along;
        const Eigen::VectorXd impulse = Vec3(along, part * std::cos(angle), part * std::sin(angle));
        FrictionProblem problem = one_block({-1, 0, 0}, 0.5);
        problem.free_velocity = -(problem.response * impulse);  // so W r + q = 0
        const SpringPass pass{problem, felt_masses(problem), 1e3, impulse};
        const PassAnswer answer = solve_pass(pass, 10);
        CHECK(answer.reached);
        CHECK((answer.impulses - impulse).norm() <= 1e-12 * along);
    }
}

TEST_CASE("force memory: contacts of random bodies are solved, also more of them than bodies can move")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        FrictionProblem problem;
        const int contacts = 12, coordinates = seed % 2 == 0 ? 60 : 18;
        Eigen::MatrixXd levers(coordinates, 3 * contacts);
        for (double& x : levers.reshaped())
            x = normal(random);
        problem.response = Eigen::MatrixXd(levers.transpose() * levers).sparseView();
        problem.free_velocity = Eigen::VectorXd(
            levers.transpose() * Eigen::VectorXd::NullaryExpr(coordinates, [&] { return normal(random); }));
        problem.mu = Eigen::VectorXd::Constant(contacts, 0.3);
        const ExactSolution solution = solve_exactly(problem);
        CAPTURE(seed);
        CHECK(solution.error <= 1e-8);
        CHECK(solution.newton_steps <= ExactSettings{}.max_newton_steps);
    }
}

TEST_CASE("force memory: a response that is not symmetric is solved as it stands")
{
    FrictionProblem problem = one_block({-1, 0.3, 0.4}, 0.6);
    problem.response.coeffRef(0, 1) = 0.02;
    problem.response.coeffRef(1, 0) = 0.05;
    const ExactSolution solution = solve_exactly(problem);
    CHECK(solution.error <= 1e-9);
    // it holds: W r = -q
    const Eigen::Vector3d expected = Eigen::Matrix3d(problem.response).inverse() * -problem.free_velocity;
    CHECK((solution.impulses - expected).norm() <= 1e-7);
}

TEST_CASE("force memory: public problems are solved, with fewer steps than the bound")
{
    for (const char* name : {"Box_Stacks-i0122-82-5.hdf5", "Rover1040.dat", "NESpheres_10_1.dat",
                             "Confeti-ex03-Fc3D-SBM.dat", "GFC3D_TwoRods1.dat"}) {
        CAPTURE(name);
        FrictionProblem problem;
        try {
            problem = public_problem(name);
        } catch (const InputError& error) {
            REQUIRE(std::string(error.what()).find("without libhdf5") != std::string::npos);
            continue;
        }
        const ExactSolution solution = solve_exactly(problem);
        CHECK(solution.solved());
        CHECK(natural_map_error(problem, solution.impulses) <= 1e-8);
        CHECK(solution.newton_steps < ExactSettings{}.max_newton_steps);
    }
}

TEST_CASE("force memory: what is solved does not depend on the springs' first stiffness")
{
    for (const double h : {1e2, 1e4, 1e6, 4e6, 1e10})
        for (const char* name :
             {"OneObject-i100000-316.hdf5.dat", "Confeti-ex03-Fc3D-SBM.dat", "Rover1039.dat", "Rover1040.dat",
              "Rover3865.dat", "Rover4396.dat", "GFC3D_Example00.dat", "GFC3D_TwoRods1.dat",
              "NESpheres_10_1.dat", "FrictionContactProblem00031.dat", "FrictionContact3D_RR_1c.dat"}) {
            CAPTURE(name);
            CAPTURE(h);
            const ExactSolution solution = solve_exactly(public_problem(name), {.h = h});
            CHECK(solution.solved());
            CHECK(solution.newton_steps < ExactSettings{}.max_newton_steps);
        }
}

TEST_CASE("force memory: passes take the error of a public problem to less than a thousandth")
{
    const ExactSolution solution = solve_exactly(public_problem("Confeti-ex03-Fc3D-SBM.dat"),
                                                 {.sweeps = false, .tolerance = 1e-12});
    CHECK(solution.errors.front() >= 1e3 * solution.error);
    CHECK(solution.errors.size() == solution.steps.size());
}

TEST_CASE("force memory: bodies and their contacts' response have the same answer")
{
    FrictionProblem problem = public_problem("GFC3D_Example00.dat");
    const ExactSolution by_bodies = solve_exactly(problem);
    problem.bodies.reset();
    const ExactSolution by_response = solve_exactly(problem);
    CHECK((by_bodies.impulses - by_response.impulses).norm() <= 1e-7 * by_bodies.impulses.norm());
}

namespace {

/// Cubes of these masses on each other, four contacts each, given by W alone, which then has no inverse.
FrictionProblem tower_of(const std::vector<double>& masses)
{
    const auto count = static_cast<Eigen::Index>(masses.size());
    Eigen::MatrixXd levers = Eigen::MatrixXd::Zero(6 * count, 12 * count);
    Eigen::VectorXd falling = Eigen::VectorXd::Zero(6 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const double root = std::sqrt(masses[static_cast<std::size_t>(i)]), turning = root / std::sqrt(6.0);
        falling[6 * i] = -0.0981 * root;  // the first number is along the normal
        falling[6 * i + 1] = 0.001 * root;
        for (int corner = 0; corner < 4; ++corner)
            for (const bool below : {false, true}) {
                if (!below && i + 1 == count)
                    continue;
                const Eigen::Index first = 12 * (below ? i : i + 1) + 3 * corner;
                const Vec3 arm(below ? -0.5 : 0.5, corner & 1 ? 0.45 : -0.45, corner & 2 ? 0.45 : -0.45);
                for (int k = 0; k < 3; ++k) {
                    const Vec3 axis = (below ? 1.0 : -1.0) * Vec3::Unit(k);
                    levers.block<3, 1>(6 * i, first + k) = axis / root;
                    levers.block<3, 1>(6 * i + 3, first + k) = arm.cross(axis) / turning;
                }
            }
    }
    FrictionProblem problem;
    problem.response = Eigen::MatrixXd(levers.transpose() * levers).sparseView();
    problem.free_velocity = levers.transpose() * falling;
    problem.mu = Eigen::VectorXd::Constant(4 * count, 0.5);
    return problem;
}

}  // namespace

TEST_CASE("force memory: towers of which only W is known are solved with masses up to 1 : 1e6")
{
    for (const double ratio : {1.0, 1e4, 1e5, 1e6})
        for (const std::vector<double>& masses :
             {std::vector<double>{1, ratio}, {ratio, 1}, {1, 1, ratio}, {1, ratio, 1, ratio, 1}}) {
            CAPTURE(ratio);
            CAPTURE(masses.size());
            CHECK(solve_exactly(tower_of(masses)).solved());
            CHECK(solve_exactly(tower_of(masses), {.sweeps = false}).solved());
        }
}

TEST_CASE("force memory: contacts whose units differ by a thousand are solved")
{
    for (unsigned seed = 0; seed < 5; ++seed) {
        std::mt19937 random(seed);
        FrictionProblem problem = tower_of({1, 1, 10});
        Eigen::VectorXd scale(problem.free_velocity.size());
        for (int i = 0; i < problem.contacts(); ++i)
            scale.segment<3>(3 * i).setConstant(random() % 2 == 0 ? 1e-3 : 1e3);
        problem.response =
            Eigen::MatrixXd(scale.asDiagonal() * Eigen::MatrixXd(problem.response) * scale.asDiagonal())
                .sparseView(0, 0);
        problem.free_velocity = scale.cwiseProduct(problem.free_velocity).eval();
        CAPTURE(seed);
        CHECK(solve_exactly(problem).solved());
        CHECK(solve_exactly(problem, {.sweeps = false}).solved());
    }
}

TEST_CASE("force memory: a pass does not depend on the units of mass and length, to the last bit")
{
    const FrictionProblem problem = tower_of({1, 100, 3});
    // powers of two, so that no product is rounded: r in other units of impulse, u in others of velocity
    for (const double impulse : {std::ldexp(1, -20), std::ldexp(1, 24)})
        for (const double velocity : {std::ldexp(1, -10), std::ldexp(1, 12)}) {
            FrictionProblem other = problem;
            other.response *= velocity / impulse;
            other.free_velocity *= velocity;
            const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.free_velocity.size());
            const PassAnswer one = solve_pass({problem, felt_masses(problem), 1e6, none}, 100),
                             two = solve_pass({other, felt_masses(other), 1e6, none}, 100);
            CHECK(one.newton_steps == two.newton_steps);
            CHECK(impulse * one.impulses == two.impulses);
        }
}

TEST_CASE("force memory: more than a hundred thousand numbers of W, most of them zero, are factored sparse")
{
    CHECK(solve_exactly(tests::row_of_blocks(1500), {.sweeps = false}).solved());
}
