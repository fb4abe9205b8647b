#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;

TEST_CASE("deforming body: a box rides on a block that swells and leans, and is carried without a gap")
{
    Scene scene = load_scene(scene_file("swelling"));
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    const Body &block = *scene.world.bodies[0], &box = *scene.world.bodies[1];
    const auto top_and_bottom = [&] {
        double top = -10, bottom = 10;
        for (const Vec3& x : block.positions_t0())
            top = std::max(top, x.y());
        for (const Vec3& x : box.positions_t0())
            bottom = std::min(bottom, x.y());
        return std::pair(top, bottom);
    };
    for (int step = 0; step * scene.dt < 1; ++step) {  // it swells
        advance(scene.world, contacts, solver, scene.dt);
        const auto [top, bottom] = top_and_bottom();
        CAPTURE(scene.world.time);
        CHECK(bottom >= top - 1e-3);
        if (scene.world.time > 0.1)
            CHECK(bottom <= top + 2e-3);
    }
    for (int step = 0; step * scene.dt < 1; ++step)  // it leans, and rests from 1.6 s on
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(box.mean_velocity().norm() <= 0.01);
    // where the box stands the upper side is in y = 0.4 + 0.1 x
    double lowest = 10;
    for (const Vec3& x : box.positions_t0())
        lowest = std::min(lowest, x.y() - 0.1 * x.x());
    CHECK(lowest == doctest::Approx(0.4).epsilon(0.01));
}
