#include "chapters/08_contact_by_distance/experiments/soft_contact_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

double energy_with_springs(const World& world, const Contacts& contacts)
{
    return total_energy(world).total() + spring_energy(contacts);
}

/// Runs a scene in which energy can only fall, and checks that it does.
/// @param halved  steps, at most: where an impact presses more than the skins, or energy would grow
void run_and_check(Scene& scene, double duration, long halved = 0, bool is_linear = false)
{
    Solver solver = chapter08_solver(scene.contact);
    if (is_linear)
        solver.remove("find elastic ends");
    Contacts contacts;
    World& world = scene.world;
    double before = energy_with_springs(world, contacts);
    const double moving = 1e-3 * std::max(1.0, std::abs(before));
    while (world.time < duration) {
        advance(world, contacts, solver, scene.dt);
        const double after = energy_with_springs(world, contacts);
        CHECK(after <= before + moving);
        before = after;
    }
    CHECK(world.thrown_away <= halved);
}

/// Angular momentum that a collision loses, over what the bodies have.
double lost_by(Basis basis, double dt, bool is_linear = false)
{
    Scene scene = soft_collision({basis, 1e5, dt, 2});
    const Vec3 first = angular_momentum(scene.world);
    const double all = turning(scene.world);
    run_and_check(scene, 0.4, 4, is_linear);
    return (angular_momentum(scene.world) - first).norm() / all;
}

}  // namespace

TEST_CASE(
    "soft contact: two soft cubes that strike without friction keep their angular momentum, the better the shorter the step" *
    doctest::test_suite("long simulation"))
{
    for (const Basis basis : {Basis::linear, Basis::quadratic}) {
        const double at_10_ms = lost_by(basis, 0.01), at_2_ms = lost_by(basis, 0.0025);
        CAPTURE(at_10_ms);
        CHECK(at_10_ms < 0.002);
        CHECK(at_2_ms < 0.5 * at_10_ms + 1e-4);
    }
}

TEST_CASE("soft contact: where contact is solved, elastic forces are those of the end of the step")
{
    for (const SoftCollision& collision : {SoftCollision{Basis::linear, 1e5, 0.01, 2},
                                           {Basis::quadratic, 1e5, 0.01, 1},
                                           {Basis::quadratic, 1e4, 0.005, 1},
                                           {Basis::linear, 1e6, 0.02, 1}}) {
        Scene scene = soft_collision(collision);
        Solver solver = chapter08_solver(scene.contact);
        int ends = 0;
        solver.append(StepStage::finish, "look at the end", [&](World& world, Contacts&, double dt) {
            ++ends;
            for (const auto& body : world.bodies)
                CHECK(dynamic_cast<DeformableBody&>(*body).approach_end(dt) <= small_imbalance);
        });
        Contacts contacts;
        for (int step = 0; step < 25; ++step)
            advance(scene.world, contacts, solver, scene.dt);
        CHECK(ends >= 25);
    }
}

TEST_CASE("soft contact: elements follow by as much as contact has changed them, so few steps are halved")
{
    long thrown_away = 0;
    for (const double dt : {0.01, 0.02}) {
        Scene scene = soft_collision({Basis::quadratic, 1e4, dt, 1});
        const Solver solver = chapter08_solver(scene.contact);
        Contacts contacts;
        while (scene.world.time < 0.3)
            advance(scene.world, contacts, solver, dt);
        thrown_away += scene.world.thrown_away;
    }
    CHECK(thrown_away <= 6);
}

TEST_CASE(
    "soft contact: without the pass that settles, elastic forces are those of one linear step, and more turning is lost")
{
    CHECK(lost_by(Basis::quadratic, 0.005, true) > 50 * lost_by(Basis::quadratic, 0.005));
}

TEST_CASE("soft contact: a twisted stiff bar that is let go gains no energy, and no step is halved for it")
{
    Scene scene = twisted_soft_bar(Basis::linear, 1e6, 0.01);
    run_and_check(scene, 0.2);
}

TEST_CASE("soft contact: three soft rings that hang in each other stay linked" *
          doctest::test_suite("long simulation"))
{
    Scene scene = soft_chain({3, 1e5, 0.02});
    const int first = linking_number(scene, 1, 0), second = linking_number(scene, 2, 1);
    CHECK(std::abs(first) == 1);
    CHECK(std::abs(second) == 1);
    run_and_check(scene, 0.5);
    CHECK(linking_number(scene, 1, 0) == first);
    CHECK(linking_number(scene, 2, 1) == second);
}

TEST_CASE(
    "soft contact: where elements follow, rounds are mixed afresh, and need a tenth fewer of Newton's steps" *
    doctest::test_suite("long simulation"))
{
    int newton_steps = 0;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { newton_steps += record.newton_steps; };
    for (unsigned seed = 1; seed <= 8; ++seed) {
        Scene scene = soft_collision({Basis::linear, 1e4, 0.02, seed});
        const Solver solver = chapter08_solver(scene.contact, settings);
        Contacts contacts;
        for (int step = 0; step < 30; ++step)
            advance(scene.world, contacts, solver, scene.dt);
    }
    CHECK(newton_steps < 12000);  // 11,200, and 13,700 where rounds before count, too
}
