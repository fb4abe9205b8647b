#include "chapters/engines/bullet/bullet_solver.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace enduring;

namespace {

std::string box_scene(double size, double height, const std::string& floor, const std::string& more = "")
{
    const std::string side = std::to_string(size);
    return R"({"name": "box", "dt": 0.01, "duration": 2, "contact": {"stiffness": 1000}, )" + floor +
           R"({"name": "box", "type": "rigid", "shape": {"box": {"size": [)" + side + "," + side + "," +
           side + R"(]}}, "mass": 2, "position": [0.03, )" + std::to_string(height) + R"(, 0.01])" + more +
           "}]}";
}

Scene scene_of(const std::string& text)
{
    const TemporaryFolder folder;
    write_file(folder.path / "scene.json", text);
    return load_scene(folder.path / "scene.json");
}

void run_bullet(Scene& scene, int steps) { run(scene, bullet_solver(scene), {}, {.steps = steps}); }

std::vector<Vec3> all_positions(const World& world)
{
    std::vector<Vec3> all;
    for (const auto& body : world.bodies)
        all.insert(all.end(), body->positions_t0().begin(), body->positions_t0().end());
    return all;
}

const std::string nothing = R"("bodies": [)", plane = R"("planes": [{"name": "ground"}], "bodies": [)",
                  triangles = R"("bodies": [{"name": "floor", "type": "static", "shape": {"plane_grid":
                      {"size": [4, 4], "cells": [6, 6]}}}, )";

}  // namespace

TEST_CASE("bullet: a rigid and a soft body fall as symplectic Euler says")
{
    Scene box =
        scene_of(box_scene(0.5, 1, nothing, R"(, "velocity": [1, 0, 0], "angular_velocity": [0, 2, 1])"));
    Scene bars = load_scene(scene_file("ground"));  // a bar and a cube
    const double heights[] = {box.world.bodies[0]->centre().y(), bars.world.bodies[0]->centre().y()};
    const int steps = 20;
    run_bullet(box, steps);
    run_bullet(bars, steps);  // both are in the air until then
    const Body* const falling[] = {box.world.bodies[0].get(), bars.world.bodies[0].get()};
    const double dt[] = {box.dt, bars.dt};
    for (int i = 0; i < 2; ++i) {
        CAPTURE(i);
        CHECK(falling[i]->mean_velocity().y() == doctest::Approx(-9.81 * dt[i] * steps).epsilon(1e-9));
        CHECK(falling[i]->centre().y() ==
              doctest::Approx(heights[i] - 9.81 * dt[i] * dt[i] * steps * (steps + 1) / 2).epsilon(1e-9));
    }
    CHECK(falling[0]->centre().x() == doctest::Approx(0.03 + 0.2).epsilon(1e-9));
}

TEST_CASE("bullet: a box comes to rest at its height, large or small, on a plane or triangles")
{
    for (const double size : {0.1, 0.3, 1.0})
        for (const std::string& floor : {plane, triangles}) {
            CAPTURE(size);
            CAPTURE(floor);
            Scene scene = scene_of(box_scene(size, 0.55 * size, floor));
            run_bullet(scene, 200);
            const Body& box = *scene.world.bodies.back();
            const double margin = std::min(0.04, 0.05 * size);
            CHECK(std::abs(box.centre().y() - 0.5 * size) < 0.2 * margin);
            CHECK(box.mean_velocity().norm() < 1e-3);
        }
}

TEST_CASE("bullet: a bowl, which is not convex, comes to rest on its foot")
{
    Scene scene = load_scene(scene_file("bunny_bowl"));
    scene.world.bodies.pop_back();  // the bunny
    run_bullet(scene, 400);
    CHECK(std::abs(scene.world.bodies[0]->mean_velocity().y()) < 0.01);
    double lowest = 1;
    for (const Vec3& x : scene.world.bodies[0]->positions_t0())
        lowest = std::min(lowest, x.y());
    CHECK(std::abs(lowest) < 0.02);
}

