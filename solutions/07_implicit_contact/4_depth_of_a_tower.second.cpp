#include "exercises/07_implicit_contact/4_depth_of_a_tower.hpp"

#include "chapters/07_implicit_contact/solver.hpp"

#include <Eigen/LU>

#include <algorithm>

namespace enduring {
namespace {

struct Span {
    double lowest, highest;
};

Span span_of(const Body& body)
{
    Span span{INFINITY, -INFINITY};
    for (const Vec3& vertex : body.positions_t0())
        span = {std::min(span.lowest, vertex.y()), std::max(span.highest, vertex.y())};
    return span;
}

}  // namespace

double predicted_factor() { return 100; }

std::vector<double> loads_of(const Tower& tower)
{
    std::vector<double> loads;
    for (auto lowest = tower.begin(); lowest != tower.end(); ++lowest) {
        double load = 0;
        for (auto piece = lowest; piece != tower.end(); ++piece)
            load += piece->mass * tower_gravity;
        loads.push_back(load);
    }
    return loads;
}

double mass_of_pair(const Tower& tower, std::size_t joint)
{
    const Vec3 arm(0, 0, tower[joint].radius);
    double response = 0;
    for (std::size_t piece = joint > 0 ? joint - 1 : 0; piece <= joint; ++piece) {
        const auto& [radius, height, mass] = tower[piece];
        const Mat3 inertia = with_mass(mass_properties(prism(radius, 0, height), 1), mass).inertia;
        const Vec3 turn = arm.cross(Vec3::UnitY());
        response += 1 / mass + turn.dot(inertia.inverse() * turn);
    }
    return 1 / response;
}

std::vector<double> law_of_depths(const Tower& tower, const StiffnessChoice& choice, double dt)
{
    std::vector<double> depths = loads_of(tower);
    for (std::size_t joint = 0; joint < depths.size(); ++joint) {
        const double by_mass = depths[joint] / 3 * dt * dt /
                               (choice.k_dt2_over_m * mass_of_pair(tower, joint));
        depths[joint] = std::min(by_mass, choice.depth());
    }
    return depths;
}

std::vector<double> measured_depths(const Tower& tower, const StiffnessChoice& choice, double dt,
                                    double seconds)
{
    World world = world_of(tower);
    ImplicitSettings settings;
    settings.stiffness = choice;
    const Solver solver = chapter07_solver({}, settings);
    Contacts contacts;
    while (world.time < seconds)
        advance(world, contacts, solver, dt);
    std::vector<double> depths;
    double below = 0;
    for (const auto& body : world.bodies) {
        const auto [lowest, highest] = span_of(*body);
        depths.push_back(below - lowest);
        below = highest;
    }
    return depths;
}

}  // namespace enduring
