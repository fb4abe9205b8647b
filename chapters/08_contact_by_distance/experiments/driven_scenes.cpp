#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"

#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter08 {

using namespace driven_parts;

AgainstFormula piston(double dt)
{
    constexpr double stroke = 0.2, period = 1.5;  // [m], [s]; falls with 0.36 g at most
    json table = json::array();
    for (int row = 0; row <= 64; ++row)
        table.push_back(
            {{"time", period * row / 64},
             {"displacement", {0, stroke / 2 * (1 - std::cos(2 * std::numbers::pi * row / 64)), 0}}});
    json text = scene_text("piston", dt, period / 2, 0.5, 0.4);
    json plate = box_body("plate", "static", {1, 0.2, 1}, {0, -0.1, 0});
    plate["motion"] = {{"table", table}};
    text["bodies"] = {plate, box_body("cube", "rigid", {0.3, 0.3, 0.3}, {0, 0.15, 0})};
    Scene scene = scene_from(text);
    double highest = 0;
    run_watched(scene, [&](const World& world) {
        highest = std::max(highest, world.bodies[1]->centre().y() - 0.15);
        return false;
    });
    return {highest, stroke};
}

AgainstFormula turntable_slip(double dt)
{
    constexpr double radius = 1, mu_s = 0.4, faster = 0.25;  // [m], -, [rad/s^2]
    const double formula = std::pow(mu_s * earth * mu_s * earth - faster * radius * faster * radius, 0.25) /
                           std::sqrt(radius);
    json table = json::array();
    constexpr double degree = std::numbers::pi / 180;
    for (int row = -1; row <= 61; ++row) {
        const double time = 0.2 * row;
        table.push_back(
            {{"time", time},
             {"turn", {{"axis", {0, 1, 0}}, {"angle_deg", 0.5 * faster * time * time / degree}}}});
    }
    json text = scene_text("turntable", dt, 12, mu_s, mu_s);
    json disc = box_body("disc", "static", {4, 0.2, 4}, {0, -0.1, 0});
    disc["motion"] = {{"table", table}};
    text["bodies"] = {disc, box_body("block", "rigid", {0.05, 0.01, 0.05}, {radius, 0.005, 0})};
    Scene scene = scene_from(text);
    double speed = 0;
    run_watched(scene, [&](const World& world) {
        const Vec3 centre = world.bodies[1]->centre();
        speed = faster * world.time;
        return std::hypot(centre.x(), centre.z()) > radius + 1e-5;
    });
    return {speed, formula};
}

Conveyed conveyor(double dt)
{
    constexpr double v = 2, mu_d = 0.3, mass = 2;
    json text = scene_text("conveyor", dt, 1, 0.4, mu_d);
    json belt = box_body("belt", "static", {8, 0.2, 1}, {3, -0.1, 0});
    belt["surface_velocity"] = {v, 0, 0};
    text["bodies"] = {belt, box_body("block", "rigid", {0.3, 0.1, 0.3}, {0, 0.05, 0})};
    Scene scene = scene_from(text);
    run_whole(scene);
    const double slid = v * scene.world.time - scene.world.bodies[1]->centre().x(),
                 kinetic = scene.world.bodies[1]->energy(scene.world.gravity).kinetic;
    return {{slid, v * v / (2 * mu_d * earth)}, {scene.world.driven - kinetic, mass / 2 * v * v}};
}

AgainstFormula pushed_puck(double dt)
{
    constexpr double force = 20, mass = 2, mu_d = 0.3, time = 1;
    json text = scene_text("puck", dt, time, 0.4, mu_d);
    json puck = box_body("puck", "rigid", {0.3, 0.05, 0.3}, {0, 0.025, 0});
    puck["forces"] = json::array({json::object({{"force", {force, 0, 0}}})});
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = json::array({puck});
    Scene scene = scene_from(text);
    run_whole(scene);
    return {scene.world.bodies[0]->centre().x(), (force / mass - mu_d * earth) * time * time / 2};
}

