#include "chapters/08_contact_by_distance/experiments/forces_vices.hpp"
#include "chapters/08_contact_by_distance/tests/check_rows.hpp"
#include "chapters/09_deep_contacts/tests/quiet_solver.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter08::force_rows;

namespace {

/// Two walls close in on a cube of 10 cm in the air until they stand this much nearer than the cube is wide
/// [mm].
Scene squeezed_cube(double too_near, double dt)
{
    const std::string path = std::to_string(1e-3 * (0.1 + too_near / 2));
    const auto wall = [&](const std::string& name, const std::string& side, const std::string& towards) {
        return R"(, {"name": ")" + name +
               R"(", "type": "static", "shape": {"box": {"size": [0.1, 0.3, 0.3]}}, "position": [)" + side +
               R"(0.1001, 0.5, 0], "motion": {"table": [{"time": 0}, {"time": 0.1, "displacement": [)" +
               towards + path + R"(, 0, 0]}]}})";
    };
    return read_scene(R"({"name": "s", "dt": )" + std::to_string(dt) + R"(, "duration": 0.5,
        "contact": {"friction": {"model": "mass_splitting", "mu_s": 0.8}}, "bodies": [
        {"name": "cube", "type": "rigid", "shape": {"box": {"size": [0.1, 0.1, 0.1]}}, "density": 1000, "position": [0, 0.5, 0]})" +
                          wall("left", "-", "") + wall("right", "", "-") + "]}",
                      "", "s.json", {});
}

}  // namespace

TEST_CASE(
    "given motion: a cube that two walls squeeze is held in steps that are solved, by springs that stay soft")
{
    for (const double dt : {0.005, 0.01}) {
        CAPTURE(dt);
        Scene scene = squeezed_cube(0.5, dt);
        int unsolved = 0;
        ImplicitSettings settings;
        settings.record = [&](const SolveRecord& record) { unsolved += record.unsolved_islands; };
        const Solver solver = chapter09_solver(scene.contact, settings);
        Contacts contacts;
        while (scene.world.time < scene.duration - dt / 2)
            advance(scene.world, contacts, solver, dt);
        CHECK(unsolved == 0);
        CHECK(scene.world.ended_badly == 0);
        CHECK(scene.world.bodies[0]->centre().y() == doctest::Approx(0.5).epsilon(0.01));
        CHECK(spring_energy(contacts) < 100);  // if each load asked for its own stiffness: ten million
    }
}

TEST_CASE("squeezed: walls that close too far press with k times the depth, both alike")
{
    check_rows(vices(chapter09::quiet_solver, false));
}

TEST_CASE("squeezed: fingers that close too far lift a body, and throw nothing")
{
    check_rows(grippers(chapter09::quiet_solver, false));
}
