#include "chapters/08_contact_by_distance/experiments/freed_scenes.hpp"

#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {

using namespace driven_parts;

AgainstFormula puck_on_spring(double dt)
{
    constexpr double start = 0.5, stiffness = 50, mass = 2, mu = 0.1;
    json text = scene_text("spring", dt, 2, mu, mu);
    json puck = box_body("puck", "rigid", {0.3, 0.05, 0.3}, {start, 0.025, 0});
    puck["forces"] =
        json::array({json::object({{"spring", {{"anchor", {0, 0.025, 0}}, {"stiffness", stiffness}}}})});
    text["planes"] = json::array({json::object({{"name", "ground"}})});
    text["bodies"] = json::array({puck});
    Scene scene = scene_from(text);
    double turns_at = start;
    run_watched(scene, [&](const World& world) {
        const double now = world.bodies[0]->centre().x();
        const bool comes_back = now > turns_at;
        turns_at = now;
        return comes_back;
    });
    return {turns_at, -(start - 2 * mu * mass * earth / stiffness)};
}

namespace {

/// Two walls that face each other, with a gap between them.
SurfaceMesh slot(double gap)
{
    SurfaceMesh both;
    for (const double side : {-1.0, 1.0}) {
        const SurfaceMesh wall = box({0.1, 0.8, 0.2});
        const auto first = static_cast<int>(both.vertices.size());
        both.vertices.reserve(both.vertices.size() + wall.vertices.size());
        both.faces.reserve(both.faces.size() + wall.faces.size());
        for (const Vec3& vertex : wall.vertices)
            both.vertices.push_back(vertex + side * (gap / 2 + 0.05) * Vec3::UnitX());
        for (const auto& [a, b, c] : wall.faces)
            both.faces.push_back({first + a, first + b, first + c});
    }
    return both;
}

}  // namespace

AgainstFormula pin_in_slot(double dt)
{
    constexpr double radius = 0.2, spin = 4, pin = 0.1;
    const double turn = 2 * std::numbers::pi / spin;
    json table = json::array();
    for (int row = -1; row <= 129; ++row) {
        const double angle = 2 * std::numbers::pi * row / 64;
        table.push_back({{"time", turn * row / 64},
                         {"displacement", {radius * std::cos(angle), radius * std::sin(angle), 0}}});
    }
    json text = scene_text("yoke", dt, 2 * turn, 0, 0);
    text["gravity"] = {0, 0, 0};
    json driven = box_body("pin", "static", {pin, pin, 0.4}, {0, 0, 0});
    driven["motion"] = {{"table", table}};
    text["bodies"] = json::array({driven});
    Scene scene = scene_from(text);
    SurfaceMesh yoke = slot(pin);
    for (Vec3& vertex : yoke.vertices)
        vertex.x() += radius;
    auto body = std::make_unique<RigidBody>("yoke", yoke, with_mass(mass_properties(yoke, 1), 1));
    body->hold({Vec3::UnitX(), Vec3::Zero()});
    scene.world.bodies.push_back(std::move(body));
    AgainstFormula worst{1, 1};
    run_watched(scene, [&](const World& world) {
        const AgainstFormula now{world.bodies[1]->centre().x(), radius * std::cos(spin * world.time)};
        if (std::abs(now.measured - now.formula) > std::abs(worst.measured - worst.formula))
            worst = now;
        return false;
    });
    return worst;
}

AgainstFormula turned_by_two_forces(double dt)
{
    constexpr double force = 0.2, mass = 2, length = 1, side = 0.2, time = 0.4;
    json text = scene_text("two forces", dt, time, 0, 0);
    text["gravity"] = {0, 0, 0};
    json bar{{"name", "bar"},
             {"type", "deformable"},
             {"shape", {{"bar", {{"size", {length, side, side}}, {"cells", {4, 1, 1}}}}}},
             {"mass", mass},
             {"young", 1e7},
             {"poisson", 0.3}};
    bar["forces"] = {{{"force", {0, 0, -force}}, {"point", {length / 2, 0, 0}}},
                     {{"force", {0, 0, force}}, {"point", {-length / 2, 0, 0}}}};
    text["bodies"] = json::array({bar});
    Scene scene = scene_from(text);
    run_whole(scene);
    const std::span<const Vec3> corners = scene.world.bodies[0]->positions_t0();
    Vec3 axis = Vec3::Zero();
    const Scene unmoved = scene_from(text);
    for (std::size_t i = 0; i < corners.size(); ++i)
        axis += unmoved.world.bodies[0]->positions_t0()[i].x() * corners[i];
    const double inertia = mass / 12 * (length * length + side * side);
    return {std::atan2(-axis.z(), axis.x()), force * length * time * time / (2 * inertia)};
}

LetGo twisted_and_let_go(double dt, const TwistedBar& of_bar)
{
    constexpr double length = 1, side = 0.06, young = 2e5, poisson = 0.3, density = 1000, freed = 1;
    json text = scene_text("let go", dt, 1.6, 0, 0);
    json bar{{"name", "bar"},    {"type", "deformable"}, {"density", density},
             {"young", young},   {"poisson", poisson},   {"elasticity", "corotated_at_points"},
             {"gravity", false}, {"basis", of_bar.basis}};
    bar["shape"]["bar"] = {{"size", {length, side, side}},
                           {"cells", {of_bar.along, of_bar.across, of_bar.across}}};
    bar["fixed"] = {{"max", {-0.499, 1, 1}}};
    json end{{"min", {0.499, -1, -1}}, {"until", freed}};
    end["motion"]["table"] = {
        {{"time", 0}}, {{"time", freed}, {"turn", {{"axis", {1, 0, 0}}, {"angle_deg", of_bar.turn_deg}}}}};
    bar["driven"] = json::array({end});
    text["bodies"] = json::array({bar});
    Scene scene = scene_from(text);
    const Body& body = *scene.world.bodies[0];
    const std::span<const Vec3> start = body.positions_t0();
    std::size_t corner = 0;
    for (std::size_t i = 0; i < start.size(); ++i)
        if ((start[i] - Vec3(length, side, side) / 2).norm() < 1e-9)
            corner = i;
    const auto angle_of = [&] {
        const Vec3& x = body.positions_t0()[corner];
        return std::atan2(x.z(), x.y()) - std::numbers::pi / 4;
    };
    double angle = 0, held = 0, most = 0, first = -1, half = 0;
    run_watched(scene, [&](const World& world) {
        const double way = std::remainder(angle_of() - angle, 2 * std::numbers::pi), before = angle;
        angle += way;
        const double energy = total_energy(world).total();
        if (world.time < freed + dt / 2)
            held = energy;
        else
            most = std::max(most, energy);
        if (world.time < freed + dt / 2 || (before > 0) == (angle > 0))
            return false;
        const double passed = world.time - dt * angle / way;
        half = passed - first;
        const bool is_second = first >= 0;
        first = passed;
        return is_second;
    });
    constexpr double torsion = 0.1405770 * 6;  // of J over I_p, of a square
    const double speed = std::sqrt(young / (2 * (1 + poisson)) / density * torsion);
    return {{2 * half, 4 * length / speed}, most / held};
}

}  // namespace enduring::chapter08
