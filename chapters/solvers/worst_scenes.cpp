#include "chapters/solvers/worst_scenes.hpp"

#include "chapters/solvers/bicycle_chain.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace enduring::solvers {
namespace {

Scene empty_scene(std::string name)
{
    Scene scene;
    scene.name = std::move(name);
    scene.dt = 0.01;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.5};
    scene.world.planes.push_back({"ground"});
    return scene;
}

void add_moving(Scene& scene, const std::string& name, SurfaceMesh mesh, double mass, const Vec3& at,
                const Vec3& velocity = Vec3::Zero())
{
    for (Vec3& vertex : mesh.vertices)
        vertex += at;
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        name, mesh, with_mass(mass_properties(mesh, 1000), mass), velocity, Vec3::Zero()));
}

void add_standing(Scene& scene, const std::string& name, const SurfaceMesh& mesh)
{
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

/// Spheres in layers of 4 x 4, each a little beside its place.
/// @param height  of the lowest layer's centres
void add_spheres(Scene& scene, int count, double height)
{
    std::mt19937 random(1);
    const auto number = [&] { return static_cast<double>(random()) / std::mt19937::max() - 0.5; };
    constexpr double apart = 0.24;
    for (int i = 0; i < count; ++i) {
        const double x = 0.02 * number(), z = 0.02 * number();
        const int column = i % 4, row = i / 4 % 4, layer = i / 16;
        const Vec3 at(apart * (column - 1.5) + x, height + apart * layer, apart * (row - 1.5) + z);
        add_moving(scene, "sphere " + std::to_string(i + 1), sphere(0.1), 1, at);
    }
}

/// A ring around y, or around z where it stands upright.
SurfaceMesh ring(double radius, double thickness, bool upright)
{
    SurfaceMesh mesh = torus(radius, thickness / 2);
    if (upright)
        for (Vec3& vertex : mesh.vertices)
            vertex = Vec3(vertex.x(), vertex.z(), -vertex.y());
    return mesh;
}

}  // namespace

Scene hit_wall(int columns, int rows)
{
    Scene scene = empty_scene("wall of " + std::to_string(columns * rows) + " bricks");
    const Vec3 size(0.4, 0.2, 0.2);
    constexpr double gap = 0.002;  // between neighbours of a row; a quarter of it between rows
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double x = (size.x() + gap) * (column - 0.5 * columns + 0.5 * (row % 2)),
                         y = size.y() / 2 + (size.y() + gap / 4) * row + gap / 4;
            add_moving(scene, "brick " + std::to_string(row + 1) + "." + std::to_string(column + 1),
                       box(size), 15, Vec3(x, y, 0));
        }
    add_moving(scene, "ball", sphere(0.3), 200, Vec3(0.03, 0.1 * rows, -0.6), Vec3(0, 0, 15));
    return scene;
}

Scene poured_spheres(int count)
{
    Scene scene = empty_scene(std::to_string(count) + " spheres into a box");
    constexpr double half = 0.55;
    for (const double side : {-1.0, 1.0}) {
        scene.world.planes.push_back({"wall x", Vec3(side * half, 0, 0), Vec3(-side, 0, 0)});
        scene.world.planes.push_back({"wall z", Vec3(0, 0, side * half), Vec3(0, 0, -side)});
    }
    add_spheres(scene, count, 0.15);
    return scene;
}

Scene hopper(int count)
{
    Scene scene = empty_scene("hopper of " + std::to_string(count) + " spheres");
    for (int side = 0; side < 4; ++side) {
        SurfaceMesh plate = box(Vec3(2.4, 0.1, 1.8));
        const Eigen::AngleAxisd turn(side * std::numbers::pi / 2, Vec3::UnitY()),
            tilt(0.9, Vec3::UnitX());  // the plate rises away from the hole
        for (Vec3& vertex : plate.vertices)
            vertex = turn * (tilt * (vertex + Vec3(0, 0, -0.9)) + Vec3(0, 0.6, -0.3));
        add_standing(scene, "plate " + std::to_string(side + 1), plate);
    }
    add_spheres(scene, count, 1.1);
    return scene;
}

Scene hanging_chain(int links)
{
    Scene scene = empty_scene("chain of " + std::to_string(links) + " links");
    constexpr double radius = 0.05, thickness = 0.02, pitch = 0.078;  // play of 2 mm a link
    for (int i = 0; i < links; ++i) {
        SurfaceMesh link = ring(radius, thickness, i % 2 == 0);
        const Vec3 at(pitch * (i - 0.5 * links), 3, 0);
        if (i > 0 && i + 1 < links) {
            add_moving(scene, "link " + std::to_string(i + 1), link, 0.2, at);
            continue;
        }
        for (Vec3& vertex : link.vertices)
            vertex += at;
        add_standing(scene, "link " + std::to_string(i + 1), link);
    }
    return scene;
}

Scene bicycle_chain(int links)
{
    Scene scene = empty_scene("bicycle chain of " + std::to_string(links) + " links");
    constexpr double mass = 0.0025;
    const double turn = 2 * std::numbers::pi / links,
                 radius = 0.5 * ChainLink::pitch / std::tan(turn / 2);  // to the middles of links
    for (int i = 0; i < links; ++i) {
        const bool is_outer = i % 2 == 0;
        SurfaceMesh link = is_outer ? ChainLink::outer() : ChainLink::inner();
        const Eigen::AngleAxisd around(i * turn, Vec3::UnitY());
        for (Vec3& vertex : link.vertices)
            vertex = around * (vertex + Vec3(0, 0, radius));
        const double height = ChainLink::outer_half_height - (is_outer ? 0 : ChainLink::play);
        add_moving(scene, "link " + std::to_string(i + 1), link, mass, Vec3(0, height, 0));
    }
    return scene;
}

}  // namespace enduring::solvers
