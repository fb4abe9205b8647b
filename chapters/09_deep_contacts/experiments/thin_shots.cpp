#include "chapters/09_deep_contacts/experiments/thin_shots.hpp"

#include "common/input/number_text.hpp"
#include "common/scenes/scene_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace enduring::chapter09 {
namespace {

constexpr double half_plate = 0.6, shell_radius = 0.6;  // [m]
constexpr double start_distance = 0.45;                 // of the middles, from the target's [m]

std::string text_of(const Vec3& v)
{
    std::string text = shortest(v.x());
    for (const int i : {1, 2})
        text += ", " + shortest(v[i]);
    return std::string("[").append(text).append("]");
}

//! [targets]
const std::string plate = R"("shape": {"box": {"size": [1.2, 0.012, 1.2], "cells": )",
                  shell = R"("shape": {"bowl": {"inner_radius": 0.6, "thickness": 0.012, "rim_angle_deg": 100,
                              "segments_around": 20, "segments_along": 10, "segments_rim": 2}})";

const std::map<std::string, std::string> shots{
    {"ball", R"("shape": {"sphere": {"radius": 0.1, "subdivisions": 1}})"},
    {"cube", R"("shape": {"box": {"size": [0.15, 0.15, 0.15]}})"},
    {"plate", R"("shape": {"box": {"size": [0.3, 0.003, 0.3], "cells": [2, 1, 2]}})"}};
//! [targets]

Vec3 any_direction(std::mt19937_64& random)
{
    std::normal_distribution<double> normal;
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vec3(x, y, z).normalized();
}

Vec3 face_normal(const Body& body, int face)
{
    const auto [a, b, c] = body.surface().faces()[face];
    const auto x = body.positions_t0();
    return (x[b] - x[a]).cross(x[c] - x[a]).normalized();
}

int face_that_looks_up(const Body& body)
{
    int face = 0;
    while (face_normal(body, face).y() < 0.99)
        ++face;
    return face;
}

/// Within an angle of a direction [rad].
Vec3 direction_within(const Vec3& middle, double angle, std::mt19937_64& random)
{
    for (;;)
        if (const Vec3 way = any_direction(random); way.dot(middle) > std::cos(angle))
            return way;
}

}  // namespace

const std::vector<ThinTarget>& thin_targets()
{
    static const std::vector<ThinTarget> all{
        {"plate of one cell", R"("type": "static", )" + plate + "[1, 1, 1]}}"},
        {"plate", R"("type": "static", )" + plate + "[6, 1, 6]}}"},
        {"free plate", R"("type": "rigid", "mass": 20, )" + plate + "[6, 1, 6]}}"},
        {"shell", R"("type": "static", )" + shell, true}};
    return all;
}

const std::vector<std::string>& thin_shots()
{
    static const std::vector<std::string> names{"ball", "cube", "plate"};
    return names;
}

//! [shot]
ThinShot shot_at_random(const ThinTarget& target, const std::string& body, std::mt19937_64& random)
{
    constexpr double sixty_degrees = std::numbers::pi / 3;
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const double side = between(0, 1) < 0.5 ? 1 : -1, speed = std::pow(40.0, between(0, 1)),
                 dt = std::array{0.005, 0.01, 1.0 / 60}.at(static_cast<std::size_t>(between(0, 3)));
    const double x = between(-0.3, 0.3), z = between(-0.3, 0.3);
    Vec3 aim(x, 0, z), out = side * Vec3::UnitY();
    if (target.shell) {
        out = direction_within(-Vec3::UnitY(), sixty_degrees, random);
        aim = shell_radius * out;
        out *= -side;
    }
    const Vec3 way = direction_within(-out, target.shell && side > 0 ? sixty_degrees / 2 : sixty_degrees,
                                      random);
    const int steps = static_cast<int>(std::ceil(start_distance / speed / dt)) + 20;
    const Vec3 axis = any_direction(random), spin = any_direction(random) * between(0, 10);
    const std::string turned = R"("rotation": {"axis": )" + text_of(axis) + R"(, "angle_deg": )" +
                               shortest(between(0, 180)) + "}, ",
                      moves = R"("position": )" + text_of(aim - start_distance * way) + R"(, "velocity": )" +
                              text_of(speed * way) + R"(, "angular_velocity": )" + text_of(spin);
    Scene scene = read_scene(R"({"name": "thin", "gravity": [0, 0, 0], "dt": )" + shortest(dt) +
                                 R"(, "duration": )" + shortest(steps * dt) +
                                 R"(, "camera": {"eye": [1.4, 1.0, 2.2], "target": [0, 0, 0]},
        "bodies": [{"name": "target", )" +
                                 target.body +
                                 R"(}, {"name": "shot", "type": "rigid", "mass": 2,
        "look": {"color": [0.5, 0.16, 0.08]}, )" +
                                 shots.at(body) + ", " + turned + moves + "}]}",
                             "", "thin.json", {});
    const int upper_face = target.shell ? -1 : face_that_looks_up(*scene.world.bodies[0]);
    return {&target, body, side, speed, upper_face, std::move(scene)};
}
//! [shot]

bool is_through(const ThinShot& shot, const World& world)
{
    const Vec3 middle = world.bodies[1]->centre();
    if (shot.target->shell) {
        const double below = std::acos(std::clamp(-middle.normalized().y(), -1.0, 1.0));
        return shot.side * (middle.norm() - shell_radius - 0.006) > 0 && below < 1.4;
    }
    // A free plate moves and turns, and its upper side with it.
    const Body& target = *world.bodies[0];
    const Vec3 normal = face_normal(target, shot.upper_face), offset = middle - target.centre(),
               along = offset - offset.dot(normal) * normal;
    return along.norm() < half_plate && shot.side * offset.dot(normal) < 0;
}

}  // namespace enduring::chapter09
