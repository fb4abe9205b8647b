#pragma once

#include "common/worked_step/step_record.hpp"
#include "common/worked_step/worked_step.hpp"

#include <doctest/doctest.h>

namespace enduring::tests {

inline void check_equal(const std::vector<Vec3>& found, const std::vector<Vec3>& expected)
{
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        CHECK((found[i] - expected[i]).norm() < 1e-14);
    }
}

/// Checks that a chapter's solver ends the book's worked step as the step worked by hand ends.
inline void check_worked_step(const Solver& solver)
{
    WorkedStep by_hand = worked_step(), by_solver = worked_step();
    const StageRecord expected = record_step(by_hand.world, by_hand.contacts,
                                             worked_step_solver(by_hand.stiffness), by_hand.dt)
                                     .back();
    const StageRecord found = record_step(by_solver.world, by_solver.contacts, solver, by_solver.dt).back();
    for (std::size_t body = 0; body < 2; ++body) {
        check_equal(found.bodies[body].velocities, expected.bodies[body].velocities);
        check_equal(found.bodies[body].positions_t0, expected.bodies[body].positions_t0);
    }
    REQUIRE(found.contacts.size() == expected.contacts.size());
    for (std::size_t i = 0; i < expected.contacts.size(); ++i) {
        CAPTURE(i);
        CHECK(found.contacts[i].vertices == expected.contacts[i].vertices);
        for (std::size_t j = 0; j < 4; ++j)
            CHECK(found.contacts[i].weights[j] ==
                  doctest::Approx(expected.contacts[i].weights[j]).epsilon(1e-14));
        // what the query promises
        CHECK(found.contacts[i].start == doctest::Approx(expected.contacts[i].start).epsilon(1e-6));
        CHECK((found.contacts[i].impulse - expected.contacts[i].impulse).norm() < 1e-14);
    }
}

}  // namespace enduring::tests
