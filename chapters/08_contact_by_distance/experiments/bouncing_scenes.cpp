#include "chapters/08_contact_by_distance/experiments/bouncing_scenes.hpp"

#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/run/run.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace enduring::chapter08 {
namespace {

using json = nlohmann::json;
constexpr double ball_height = 1, ball_radius = 0.1;  // [m]

Scene read_bouncing(const json& scene) { return read_scene(scene.dump(), "", "bouncing.json", {}); }

json bouncing_text(const std::string& name, double e, double dt, double duration, double mu = 0.3)
{
    return {{"name", name},
            {"dt", dt},
            {"duration", duration},
            {"contact",
             {{"restitution", e}, {"friction", {{"model", "mass_splitting"}, {"mu_s", mu}, {"mu_d", mu}}}}}};
}

json rigid_at(const std::string& name, const json& shape, const json& position, double mass = 1)
{
    return {{"name", name}, {"type", "rigid"}, {"shape", shape}, {"position", position}, {"mass", mass}};
}

json ball_at(const std::string& name, double radius, const json& position)
{
    json one = rigid_at(name, {{"sphere", {{"radius", radius}, {"subdivisions", 2}}}}, position);
    one["look"] = {{"smooth", true}};
    return one;
}

/// Runs a scene to its end, and shows its world after each step.
template <class Watch>
void watch_steps(Scene& scene, const Watch& watch)
{
    run(scene, chapter08_solver(scene.contact), {},
        {.stop = [&](const World& world, const Contacts&) { return watch(world); }});
}

double lowest_vertex(const Body& body)
{
    double least = INFINITY;
    for (const Vec3& vertex : body.positions_t0())
        least = std::min(least, vertex.y());
    return least;
}

//! [counted]
/// What bodies hold, with velocities of the ends of steps, not of their middles [J].
double counted_energy(const World& world, double dt)
{
    double sum = total_energy(world).total();
    for (const auto& one : world.bodies)
        sum += dt / 2 * world.gravity.dot(one->linear_momentum());
    return sum;
}
//! [counted]

EnergyOfRun watch_energy(Scene& scene, double moving)
{
    const double start = counted_energy(scene.world, scene.dt);
    EnergyOfRun energy{-INFINITY, 0};
    watch_steps(scene, [&](const World& world) {
        energy.left = (counted_energy(world, scene.dt) - start) / moving;
        energy.most_gained = std::max(energy.most_gained, energy.left);
        return false;
    });
    energy.left += 1;
    return energy;
}

}  // namespace

namespace {

/// A ball above a floor.
Scene ball_scene(double e, Floor floor, double dt, double duration)
{
    json text = bouncing_text("ball", e, dt, duration);
    if (floor == Floor::plane)
        text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = json::array({ball_at("ball", ball_radius, {0, ball_radius + ball_height, 0})});
    if (floor != Floor::plane) {
        const double aside = floor == Floor::triangles ? 0.13 : 0;  // else on a vertex of the floor
        text["bodies"].push_back({{"name", "floor"},
                                  {"type", "static"},
                                  {"shape", {{"plane_grid", {{"size", {4, 4}}, {"cells", {4, 4}}}}}},
                                  {"position", {aside, 0, aside / 2}}});
    }
    return read_bouncing(text);
}

}  // namespace

double kept_height(double e, Floor floor, double dt)
{
    Scene scene = ball_scene(e, floor, dt, 1.5);
    double highest = 0, last = ball_height;
    bool rises = false;
    watch_steps(scene, [&](const World& world) {
        const double now = lowest_vertex(*world.bodies[0]);
        const bool over = rises && now < last;
        rises = now > last;
        last = now;
        highest = rises ? now : highest;
        return over;
    });
    return highest / ball_height;
}

std::vector<double> heights_of_ball(double e, double dt, double duration)
{
    Scene scene = ball_scene(e, Floor::plane, dt, duration);
    std::vector<double> heights{ball_height};
    watch_steps(scene, [&](const World& world) {
        heights.push_back(lowest_vertex(*world.bodies[0]));
        return false;
    });
    return heights;
}

