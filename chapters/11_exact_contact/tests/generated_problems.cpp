#include "chapters/11_exact_contact/experiments/generated_problems.hpp"

#include "chapters/11_exact_contact/force_memory.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>

using namespace enduring;

TEST_CASE("generated problems: there are 54 of five kinds, each symmetric and with another name")
{
    for (const unsigned set : {0, 1, 77}) {
        std::map<std::string, int> of_kind;
        std::set<std::string> names;
        for (const auto& [kind, named] : chapter11::generated_problems(set)) {
            ++of_kind[kind];
            names.insert(named.name);
            const Eigen::MatrixXd response(named.problem.response);
            CHECK((response - response.transpose()).norm() <= 1e-14 * response.norm());
        }
        CHECK(names.size() == 54);
        CHECK(of_kind == std::map<std::string, int>{
                             {"tower", 16}, {"packing", 12}, {"graph", 12}, {"dense", 9}, {"scaled", 5}});
    }
}

TEST_CASE("generated problems: those of up to 30 contacts are solved")
{
    for (const auto& [kind, named] : chapter11::generated_problems())
        if (named.problem.contacts() <= 30) {
            CAPTURE(named.name);
            CHECK(solve_exactly(named.problem).solved());
        }
}

TEST_CASE(
    "generated problems: a tower of another seed that 2,000 steps of Newton's method do not solve is solved")
{
    for (const auto& [kind, named] : chapter11::generated_problems(1))
        if (named.name == "16_tower") {
            CHECK_FALSE(solve_exactly(named.problem, {.max_newton_steps = 2000}).solved());
            CHECK(solve_exactly(named.problem).solved());
        }
}

TEST_CASE("generated problems: a seed gives the same problems again, and another seed others of each kind")
{
    const auto one = chapter11::generated_problems(5), again = chapter11::generated_problems(5),
               other = chapter11::generated_problems(6);
    for (std::size_t i = 0; i < one.size(); ++i) {
        const Eigen::VectorXd& q = one[i].named.problem.free_velocity;
        CAPTURE(one[i].named.name);
        CHECK(q == again[i].named.problem.free_velocity);
        const Eigen::VectorXd& p = other[i].named.problem.free_velocity;
        CHECK_FALSE((p.size() == q.size() && p == q &&
                     one[i].named.problem.response.norm() == other[i].named.problem.response.norm() &&
                     one[i].kind != "scaled"));
    }
}
