#include "chapters/08_contact_by_distance/experiments/shapes.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

/// A polygon that is cut into triangles, drawn out along z.
SurfaceMesh drawn_out(const std::vector<std::array<double, 2>>& outline, const std::vector<Face>& triangles,
                      double length)
{
    SurfaceMesh mesh;
    const int n = static_cast<int>(outline.size());
    for (const double z : {0.5 * length, -0.5 * length})
        for (const auto& [x, y] : outline)
            mesh.vertices.emplace_back(x, y, z);
    for (const auto& [a, b, c] : triangles)
        mesh.faces.insert(mesh.faces.end(), {{a, b, c}, {n + a, n + c, n + b}});
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        mesh.faces.insert(mesh.faces.end(), {{i, i + n, next + n}, {i, next + n, next}});
    }
    return mesh;
}

SurfaceMesh l_shape()
{
    return drawn_out({{0, 0}, {0.5, 0}, {0.5, 0.2}, {0.2, 0.2}, {0.2, 0.5}, {0, 0.5}},
                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}, 0.3);
}

SurfaceMesh u_shape()
{
    return drawn_out(
        {{0, 0}, {0.6, 0}, {0.6, 0.4}, {0.45, 0.4}, {0.45, 0.15}, {0.15, 0.15}, {0.15, 0.4}, {0, 0.4}},
        {{0, 5, 6}, {0, 6, 7}, {0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}}, 0.3);
}

/// A ball with hills and hollows.
SurfaceMesh lump(Numbers& numbers)
{
    SurfaceMesh mesh = sphere(0.2, 2);
    for (Vec3& vertex : mesh.vertices)
        vertex *= numbers.within(0.85, 1.15);
    return mesh;
}

}  // namespace

Eigen::Quaterniond Numbers::turn()
{
    constexpr double full = 2 * std::numbers::pi;
    const double part = next(), one = full * next(), other = full * next();
    return {std::sqrt(1 - part) * std::sin(one), std::sqrt(1 - part) * std::cos(one),
            std::sqrt(part) * std::sin(other), std::sqrt(part) * std::cos(other)};
}

std::string family_name(int family)
{
    constexpr std::array<const char*, family_count> names{
        "tetrahedra", "rods", "boxes", "balls", "L shapes", "U shapes", "lumps", "plates", "all of these"};
    return names.at(static_cast<std::size_t>(family));
}

SurfaceMesh shape_of(int family, Numbers& numbers)
{
    switch (family) {
        case 0: return tetrahedron(0.5);
        case 1: return box({0.8, 0.08, 0.08});
        case 2: return box({0.3, 0.2, 0.4});
        case 3: return sphere(0.2, 2);
        case 4: return l_shape();
        case 5: return u_shape();
        case 6: return lump(numbers);
        case 7: return box({0.4, 0.02, 0.4});
        default: return shape_of(numbers.below(mixed_family), numbers);
    }
}

Scene random_heap(const HeapPlan& plan)
{
    constexpr double apart = 0.95;
    Numbers numbers(plan.seed);
    Scene scene = chapter07::scene_of({}, plan.dt, 0, plan.mu, plan.mu);
    const int side = std::max(2, static_cast<int>(std::ceil(std::cbrt(0.5 * plan.bodies))));
    for (int i = 0; i < plan.bodies; ++i) {
        SurfaceMesh mesh = shape_of(plan.family, numbers);
        const Eigen::Quaterniond turn = numbers.turn();
        const int layer = i / (side * side), at = i % (side * side);
        const double x = apart * (at % side - 0.5 * (side - 1)) + numbers.within(-0.05, 0.05);
        const double z = apart * (at / side - 0.5 * (side - 1)) + numbers.within(-0.05, 0.05);
        Vec3 middle = Vec3::Zero();
        for (const Vec3& vertex : mesh.vertices)
            middle += vertex / static_cast<double>(mesh.vertices.size());
        for (Vec3& vertex : mesh.vertices)
            vertex = turn * (vertex - middle) + Vec3(x, 0.6 + apart * layer, z);
        const double mass = numbers.within(1, 10);
        const Vec3 spin = plan.spin > 0
                              ? Vec3(numbers.within(0, plan.spin) * (numbers.turn() * Vec3::UnitX()))
                              : Vec3::Zero();
        scene.world.bodies.push_back(std::make_unique<RigidBody>("body " + std::to_string(i + 1), mesh,
                                                                 with_mass(mass_properties(mesh, 1000), mass),
                                                                 Vec3::Zero(), spin));
    }
    return scene;
}

}  // namespace enduring::chapter08
