#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter07 {
namespace {

constexpr double pi = std::numbers::pi;

void add_rigid(Scene& scene, const std::string& name, const SurfaceMesh& mesh, double mass)
{
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass)));
}

void add_static(Scene& scene, const std::string& name, const SurfaceMesh& mesh)
{
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

/// About the vertical.
Eigen::AngleAxisd turn_by(double degrees) { return {degrees * pi / 180, Vec3::UnitY()}; }

double half_width(double angle_deg) { return std::tan(0.5 * angle_deg * pi / 180); }

/// 1 m high, the tip down at the origin.
SurfaceMesh tip_mesh(Tip tip, double angle_deg)
{
    const double half = half_width(angle_deg);
    if (tip == Tip::wedge)
        return prism({{0, 0}, {half, 1}, {-half, 1}}, 1);
    const double edge = 2 * half, height = edge * std::sqrt(2.0 / 3);
    SurfaceMesh spike = tetrahedron(edge);
    for (Vec3& vertex : spike.vertices)  // turned upside down about x, drawn out to 1 m
        vertex = Vec3(vertex.x(), 0.75 - vertex.y() / height, -vertex.z());
    return spike;
}

}  // namespace

SurfaceMesh prism(const std::vector<std::array<double, 2>>& outline, double length)
{
    SurfaceMesh mesh;
    const int n = static_cast<int>(outline.size());
    for (const double z : {0.5 * length, -0.5 * length})
        for (const auto& [x, y] : outline)
            mesh.vertices.emplace_back(x, y, z);
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        mesh.faces.push_back({i, i + n, next + n});
        mesh.faces.push_back({i, next + n, next});
        if (i > 0 && next > 0) {
            mesh.faces.push_back({0, i, next});
            mesh.faces.push_back({n, next + n, i + n});
        }
    }
    return mesh;
}

std::vector<Box> card_house(int levels, double lean_deg)
{
    const double thick = 0.02, lean = lean_deg * pi / 180, gap = 1e-3;
    const double height = std::cos(lean) + thick * std::sin(lean);
    const double apart = 2 * (std::sin(lean) + thick * std::cos(lean)) + gap;  // from pair to pair
    std::vector<Box> cards;
    for (int level = 0; level < levels; ++level) {
        const double floor = level * (height + thick);
        const int pairs = levels - level;
        for (int pair = 0; pair < pairs; ++pair) {
            const double middle = (pair - 0.5 * (pairs - 1)) * apart;
            for (const int side : {-1, 1})
                cards.push_back({1,
                                 Vec3(middle + side * 0.5 * (thick * std::cos(lean) + std::sin(lean)),
                                      floor + 0.5 * height, 0),
                                 side * lean_deg, Vec3::UnitZ(), Vec3(thick, 1, 1)});
        }
        for (int flat = 0; flat + 1 < pairs; ++flat) {
            // It ends over the middle of a pair if there is another one, else beyond it.
            const double left = flat == 0 ? -0.1 : 0.5 * gap;
            const double right = flat + 2 == pairs ? 0.1 : -0.5 * gap;
            const double middle = (flat + 0.5 - 0.5 * (pairs - 1)) * apart + 0.5 * (left + right);
            cards.push_back({1, Vec3(middle, floor + height + 0.5 * thick, 0), 0, Vec3::UnitZ(),
                             Vec3(apart + right - left, thick, 1)});
        }
    }
    return cards;
}

Scene arch(int stones, double radius, double dt, double other_depth)
{
    Scene scene = scene_of({}, dt);
    for (int i = 0; i < stones; ++i) {
        const double from = pi * i / stones, to = pi * (i + 1) / stones;
        const double inner = radius - 0.5, outer = radius + 0.5;
        add_rigid(scene, "stone " + std::to_string(i + 1),
                  prism({{inner * std::cos(from), inner * std::sin(from)},
                         {outer * std::cos(from), outer * std::sin(from)},
                         {outer * std::cos(to), outer * std::sin(to)},
                         {inner * std::cos(to), inner * std::sin(to)}},
                        i % 2 == 0 ? 1 : other_depth),
                  10);
    }
    return scene;
}

Scene tip_in_crack(Tip tip, double tip_deg, double crack_deg, double dt)
{
    Scene scene = scene_of({}, dt);
    scene.world.planes.clear();
    const double half = half_width(crack_deg);
    add_static(scene, "crack",
               prism({{0, 0}, {-half, 1}, {-1, 1}, {-1, -0.3}, {1, -0.3}, {1, 1}, {half, 1}}, 2));
    add_rigid(scene, "tip", placed(tip_mesh(tip, tip_deg), turn_by(10), {0.02, 1, 0.03}), 10);
    return scene;
}

Scene wedge_on_edge(double dt)
{
    Scene scene = scene_of({}, dt);
    add_static(scene, "edge", prism({{0, 1}, {-0.3, 0}, {0.3, 0}}, 1));
    add_rigid(scene, "wedge", placed(tip_mesh(Tip::wedge, 33), turn_by(80), {0.05, 1.001, 0.03}), 10);
    return scene;
}

Scene cube_between_planes(double half_angle_deg, double mu, double dt)
{
    const double angle = half_angle_deg * pi / 180, touching = 0.55 / std::tan(angle) + 0.5;
    Scene scene = scene_of({{.centre = Vec3(0.05, touching + 0.2, 0)}}, dt, 0, mu, mu);
    scene.world.planes = {{"left", Vec3::Zero(), Vec3(std::cos(angle), std::sin(angle), 0)},
                          {"right", Vec3::Zero(), Vec3(-std::cos(angle), std::sin(angle), 0)}};
    return scene;
}

}  // namespace enduring::chapter07
