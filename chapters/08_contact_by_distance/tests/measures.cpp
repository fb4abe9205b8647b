#include "chapters/04_friction/experiments/rides.hpp"
#include "chapters/06_redefinition/experiments/laid_block.hpp"
#include "chapters/06_redefinition/experiments/plane_slide.hpp"
#include "chapters/07_implicit_contact/experiments/spinning_box.hpp"
#include "chapters/08_contact_by_distance/experiments/facets.hpp"
#include "chapters/08_contact_by_distance/experiments/launch.hpp"
#include "chapters/08_contact_by_distance/experiments/rimless_wheel.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::chapter08;

TEST_CASE(
    "flat triangles: without friction a cube keeps its speed to 0.01 percent, and is carried by its weight to 1 percent")
{
    const chapter06::PlaneSlide slide{GridDiagonals::crossed, 1, true, 30000, 0.01};
    chapter07::SolveStatistics solves;
    ForceProbe force("cube", "floor");
    const chapter06::SlideOutcome outcome = chapter06::slide_over_plane(
        slide, chapter07::counting_solver(chapter08_solver, solves)(chapter06::scene_of(slide).contact),
        &force);
    CHECK(std::abs(outcome.speed_change) < 1e-4);
    CHECK(outcome.sideways_speed < 1e-4);
    const auto& rows = force.table().rows();
    for (std::size_t i = rows.size() / 10; i < rows.size(); ++i)
        CHECK(std::get<double>(rows[i][2]) == doctest::Approx(20 * 9.81).epsilon(0.01));
}

TEST_CASE("flat triangles: a block that is laid a billionth of a millimetre above them gains no energy")
{
    chapter07::SolveStatistics solves;
    for (const double slope : {10.0, 15.0})
        CHECK(chapter06::lay({1e-12, slope, 0.3}, chapter07::counting_solver(chapter08_solver, solves))
                  .energy_gained < 1e-3);
}

TEST_CASE("flat triangles: a block that is laid exactly on them gains no energy, wherever rounding puts it")
{
    for (const double slope : {10.0, 30.0})
        for (const double turned : {0.0, 0.6}) {
            chapter07::SolveStatistics solves;
            CAPTURE(slope);
            CAPTURE(turned);
            const auto laid = chapter06::lay({0, slope, turned},
                                             chapter07::counting_solver(chapter08_solver, solves));
            CHECK(laid.energy_gained < 1e-3);
            CHECK(laid.corners_missed == 0);
        }
}

TEST_CASE("turntable: a block and a grate creep less than a micrometre in a turn")
{
    for (const rides::Load load : {rides::Load::block, rides::Load::grate}) {
        rides::Ride ride = rides::short_ride(rides::Ground::table, load);
        ride.steps = 314;
        chapter07::SolveStatistics solves;
        const rides::RideRecord record = rides::take(ride,
                                                     chapter07::counting_solver(chapter08_solver, solves));
        CHECK(record.creep.back() < 1e-6);
        CHECK(record.vertex_faces + record.edge_edges > 0);
    }
}

TEST_CASE(
    "launch: with one coefficient a cube stays where it turns round 1 percent above tan, and slides 1 percent below")
{
    for (const double slope : {10.0, 30.0})
        for (const double part : {0.99, 1.01}) {
            const double mu = part * std::tan(slope * 3.14159265358979 / 180);
            CHECK(stays({slope, 0.01, mu, mu}) == (part > 1));
        }
}

TEST_CASE(
    "launch: with a coefficient that falls, too, a cube that is laid down holds from the tangent on, to 1 percent")
{
    for (const double slope : {5.0, 30.0})
        for (const double part : {0.99, 1.01}) {
            const double mu_s = part * std::tan(slope * 3.14159265358979 / 180);
            CHECK(stays({slope, 0.01, mu_s, 0.8 * mu_s, 0}) == (part > 1));
        }
}

TEST_CASE(
    "launch: with a coefficient that falls far a cube stays where it turns round, at whatever speed it comes")
{
    const double tangent = std::tan(10 * 3.14159265358979 / 180);
    for (int i = 0; i < 10; ++i)
        CHECK(stays({10, 0.01, 1.1 * tangent, 0.2 * tangent, 2 + 0.1 * i}));
}

TEST_CASE(
    "facets: a rimless wheel keeps its energy between landings, and a landing leaves cos of a hoop's turn halved")
{
    RimlessWheel wheel{
        .sides = 6, .radius = 0.2, .mass = 2, .inertia = 0.08, .slope = 0.1, .angle = -0.5, .rate = 3};
    const auto energy = [&] {
        return 0.5 * (0.08 + 0.08) * wheel.rate * wheel.rate +
               2 * 9.81 * 0.2 * std::cos(wheel.angle + wheel.slope);
    };
    const double before = energy();
    wheel.roll(0.3);
    CHECK(wheel.angle > 0.2);
    CHECK(energy() == doctest::Approx(before).epsilon(1e-6));
    CHECK(wheel.kept() == doctest::Approx(0.75));  // (1 + cos 60 degrees) / 2
}

TEST_CASE(
    "facets: a prism rolls as the rimless wheel of its shape, to 2 percent, and twice as near with shorter steps")
{
    for (const int sides : {8, 16, 32}) {
        const PrismRoll longer = roll_prism(sides, 0.005), shorter = roll_prism(sides, 0.001);
        CHECK(std::abs(longer.measured / longer.by_wheel - 1) < 0.025);
        CHECK(std::abs(shorter.measured / shorter.by_wheel - 1) < 0.01);
        CHECK(std::abs(shorter.measured / shorter.by_wheel - 1) <
              0.5 * std::abs(longer.measured / longer.by_wheel - 1));
    }
}

TEST_CASE("spinning: under this chapter's solver boxes that turn by radians in a step land and gain nothing")
{
    for (unsigned seed = 1; seed <= 5; ++seed)
        for (const double turn : {1.0, 3.0, 6.0}) {
            CAPTURE(seed);
            CAPTURE(turn);
            chapter07::SolveStatistics solves;
            const double max_turn = chapter08_solver(ContactParameters{}).max_turn;
            CHECK(chapter07::max_energy(chapter07::spinning_box(turn, 0.01, seed), chapter08_solver, max_turn,
                                        solves) <= 1);
            CHECK(solves.unconverged == 0);
        }
}
