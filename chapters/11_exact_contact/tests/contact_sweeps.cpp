#include "chapters/11_exact_contact/contact_sweeps.hpp"

#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "chapters/11_exact_contact/tests/one_block.hpp"
#include "chapters/11_exact_contact/tests/row_of_blocks.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

FrictionProblem public_problem(const char* name)
{
    return read_problem(source_directory() / "chapters/11_exact_contact/problems" / name);
}

}  // namespace

TEST_CASE("contact sweeps: a block that holds, slides or flies has the impulse of pencil and paper")
{
    for (const HandSolved& block : hand_solved_blocks()) {
        CAPTURE(block.name);
        const SweepAnswer answer = sweep_contacts(block.problem, 1e-12, {.newton_steps = 1e6});
        CHECK((answer.impulses - block.impulse).norm() <= 1e-10);
        CHECK(answer.error == natural_map_error(block.problem, answer.impulses));
    }
}

TEST_CASE("contact sweeps: they end where steps of Newton's method cost less, and what they bring is kept")
{
    const FrictionProblem problem = public_problem("OneObject-i100000-316.hdf5.dat");
    const SweepAnswer few = sweep_contacts(problem, 1e-9, {.newton_steps = 1}),
                      many = sweep_contacts(problem, 1e-9, {.newton_steps = 1e6});
    CHECK(few.sweeps < many.sweeps);
    CHECK(many.error <= few.error);
    CHECK(many.error <= 1e-9);
    const double nothing = natural_map_error(problem, Eigen::VectorXd::Zero(problem.free_velocity.size()));
    CHECK(few.error < nothing);
}

TEST_CASE("contact sweeps: passes that begin with them take fewer steps of Newton's method")
{
    for (const char* name : {"NESpheres_10_1.dat", "Rover1039.dat", "OneObject-i100000-316.hdf5.dat"}) {
        CAPTURE(name);
        const FrictionProblem problem = public_problem(name);
        const ExactSolution swept = solve_exactly(problem), plain = solve_exactly(problem, {.sweeps = false});
        CHECK(swept.solved());
        CHECK(plain.solved());
        CHECK(plain.sweeps == 0);
        CHECK(swept.sweeps > 0);
        CHECK(swept.newton_steps < plain.newton_steps + 3);
    }
}

TEST_CASE("contact sweeps: six thousand contacts are solved without a matrix of all of them")
{
    const FrictionProblem problem = tests::row_of_blocks(6602);
    const ExactSolution solution = solve_exactly(problem);
    CHECK(solution.solved());
    CHECK(solution.newton_steps == 0);
}

TEST_CASE("contact sweeps: two thousand contacts in the plane are solved, and seven thousand")
{
    for (const int contacts : {2020, 7002}) {
        FrictionProblem flat = tests::row_of_blocks(contacts);
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < 2 * contacts; ++i) {
            entries.emplace_back(i, i, 2.0);
            if (i >= 2) {
                entries.emplace_back(i, i - 2, -0.5);
                entries.emplace_back(i - 2, i, -0.5);
            }
        }
        flat.dimension = 2;
        flat.response.resize(2 * contacts, 2 * contacts);
        flat.response.setFromTriplets(entries.begin(), entries.end());
        flat.free_velocity = Eigen::Vector2d(-1, 0.4).replicate(contacts, 1);
        CHECK(solve_exactly(flat).solved());
    }
}

TEST_CASE("contact sweeps: they end after so many operations")
{
    const FrictionProblem problem = public_problem("OneObject-i100000-316.hdf5.dat");
    const SweepAnswer answer = sweep_contacts(problem, 1e-12, {.newton_steps = 1e6, .max_operations = 1e5});
    CHECK(answer.sweeps > 0);
    CHECK(answer.sweeps <= 15);  // 1,860 numbers of W and 25 contacts: some 11,000 operations a sweep
}
