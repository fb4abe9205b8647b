#include "chapters/08_contact_by_distance/experiments/hinged_scenes.hpp"

#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {

using namespace driven_parts;

AgainstFormula swinging_bar(double dt)
{
    constexpr double mass = 2, lever = 0.5, about_end = mass * ((1 + 0.01) / 12 + lever * lever);
    json text = scene_text("swing", dt, 10, 0, 0);
    json bar = box_body("bar", "rigid", {1, 0.1, 0.2}, {lever * std::sin(1.0), -lever * std::cos(1.0), 0});
    bar["rotation"] = {{"axis", {0, 0, 1}}, {"angle_deg", 180 / std::numbers::pi - 90}};
    bar["locked"] = {{"about", {-lever, 0, 0}}, {"rotation", {"x", "y"}}};
    text["bodies"] = json::array({bar});
    Scene scene = scene_from(text);
    double before = 1, first = -1, period = 0;
    run_watched(scene, [&](const World& world) {
        const double now = motion_of(world, 0).centre().x();
        if (before < 0 && now >= 0) {
            const double passed = world.time - dt * now / (now - before);
            period = passed - first;
            if (first >= 0)
                return true;
            first = passed;
        }
        before = now;
        return false;
    });
    return {period, 4 * std::sqrt(about_end / (mass * earth * lever)) * std::comp_ellint_1(std::sin(0.5))};
}

HitDoor hit_door(double dt, double k_dt2_over_m)
{
    constexpr double width = 0.9, thick = 0.04, door_mass = 20, ball_mass = 2, v = 3, b = 0.7;
    json text = scene_text("door", dt, 0.5, 0, 0);
    json door = box_body("door", "rigid", {width, 2, thick}, {width / 2, 1, 0});
    door["mass"] = door_mass;
    door["locked"] = {{"about", {-width / 2, 0, 0}}, {"rotation", {"x", "z"}}};
    json ball{{"name", "ball"},    {"type", "rigid"},           {"shape", {{"sphere", {{"radius", 0.1}}}}},
              {"mass", ball_mass}, {"position", {b, 1.2, 0.3}}, {"velocity", {0, 0, -v}},
              {"gravity", false}};
    text["bodies"] = {door, ball};
    Scene scene = scene_from(text);
    double speed = 0;
    int pushed =
        0;  // steps: in the first one the ball comes as far as the door, in the next one it is stopped
    ImplicitSettings settings;
    settings.stiffness.k_dt2_over_m = k_dt2_over_m;
    run_watched(
        scene,
        [&](const World& world) {
            const double now = motion_of(world, 0).angular_velocity().y();
            if (now != 0 && ++pushed <= 2)
                speed = now;
            return false;
        },
        settings);
    double momentum = 0;
    for (const auto& body : scene.world.bodies)
        momentum += body->angular_momentum(Vec3::Zero()).y();
    constexpr double inertia = door_mass * ((width * width + thick * thick) / 12 + width * width / 4);
    return {{speed, ball_mass * v * b / (inertia + ball_mass * b * b)}, {momentum, ball_mass * v * b}};
}

AgainstFormula slider_crank(double dt)
{
    constexpr double far = 0.35, near = -0.05, half = 0.05, start = 0.5, spin = 2, slider_mass = 0.5,
                     force = 5;
    const auto reach = [](double angle) {
        return std::max(far * std::cos(angle), near * std::cos(angle)) + half * std::abs(std::sin(angle));
    };
    json text = scene_text("slider-crank", dt, 6.6, 0, 0);
    text["gravity"] = {0, 0, 0};
    const double centre = (far + near) / 2;
    json crank = box_body("crank", "rigid", {far - near, 2 * half, 0.1},
                          {centre * std::cos(start), centre * std::sin(start), 0});
    crank["mass"] = 50;
    crank["rotation"] = {{"axis", {0, 0, 1}}, {"angle_deg", start * 180 / std::numbers::pi}};
    crank["locked"] = {{"about", {-centre, 0, 0}}, {"rotation", {"x", "y"}}};
    crank["angular_velocity"] = {0, 0, spin};
    json slider = box_body("slider", "rigid", {0.1, 1, 0.2}, {reach(start) + 0.05, 0, 0});
    slider["mass"] = slider_mass;
    slider["velocity"] = {spin * (half * std::cos(start) - far * std::sin(start)), 0, 0};
    slider["locked"] = {{"translation", {"y", "z"}}, {"rotation", {"x", "y", "z"}}};
    slider["forces"] = json::array({json::object({{"force", {-force, 0, 0}}})});
    text["bodies"] = {crank, slider};
    Scene scene = scene_from(text);
    AgainstFormula worst{1, 1};
    run_watched(scene, [&](const World& world) {
        const Vec3 lever = motion_of(world, 0).centre();
        const AgainstFormula now{motion_of(world, 1).centre().x() - 0.05,
                                 reach(std::atan2(lever.y(), lever.x()))};
        if (std::abs(now.measured - now.formula) > std::abs(worst.measured - worst.formula))
            worst = now;
        return false;
    });
    return worst;
}

bool rides_on_sheet(double beyond, double dt)
{
    json text = scene_text("lift", dt, 1.5, 0.6, 0.5);
    json sheet{{"name", "sheet"}, {"type", "static"}, {"shape", {{"plane_grid", {{"size", {1, 1}}}}}}};
    sheet["motion"] = {{"table",
                        {{{"time", 0}},
                         {{"time", 0.75},
                          {"displacement", {0.1, 0.2, 0.1}},
                          {"turn", {{"axis", {0, 1, 0}}, {"angle_deg", 40}}}},
                         {{"time", 1.5}, {"displacement", {0, 0.3, 0}}}}}};
    text["bodies"] = {sheet, box_body("box", "rigid", {0.3, 0.2, 0.25}, {0.5 + beyond, 0.1, 0.05})};
    Scene scene = scene_from(text);
    run_whole(scene);
    return scene.world.bodies[1]->centre().y() > 0.39;
}

AgainstFormula sheet_on_box(double dt)
{
    json text = scene_text("sheet on a box", dt, 1, 0.6, 0.5);
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    json sheet{{"name", "sheet"},
               {"type", "rigid"},
               {"sheet", true},
               {"mass", 3},
               {"shape", {{"plane_grid", {{"size", {0.5, 0.5}}}}}},
               {"position", {0.1, 0.42, 0}}};
    json ball{{"name", "ball"},
              {"type", "rigid"},
              {"shape", {{"sphere", {{"radius", 0.1}}}}},
              {"mass", 1},
              {"position", {0.05, 0.55, 0.02}}};
    text["bodies"] = {box_body("box", "rigid", {0.4, 0.4, 0.4}, {0, 0.2, 0}), sheet, ball};
    Scene scene = scene_from(text);
    run_whole(scene);
    double lowest = 1;
    for (const Vec3& vertex : scene.world.bodies[2]->positions_t0())
        lowest = std::min(lowest, vertex.y());
    return {lowest, 0.4};
}

}  // namespace enduring::chapter08
