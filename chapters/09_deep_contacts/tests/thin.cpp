#include "chapters/09_deep_contacts/experiments/thin_shots.hpp"
#include "chapters/09_deep_contacts/tests/quiet_solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter09;

TEST_CASE("thin: no shot at a plate of one cell or a shell comes out on the other side, from either side")
{
    std::mt19937_64 random(31);
    long above = 0, shots = 0;
    for (const std::size_t target : {0U, 3U})
        for (const std::string& body : thin_shots())
            for (int trial = 0; trial < 6; ++trial) {
                ThinShot shot = shot_at_random(thin_targets()[target], body, random);
                CAPTURE(shot.target->name);
                CAPTURE(body);
                CAPTURE(shot.speed);
                REQUIRE_FALSE(is_through(shot, shot.scene.world));
                bool through = false;
                run(shot.scene, quiet_solver(shot.scene.contact), {},
                    {.stop = [&](const World& world, const Contacts&) {
                        return through = through || is_through(shot, world);
                    }});
                CHECK_FALSE(through);
                above += shot.side > 0;
                ++shots;
            }
    CHECK(above > shots / 4);
    CHECK(above < 3 * shots / 4);
}

TEST_CASE("thin: shots that could turn by radians in the answer of one step gain no energy")
{
    struct Found {
        std::size_t target;
        std::string body;
        int trial;
    };
    // each gained 2 to 28 times its energy while such an answer was kept
    for (const Found& found : {Found{1, "plate", 5}, Found{1, "plate", 16}, Found{3, "cube", 5},
                               Found{3, "cube", 52}, Found{2, "cube", 59}}) {
        CAPTURE(found.target);
        CAPTURE(found.trial);
        std::mt19937_64 random(7);
        ThinShot shot = shot_at_random(thin_targets()[found.target], found.body, random);
        for (int trial = 0; trial < found.trial; ++trial)
            shot = shot_at_random(thin_targets()[found.target], found.body, random);
        double most = 0;
        const double before = total_energy(shot.scene.world).kinetic;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            most = std::max(most, total_energy(world).kinetic);
        });
        run(shot.scene, quiet_solver(shot.scene.contact), {&watch}, failure_on_purpose());
        CHECK(most < 1.001 * before);
    }
}

TEST_CASE("thin: what flies through a plate or a shell without a solver is seen to be through")
{
    std::mt19937_64 random(31);
    for (const ThinTarget& target : thin_targets())
        for (int trial = 0; trial < 5; ++trial) {
            ThinShot shot = shot_at_random(target, "cube", random);
            bool through = false;
            run(shot.scene, Solver{}, {}, {.stop = [&](const World& world, const Contacts&) {
                    return through = through || is_through(shot, world);
                }});
            CHECK(through);
        }
}
