#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/run/energy_budget.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;
using namespace enduring::chapter09;

namespace {

/// What is missing in the budget of a cube that is let out [J]: all that came in less all that is there.
struct Missing {
    double most = 0;    ///< after any step
    double lifted = 0;  ///< what the fading rest offset put in
    double gained = 0;  ///< by the bodies
};

/// A step by symplectic Euler keeps the work of its impulses but for (change of velocity)^2 / 2, mass and
/// inertia.
double kept_by_the_step(const Vec3& velocity, const Vec3& spin, const Body& cube)
{
    const double inertia = cube.mass() * 0.4 * 0.4 / 6;  // the same about all axes
    return 0.5 * cube.mass() * (cube.mean_velocity() - velocity).squaredNorm() +
           0.5 * (cube.angular_momentum(cube.centre()) - spin).squaredNorm() / inertia;
}

Missing missing_in(const std::string& body, const Surroundings& surroundings)
{
    Scene scene = scene_inside(surroundings, body, 0.13, 0.01);
    const Solver solver = chapter09_solver(scene.contact);
    SpringLedger ledger(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity);
    const Body& cube = *scene.world.bodies.back();
    const double start = total_energy(scene.world).total();
    Contacts contacts;
    double stepping = 0;
    Missing missing;
    for (int step = 0; step < 200; ++step) {
        const Vec3 velocity = cube.mean_velocity(), spin = cube.angular_momentum(cube.centre());
        advance(scene.world, contacts, solver, scene.dt);
        ledger.add_step(scene.world, contacts, scene.dt);
        stepping += kept_by_the_step(velocity, spin, cube);
        const SpringAccounts& sums = ledger.accounts();
        missing.gained = total_energy(scene.world).total() - start;
        const double came = sums.born + sums.lifted + sums.jumped + sums.rubbed,
                     went = sums.died + sums.damped + stepping;
        missing.most = std::max(missing.most, std::abs(came - went - missing.gained - ledger.held()));
        missing.lifted = sums.lifted;
    }
    return missing;
}

}  // namespace

TEST_CASE(
    "energy accounts: a cube that separates gains what the fading rest offset put in, and the budget closes to rounding")
{
    for (const Surroundings& surroundings : {all_surroundings()[0], all_surroundings()[1]}) {
        CAPTURE(surroundings.name);
        const Missing upright = missing_in("block", surroundings);
        CHECK(upright.gained == doctest::Approx(20 * 9.81 * 0.13).epsilon(1e-3));
        CHECK(upright.lifted > upright.gained);
        CHECK(upright.most < 1e-7 * upright.gained);  // a tenth of what the solver may leave
        const Missing leaning = missing_in("leaning block", surroundings);
        CHECK(leaning.most < 0.05 * leaning.lifted);
    }
}

TEST_CASE("energy accounts: what separates from inside does not rub")
{
    Scene scene = scene_inside(all_surroundings()[0], "leaning block", 0.3, 0.01);
    SpringLedger ledger(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity);
    const double before = total_energy(scene.world).total();
    WatchProbe watch([&](const World& world, const Contacts& contacts, double dt) {
        if (world.step > 0)
            ledger.add_step(world, contacts, dt);
    });
    run(scene, chapter09_solver(scene.contact), {&watch}, {.steps = 220});
    const double gained = total_energy(scene.world).total() - before;
    CHECK(gained > 40);
    CHECK(ledger.accounts().lifted < 1.08 * gained);
}

TEST_CASE(
    "energy accounts: a run in which a body separates keeps to its budget, and one in which it is thrown does not")
{
    for (const Surroundings& surroundings : {all_surroundings()[0], all_surroundings()[1]}) {
        CAPTURE(surroundings.name);
        Scene scene = scene_inside(surroundings, "leaning block", 0.3, 0.01);
        CHECK_NOTHROW(run(scene, chapter09_solver(scene.contact), {}, {.steps = 200}));
    }
    Scene scene = scene_inside(all_surroundings()[0], "leaning block", 0.4, 0.01);
    Solver throwing = chapter09_solver(scene.contact);
    throwing.append(StepStage::refresh, "no rest offset", [](World&, Contacts& contacts, double) {
        for (Contact& contact : contacts)
            contact.spring.rest_offset = 0;
    });
    CHECK_THROWS_AS(run(scene, throwing, {}, {.steps = 200}), std::runtime_error);
}

TEST_CASE(
    "energy accounts: in a tower exactly edge on edge pairs that begin and end bring less than 0.1 % of the impact")
{
    Scene scene = load_scene(scene_file("tower"));
    SpringLedger ledger(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity);
    const double before = total_energy(scene.world).total();
    double gained = 0, brought = 0;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double dt) {
        if (world.step > 0)
            ledger.add_step(world, contacts, dt);
        gained = std::max(gained, total_energy(world).total() - before);
        brought = std::max(brought, ledger.accounts().brought());
    });
    run(scene, chapter09_solver(scene.contact), {&watch}, {.steps = 80});
    const double impact = 20 * 9.81 * 0.01 * 15;
    CHECK(brought < 1e-3 * impact);
    CHECK(gained < 1e-9);
    CHECK(ledger.accounts().damped > 0.2 * impact);
    CHECK(scene.world.bodies[5]->centre().y() == doctest::Approx(2.5).epsilon(1e-3));
}