TEST_CASE("bullet: bodies keep their places, mass, energy and momenta when they are handed over")
{
    Scene tilted = scene_of(box_scene(0.5, 1, nothing, R"(, "rotation": {"axis": [1, 2, 3], "angle_deg": 40},
        "velocity": [1, -2, 3], "angular_velocity": [3, 2, 1])"));
    Scene linear = load_scene(scene_file("false_resolution")), quadratic = load_scene(scene_file("ground"));
    for (Scene* const scene : {&tilted, &linear, &quadratic}) {
        CAPTURE(scene->name);
        World& world = scene->world;
        const double energy = total_energy(world).total();
        const std::vector<Vec3> positions = all_positions(world);
        std::vector<Vec3> linear_momenta, angular_momenta;
        for (const auto& body : world.bodies) {
            linear_momenta.push_back(body->linear_momentum());
            angular_momenta.push_back(body->angular_momentum(Vec3(1, 2, 3)));
        }
        bullet_solver(*scene);
        CHECK(total_energy(world).total() == doctest::Approx(energy).epsilon(1e-10));
        for (std::size_t i = 0; i < world.bodies.size(); ++i) {
            const Body& body = *world.bodies[i];
            CHECK((body.linear_momentum() - linear_momenta[i]).norm() <=
                  1e-9 * (1 + linear_momenta[i].norm()));
            CHECK((body.angular_momentum(Vec3(1, 2, 3)) - angular_momenta[i]).norm() <=
                  1e-9 * (1 + angular_momenta[i].norm()));
        }
        const std::vector<Vec3> now = all_positions(world);
        REQUIRE(now.size() == positions.size());
        for (std::size_t i = 0; i < now.size(); ++i)
            CHECK((now[i] - positions[i]).norm() < 1e-12);
        CHECK_THROWS_AS(world.bodies.back()->apply_impulse(0, Vec3::UnitX()), std::logic_error);
    }
}

TEST_CASE("bullet: the impulses of its points on triangles carry a cube's weight, and all points are held")
{
    Scene scene = load_scene(scene_file("hooked"));
    const RunResult result = run(scene, bullet_solver(scene), {}, {.steps = 160});
    double lifted = 0;
    for (const Contact& contact : result.contacts) {
        CHECK(contact.held());
        lifted += scene.world.bodies[static_cast<std::size_t>(contact.body_a)]->is_static()
                      ? -contact.impulse.y()
                      : contact.impulse.y();
    }
    CHECK(lifted == doctest::Approx(20 * 9.81 * scene.dt).epsilon(0.02));
}

TEST_CASE("bullet: a run repeated has the same bytes, rigid or soft")
{
    for (const char* const name : {"hooked", "bar_on_cube", "through_the_side"}) {
        CAPTURE(name);
        Scene once = load_scene(scene_file(name)), again = load_scene(scene_file(name));
        run_bullet(once, 100);
        run_bullet(again, 100);
        CHECK(all_positions(once.world) == all_positions(again.world));
    }
}

TEST_CASE("bullet: a scene that it cannot take says so, with the body's name")
{
    Scene bunny = load_scene(scene_file("bunny_bowl"));
    CHECK_THROWS_WITH_AS(
        bullet_solver(bunny),
        "bunny_bowl: Bullet cannot take 'bowl': its deformable bodies meet convex ones only, and "
        "this is not convex",
        InputError);
    Scene table = scene_of(box_scene(0.5, 1, nothing));
    const SurfaceMesh triangle{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ()}, {{0, 1, 2}}};
    table.world.bodies.push_back(std::make_unique<DrivenBody>(
        "table", triangle, Vec3::Zero(), GivenMotion::steady(Vec3::Zero(), Vec3::UnitY())));
    CHECK_THROWS_WITH_AS(
        bullet_solver(table),
        "box: Bullet cannot take 'table': its motion, its forces, its gravity or what is locked "
        "is the scene's own",
        InputError);
    for (const std::string says :
         {R"("gravity": false)", R"("forces": [{"force": [1, 0, 0]}])", R"("locked": {"rotation": ["x"]})"}) {
        CAPTURE(says);
        Scene scene = scene_of(box_scene(0.5, 1, nothing, ", " + says));
        CHECK_THROWS_AS(bullet_solver(scene), InputError);
    }
}
