#include "chapters/08_contact_by_distance/experiments/fast_shots.hpp"

#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

SurfaceMesh mesh_of(FastVolley::Shape shape)
{
    switch (shape) {
        case FastVolley::Shape::ball: return sphere(0.1, 2);
        case FastVolley::Shape::box: return box({0.15, 0.1, 0.2});
        default: return tetrahedron(0.2);
    }
}

std::unique_ptr<Body> plate_of(bool free)
{
    const SurfaceMesh mesh = box({1, 0.002, 1});
    if (free)
        return std::make_unique<RigidBody>("plate", mesh, with_mass(mass_properties(mesh, 1000), 20));
    return std::make_unique<StaticBody>(
        "plate", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices);
}

std::unique_ptr<Body> shot_of(const FastVolley& volley, Numbers& numbers)
{
    SurfaceMesh mesh = mesh_of(volley.shape);
    const Eigen::Quaterniond turn = numbers.turn(), direction = numbers.turn();
    const double around = 2 * std::numbers::pi * numbers.next();
    const double tilt = volley.way == FastVolley::Way::oblique ? std::numbers::pi / 4 : 0;
    const Vec3 way(std::sin(tilt) * std::cos(around), -std::cos(tilt), std::sin(tilt) * std::sin(around));
    const double x = numbers.within(-0.25, 0.25), z = numbers.within(-0.25, 0.25);
    const Vec3 from = Vec3(x, 0, z) - 0.3 / std::cos(tilt) * way;
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * vertex + from;
    const Vec3 spin = volley.way == FastVolley::Way::spinning ? Vec3(direction * Vec3(100, 0, 0))
                                                              : Vec3(Vec3::Zero());
    return std::make_unique<RigidBody>("shot", mesh, with_mass(mass_properties(mesh, 1000), 2),
                                       volley.speed * way, spin);
}

/// Of a point over the middle of the plate, seen from one of its large sides, always the same one [m].
double height_over(const Body& plate, const Vec3& point)
{
    const auto at = plate.positions_t0();
    Vec3 up = Vec3::Zero();
    for (const auto& [a, b, c] : plate.surface().faces()) {
        const Vec3& corner = at[static_cast<std::size_t>(a)];
        const Vec3 normal =
            (at[static_cast<std::size_t>(b)] - corner).cross(at[static_cast<std::size_t>(c)] - corner);
        if (normal.norm() > 1.001 * up.norm())  // two faces of a side are equal
            up = normal;
    }
    return up.normalized().dot(point - plate.centre());
}

}  // namespace

std::vector<FastVolley> fast_volleys()
{
    using Shape = FastVolley::Shape;
    using Way = FastVolley::Way;
    std::vector<FastVolley> all;
    for (const bool free : {false, true})
        for (const double speed : {1.0, 10.0, 100.0, 1000.0})
            for (const Shape shape : {Shape::ball, Shape::box, Shape::tetrahedron})
                for (const Way way : {Way::straight, Way::oblique, Way::spinning})
                    all.push_back({free, speed, shape, way});
    return all;
}

void FastOutcome::add(const FastOutcome& other)
{
    shots += other.shots;
    through += other.through;
    deepest_m = std::max(deepest_m, other.deepest_m);
    max_energy = std::max(max_energy, other.max_energy);
    unsolved += other.unsolved;
}

FastOutcome shoot(const FastVolley& volley, double dt, unsigned seed)
{
    FastOutcome outcome{.shots = 1};
    Numbers numbers(seed);
    World world;
    world.gravity = Vec3::Zero();
    world.bodies.push_back(plate_of(volley.free_plate));
    world.bodies.push_back(shot_of(volley, numbers));
    ContactParameters parameters;
    parameters.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.5};
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) { outcome.unsolved += !record.converged; };
    const Solver solver = chapter08_solver(parameters, settings);
    const Body &plate = *world.bodies[0], &shot = *world.bodies[1];
    const bool above = height_over(plate, shot.centre()) > 0;
    const double first = total_energy(world).kinetic;
    Contacts contacts;
    const long steps = std::lround(std::ceil(0.5 / volley.speed / dt)) + 20;
    for (long i = 0; i < steps; ++i) {
        advance(world, contacts, solver, dt);
        outcome.deepest_m = std::max(outcome.deepest_m, chapter07::true_depth(world));
        outcome.max_energy = std::max(outcome.max_energy, total_energy(world).kinetic / first);
        const double height = height_over(plate, shot.centre());
        if ((height > 0) != above && (shot.centre() - plate.centre()).norm() < 0.5)
            outcome.through = 1;
    }
    return outcome;
}

}  // namespace enduring::chapter08
