#include "chapters/04_friction/experiments/launch.hpp"

#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace enduring::chapter04 {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double still_for = 5, still_within = 1e-3;  // [s], [m]

double in_radians(double degrees) { return degrees * std::numbers::pi / 180; }

nlohmann::json list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Long enough to stop, to settle and to stand still: on a flat slope it takes longest.
double patience(const Launch& launch)
{
    const double deceleration = 9.81 * std::sin(in_radians(launch.angle_deg));
    return launch.speed / deceleration + 7 + still_for;
}

}  // namespace

FrictionParameters with_mu_s(const FrictionParameters& friction, double mu_s)
{
    return with_coefficients(friction, mu_s, std::min(0.1, mu_s / 2));
}

Vec3 uphill(double angle_deg)
{
    return {std::cos(in_radians(angle_deg)), std::sin(in_radians(angle_deg)), 0};
}

Scene scene_of(const Launch& launch)
{
    constexpr double mass = 100, corners = 4, stiffness = 20000;
    const Vec3 up = uphill(launch.angle_deg), normal(-up.y(), up.x(), 0);
    const double depth = mass * 9.81 * normal.y() / (corners * stiffness);
    const nlohmann::json change{{"dt", launch.dt},
                                {"planes", {{{"name", "slope"}, {"normal", list(normal)}}}},
                                {"/bodies/block",
                                 {{"shape", {{"box", {{"size", {1, launch.height, 1}}}}}},
                                  {"position", list((launch.height / 2 - depth) * normal)},
                                  {"rotation", {{"axis", {0, 0, 1}}, {"angle_deg", launch.angle_deg}}},
                                  {"velocity", list(launch.speed * up)}}}};
    Scene scene = load_scene(scene_file("block_on_slope"), change.dump());
    scene.contact.friction = launch.friction;
    return scene;
}

Progress1d along_slope(const World& world, double angle_deg)
{
    const Body& body = *world.bodies.front();
    const Vec3 middle = body.centre();
    const Vec3 up = uphill(angle_deg);
    return {world.time, middle.dot(up), body.linear_momentum().dot(up) / body.mass()};
}

void follow(const Launch& launch, double seconds, const std::function<bool(const Progress1d&)>& watch)
{
    Scene scene = scene_of(launch);
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    while (scene.world.time < seconds) {
        advance(scene.world, contacts, solver, scene.dt);
        if (!watch(along_slope(scene.world, launch.angle_deg)))
            return;
    }
}

//! [holds]
bool holds(const Launch& launch)
{
    const double seconds = patience(launch);
    double low = 1e9, high = -1e9, highest = -1e9;
    bool slid_away = false;
    follow(launch, seconds, [&](const Progress1d& now) {
        highest = std::max(highest, now.way);
        slid_away = now.way < highest - 0.5;
        if (now.time > seconds - still_for) {
            low = std::min(low, now.way);
            high = std::max(high, now.way);
        }
        return !slid_away;
    });
    return !slid_away && high - low < still_within;
}
//! [holds]

double smallest_mu_s(Launch launch)
{
    const FrictionParameters friction = launch.friction;
    const auto holds_with = [&](double mu_s) {
        launch.friction = with_mu_s(friction, mu_s);
        return holds(launch);
    };
    const double tangent = std::tan(in_radians(launch.angle_deg));
    double low = 0.8 * tangent, high = 4 * tangent;
    if (!holds_with(high))
        return not_a_number;
    while (high > 1.005 * low) {
        const double middle = std::sqrt(low * high);
        (holds_with(middle) ? high : low) = middle;
    }
    return high;
}

double mean_acceleration(const Launch& launch, double from_speed, double to_speed)
{
    const double sign = to_speed > from_speed ? 1 : -1;
    std::optional<Progress1d> first, last;
    follow(launch, 60, [&](const Progress1d& now) {
        if (!first && sign * (now.speed - from_speed) >= 0)
            first = now;
        if (sign * (now.speed - to_speed) >= 0)
            last = now;
        return !last;
    });
    return first && last ? (last->speed - first->speed) / (last->time - first->time) : not_a_number;
}

}  // namespace enduring::chapter04
