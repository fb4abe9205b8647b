#include "common/simulation/rigid_body.hpp"
#include "common/simulation/step.hpp"

#include "common/geometry/box_shapes.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

World one_box()
{
    World world;
    const SurfaceMesh mesh = box(Vec3(1, 1, 1));
    world.bodies.push_back(
        std::make_unique<RigidBody>("box", mesh, mass_properties(mesh, 1000), Vec3::Zero(), Vec3::Zero()));
    return world;
}

/// What a jam needs: its parts are not solved if they are longer, and no shorter ones are tried then.
struct Jam {
    double longest = 1;  ///< part that is solved [s]
    double kept = 0;     ///< longest part that is kept without [s]
};

Solver jammed(const Jam& jam, StepTrouble trouble = StepTrouble::unsolved)
{
    Solver solver;
    solver.max_halvings = 5;
    solver.append(StepStage::refresh, "solve", [&jam, trouble](World& world, Contacts&, double dt) {
        if (dt <= jam.longest)
            return;
        if (dt <= jam.kept)
            world.attempt.is_kept_unsolved = true;
        else
            world.attempt.trouble = trouble;
    });
    return solver;
}

long attempts_of_a_step(World& world, const Solver& solver)
{
    Contacts contacts;
    advance(world, contacts, solver, 0.01);
    return world.work.attempts;
}

}  // namespace

TEST_CASE(
    "learned parts: as long as parts stay unsolved, no step tries the longer ones that were not solved before")
{
    Jam jam{.longest = 0.001, .kept = 0.003};
    World world = one_box();
    const Solver solver = jammed(jam);
    CHECK(attempts_of_a_step(world, solver) == 6);  // a whole, one half, four quarters
    CHECK(attempts_of_a_step(world, solver) == 4);
    CHECK(attempts_of_a_step(world, solver) == 4);
    CHECK(world.time == doctest::Approx(0.03));
    jam = {.longest = 0.006};  // the jam gives way
    CHECK(attempts_of_a_step(world, solver) <= 4);
    jam.longest = 1;
    attempts_of_a_step(world, solver);
    CHECK(attempts_of_a_step(world, solver) == 1);
    CHECK(world.learned_halvings == 0);
}

TEST_CASE("learned parts: what is thrown away for another reason, or solved in parts, teaches nothing")
{
    const Jam jam{.longest = 0.003};
    for (const StepTrouble trouble : {StepTrouble::too_deep, StepTrouble::unsolved}) {
        World world = one_box();
        const Solver solver = jammed(jam, trouble);
        attempts_of_a_step(world, solver);
        CHECK(world.learned_halvings == 0);
        CHECK(attempts_of_a_step(world, solver) == 7);
    }
}