Scene cradle_scene(double e, double gap, double dt)
{
    constexpr double radius = 0.05;
    json text = bouncing_text("cradle", e, dt, 1);
    text["gravity"] = {0, 0, 0};
    text["planes"] = json::array({json::object({{"name", "below"}, {"point", {0, -1.2 * radius, 0}}})});
    text["bodies"] = json::array();
    for (int i = 0; i < 5; ++i) {
        json one = ball_at("ball " + std::to_string(i), radius,
                           {i * (2 * radius + gap) - (i == 0 ? 0.213 : 0), 0, 0});
        one["locked"] = {{"translation", {"y", "z"}}, {"rotation", {"x", "y", "z"}}};
        if (i == 0)
            one["velocity"] = {1, 0, 0};
        if (i == 0 || i == 4)
            one["look"]["color"] = i == 0 ? json{0.6, 0.2, 0.1} : json{0.1, 0.22, 0.48};
        text["bodies"].push_back(one);
    }
    return read_bouncing(text);
}

Cradle cradle(double e, double gap, double dt)
{
    Scene scene = cradle_scene(e, gap, dt);
    const double start = total_energy(scene.world).kinetic;
    watch_steps(scene, [](const World&) { return false; });
    Cradle end;
    for (const auto& one : scene.world.bodies)
        end.velocities.push_back(one->mean_velocity().x());
    end.kinetic = total_energy(scene.world).kinetic / start;
    return end;
}

HangingCradle hanging_cradle(double gap, double dt)
{
    constexpr double radius = 0.1, string = 0.8, drawn_deg = 35;
    json text = bouncing_text("hanging", 1, dt, 1, 0);
    text["bodies"] = json::array();
    for (int i = 0; i < 5; ++i) {
        const double angle = i == 0 ? drawn_deg * std::numbers::pi / 180 : 0;
        json one = ball_at("ball " + std::to_string(i), radius,
                           {i * (2 * radius + gap) - string * std::sin(angle), -string * std::cos(angle), 0});
        one["rotation"] = {{"axis", {0, 0, 1}}, {"angle_deg", i == 0 ? -drawn_deg : 0}};
        one["locked"] = {{"about", {0, string, 0}}, {"rotation", {"x", "y"}}};
        text["bodies"].push_back(one);
    }
    Scene scene = read_bouncing(text);
    double comes = 0, leaves = 0;
    watch_steps(scene, [&](const World& world) {
        comes = std::max(comes, leaves == 0 ? world.bodies[0]->mean_velocity().norm() : 0);
        leaves = std::max(leaves, world.bodies[4]->mean_velocity().norm());
        return false;
    });
    return {scene.world.ended_badly, leaves / comes};
}

EnergyOfRun cube_on_corner(double e, double mu, double dt, double duration)
{
    json text = bouncing_text("cube", e, dt, duration, mu);
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    json cube = rigid_at("cube", {{"box", {{"size", {0.4, 0.4, 0.4}}}}}, {0, 1, 0});
    cube["rotation"] = {{"axis", {1, 0.2, -0.7}}, {"angle_deg", 50}};
    text["bodies"] = json::array({cube});
    Scene scene = read_bouncing(text);
    return watch_energy(scene, 0.65 * 9.81);  // its fall, to its corner
}

EnergyOfRun soft_cubes(double e, double dt, const std::string& response)
{
    json text = bouncing_text("soft", e, dt, 0.5);
    text["gravity"] = {0, 0, 0};
    text["bodies"] = json::array();
    for (int i = 0; i < 2; ++i)
        text["bodies"].push_back({{"name", "soft " + std::to_string(i)},
                                  {"type", "deformable"},
                                  {"shape", {{"bar", {{"size", {0.4, 0.4, 0.4}}, {"cells", {2, 2, 2}}}}}},
                                  {"mass", 5},
                                  {"young", 1e5},
                                  {"poisson", 0.3},
                                  {"basis", "linear"},
                                  {"impulse_response", response},
                                  {"rotation", {{"axis", {0, 1, 1}}, {"angle_deg", 20 * i}}},
                                  {"position", {0.6 * i, 0.07 * i, 0.05 * i}},
                                  {"velocity", {i == 0 ? 2 : -1, 0, 0}}});
    Scene scene = read_bouncing(text);
    return watch_energy(scene, total_energy(scene.world).kinetic);
}