AgainstFormula torque_on_wheel(double dt)
{
    constexpr double torque = 0.3, force = 2, size = 0.6, mass = 2, time = 1;
    json text = scene_text("wheel", dt, time, 0.4, 0.3);
    json wheel = box_body("wheel", "rigid", {size, size, 0.1}, {0, 1, 0});
    wheel["locked"] = {{"translation", {"x", "y", "z"}}, {"rotation", {"x", "y"}}};
    wheel["forces"] = {{{"torque", {0, 0, torque}}},
                       {{"force", {0, force, 0}}, {"point", {size / 2, 0, 0}}, {"axes", "body"}}};
    text["bodies"] = json::array({wheel});
    Scene scene = scene_from(text);
    run_whole(scene);
    const double inertia = mass / 12 * 2 * size * size;
    return {motion_of(scene.world, 0).angular_velocity().z(), (torque + force * size / 2) * time / inertia};
}

AgainstFormula hit_slider(double dt)
{
    json text = scene_text("slider", dt, 0.5, 0, 0);
    text["gravity"] = {0, 0, 0};
    json slider = box_body("slider", "rigid", {0.4, 0.4, 0.4}, {0, 0, 0});
    slider["rotation"] = {{"axis", {0, 0, 1}}, {"angle_deg", 30}};
    slider["locked"] = {{"translation", {"y", "z"}}, {"rotation", {"x", "y", "z"}}};
    json ball{{"name", "ball"},
              {"type", "rigid"},
              {"shape", {{"sphere", {{"radius", 0.2}}}}},
              {"mass", 1},
              {"position", {-0.6, 0.1, 0}},
              {"velocity", {3, 0, 0}}};
    text["bodies"] = {slider, ball};
    Scene scene = scene_from(text);
    run_whole(scene);
    const World& world = scene.world;
    const bool moved = motion_of(world, 0).velocity().x() > 0.1;
    return {moved ? (world.bodies[0]->linear_momentum() + world.bodies[1]->linear_momentum()).x() : 0, 3};
}

namespace {

constexpr double mu_s_of_pair = 0.5, mu_d_of_pair = 0.4;  // neither material's own

/// Gravity is turned in place of the slope.
Scene materials_on_slope(double slope_deg, double dt)
{
    const double slope = slope_deg * std::numbers::pi / 180;
    json text = scene_text("materials", dt, 1, 0.05, 0.05);
    text["gravity"] = {-earth * std::sin(slope), -earth * std::cos(slope), 0};
    text["materials"] = {{{"name", "wood"}, {"density", 600}, {"mu_s", 0.9}},
                         {{"name", "steel"}, {"mu_s", 0.1}}};
    text["material_pairs"] = json::array(
        {json::object({{"between", {"wood", "steel"}}, {"mu_s", mu_s_of_pair}, {"mu_d", mu_d_of_pair}})});
    json floor = box_body("floor", "static", {12, 0.2, 4}, {-4, -0.1, 0});
    floor["material"] = "steel";
    json block = box_body("block", "rigid", {0.4, 0.1, 0.4}, {0, 0.05, 0});
    block.erase("mass");
    block["material"] = "wood";
    text["bodies"] = {floor, block};
    return scene_from(text);
}

}  // namespace

AgainstFormula slide_of_materials(double slope_deg, double dt)
{
    const double slope = slope_deg * std::numbers::pi / 180;
    Scene scene = materials_on_slope(slope_deg, dt);
    double at_half = 0;
    run_watched(scene, [&](const World& world) {
        if (world.time < 0.5 + dt / 2)
            at_half = world.bodies[1]->mean_velocity().x();
        return false;
    });
    return {2 * (at_half - scene.world.bodies[1]->mean_velocity().x()),
            earth * (std::sin(slope) - mu_d_of_pair * std::cos(slope))};
}

bool materials_hold(double slope_deg, double dt)
{
    Scene scene = materials_on_slope(slope_deg, dt);
    run_whole(scene);
    return std::abs(scene.world.bodies[1]->centre().x()) < 1e-4;
}

}  // namespace enduring::chapter08