double rest_of_stack(double e, double dt, int cubes, double duration)
{
    constexpr double size = 0.2, still = 1e-3;  // [m], [m/s]
    json text = bouncing_text("stack", e, dt, duration, 0.5);
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = json::array();
    for (int i = 0; i < cubes; ++i)
        text["bodies"].push_back(rigid_at("cube " + std::to_string(i),
                                          {{"box", {{"size", {size, size, size}}}}},
                                          {0, size / 2 + 0.01 * size + i * 1.01 * size, 0}));
    Scene scene = read_bouncing(text);
    double moved = 0;
    watch_steps(scene, [&](const World& world) {
        for (const auto& one : world.bodies)
            if (one->mean_velocity().norm() > still)
                moved = world.time;
        return world.time > moved + 1;
    });
    return scene.world.time > moved + 1 ? moved : NAN;
}

ObliqueBounce oblique_bounce(double e, double mu, double dt)
{
    json text = bouncing_text("oblique", e, dt, 0.5, mu);
    text["gravity"] = {0, 0, 0};
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    json one = ball_at("ball", 0.1, {0, 0.233, 0});
    one["locked"] = {{"rotation", {"x", "y", "z"}}};
    one["velocity"] = {1, -1, 0};
    text["bodies"] = json::array({one});
    Scene scene = read_bouncing(text);
    watch_steps(scene, [](const World&) { return false; });
    const Vec3 velocity = scene.world.bodies[0]->mean_velocity();
    return {velocity.x(), velocity.y()};
}

namespace {

/// Of 10 kg each. No two overlap at the start.
Scene cube_of_balls(int along_edge, double e, double dt, double duration)
{
    constexpr double distance = 2.06 * ball_radius, aside = 0.02 * ball_radius;
    std::mt19937 random(666);
    std::uniform_real_distribution<double> shift(-aside, aside);
    json text = bouncing_text("balls", e, dt, duration, 0);
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = json::array();
    for (int i = 0; i < along_edge * along_edge * along_edge; ++i) {
        const int x = i % along_edge, z = i / along_edge % along_edge, y = i / (along_edge * along_edge);
        json one = ball_at("ball " + std::to_string(i), ball_radius,
                           {x * distance + shift(random), 1.1 * ball_radius + y * distance + shift(random),
                            z * distance + shift(random)});
        one["mass"] = 10;
        text["bodies"].push_back(one);
    }
    return read_bouncing(text);
}

/// The momentum of all bodies along the ground, over the sum of the lengths of theirs.
double sideways_part(const World& world)
{
    Vec3 sum = Vec3::Zero();
    double lengths = 0;
    for (const auto& one : world.bodies) {
        sum += one->linear_momentum();
        lengths += one->linear_momentum().norm();
    }
    return std::hypot(sum.x(), sum.z()) / lengths;
}

}  // namespace

BallsApart balls_apart(int along_edge, double e, double dt, double duration)
{
    Scene scene = cube_of_balls(along_edge, e, dt, duration);
    const double moving = total_energy(scene.world).gravitational, start = counted_energy(scene.world, dt);
    BallsApart result{{-INFINITY, 0}};
    run(scene, chapter08_solver(scene.contact), {},
        {.stop = [&](const World& world, const Contacts& contacts) {
            for (const Contact& contact : contacts)
                if (contact.is_spring())
                    result.deepest = std::max(result.deepest, -contact_geometry(world, contact, 1).depth);
            result.sideways = std::max(result.sideways, sideways_part(world));
            result.energy.left = 1 + (counted_energy(world, dt) - start) / moving;
            result.energy.most_gained = std::max(result.energy.most_gained, result.energy.left - 1);
            return false;
        }});
    return result;
}

}  // namespace enduring::chapter08
