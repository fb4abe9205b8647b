#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"
#include "chapters/08_contact_by_distance/experiments/gaps.hpp"
#include "chapters/08_contact_by_distance/experiments/gears.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/polygon_triangles.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace enduring::chapter08 {
namespace {

constexpr double pitch = 0.02, tall = 0.03, back = 0.02, deep = 0.04;  ///< of a comb [m]
constexpr int teeth = 5;

/// A comb with its teeth up, between x = 0 and x = 0.1, its back below y = 0.
SurfaceMesh comb(double tooth)
{
    std::vector<std::pair<double, double>> outline{{0, -back}, {teeth * pitch, -back}};
    for (int i = teeth - 1; i >= 0; --i) {
        const double left = i * pitch + 0.5 * (pitch - tooth), right = left + tooth;
        outline.insert(outline.end(), {{right, 0}, {right, tall}, {left, tall}, {left, 0}});
        if (i == teeth - 1)
            outline.insert(outline.end() - 4, {teeth * pitch, 0});
    }
    outline.emplace_back(0, 0);
    const long n = static_cast<long>(outline.size());
    std::vector<Vec3> vertices;
    for (const double z : {0.5 * deep, -0.5 * deep})
        for (const auto& [x, y] : outline)
            vertices.emplace_back(x, y, z);
    std::vector<std::vector<long>> polygons(2);
    for (long i = 0; i < n; ++i) {
        polygons[0].push_back(i);
        polygons[1].push_back(2 * n - 1 - i);
        polygons.push_back({i, i + n, (i + 1) % n + n, (i + 1) % n});
    }
    return surface_from_polygons(vertices, polygons,
                                 [](long, const std::string& reason) { throw std::logic_error(reason); });
}

void add(Scene& scene, const std::string& name, const SurfaceMesh& mesh, bool held,
         const Vec3& velocity = Vec3::Zero())
{
    if (held)
        scene.world.bodies.push_back(std::make_unique<StaticBody>(
            name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
    else
        scene.world.bodies.push_back(
            std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 1000), velocity));
}

/// A ring around y; its tube is half as thick as its hole is wide.
SurfaceMesh chain_link(double hole)
{
    const double tube = 0.25 * hole;
    return torus(hole + tube, tube);
}

/// A gear with ends of other faces: a fan about the axis has some without an area, where the flanks are
/// radial, and with these a surface cannot move inwards.
SurfaceMesh flat_ended(SurfaceMesh gear)
{
    const int n = static_cast<int>(gear.vertices.size()) / 2 - 1;
    std::erase_if(gear.faces, [&](const Face& face) {
        return std::any_of(face.begin(), face.end(), [&](int vertex) { return vertex >= 2 * n; });
    });
    gear.vertices.resize(2 * static_cast<std::size_t>(n));
    std::vector<int> low(static_cast<std::size_t>(n)), high(static_cast<std::size_t>(n));
    std::iota(low.rbegin(), low.rend(), 0);
    std::iota(high.begin(), high.end(), n);
    append_triangles(low, gear.vertices, gear.faces);
    append_triangles(high, gear.vertices, gear.faces);
    return gear;
}

Scene empty_scene(double dt)
{
    Scene scene = chapter07::scene_of({}, dt);
    scene.world.planes.clear();
    return scene;
}

}  // namespace

Scene scene_of(const Combs& combs)
{
    Scene scene = empty_scene(combs.dt);
    const SurfaceMesh lower = comb(0.5 * pitch - combs.play);
    // upside down: its teeth hang between those of the lower one, half a pitch beside them
    const Quaternion turn(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitZ()));
    const SurfaceMesh upper = placed(lower, turn, {(teeth + 0.5) * pitch, tall + combs.rise, 0});
    add(scene, "lower", lower, combs.lower_held);
    add(scene, "upper", upper, false, combs.velocity);
    return scene;
}

Scene plates_apart(double gap, double dt)
{
    Scene scene = empty_scene(dt);
    const Quaternion lean(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
    add(scene, "lower", placed(box({0.1, 0.02, 0.1}), lean, lean * Vec3(0, -0.01, 0)), false);
    add(scene, "upper", placed(box({0.1, 0.02, 0.1}), lean, lean * Vec3(0, 0.01 + gap, 0)), false);
    return scene;
}

Scene cups_apart(double gap, double dt)
{
    Scene scene = empty_scene(dt);
    BowlShape cup{.inner_radius = 0.04, .thickness = 0.002, .segments_around = 24, .segments_along = 8};
    add(scene, "outer", bowl(cup), false);
    cup.inner_radius -= cup.thickness + gap;
    add(scene, "inner", bowl(cup), false);
    return scene;
}

Scene links_apart(double play, double dt)
{
    Scene scene = empty_scene(dt);
    constexpr double hole = 0.04;  // radius of a link's
    for (int i = 0; i < 5; ++i) {
        const Quaternion turn(Eigen::AngleAxisd(i % 2 * std::numbers::pi / 2, Vec3::UnitX()));
        add(scene, "link " + std::to_string(i + 1),
            placed(chain_link(hole), turn, {i * (2 * hole - play), 0, 0}), false);
    }
    return scene;
}

Scene paper_apart(double gap, double dt)
{
    Scene scene = empty_scene(dt);
    constexpr double thickness = 1e-4;
    const Quaternion lean(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
    for (int i = 0; i < 6; ++i)
        add(scene, "sheet " + std::to_string(i + 1),
            placed(box({0.21, thickness, 0.297}, {2, 1, 3}), lean, lean * Vec3(0, i * (thickness + gap), 0)),
            false);
    return scene;
}

Scene sheets_apart(double gap, double dt)
{
    using driven_parts::json;
    json scene = driven_parts::scene_text("sheets", dt, 1, 0.5, 0.4);
    for (int i = 0; i < 6; ++i)
        scene["bodies"].push_back({{"name", "sheet " + std::to_string(i + 1)},
                                   {"type", "rigid"},
                                   {"sheet", true},
                                   {"mass", 0.005},
                                   {"shape", {{"plane_grid", {{"size", {0.21, 0.297}}, {"cells", {2, 3}}}}}},
                                   {"position", {0, i * gap, 0}}});
    return driven_parts::scene_from(scene);
}

Scene gears_apart(double play, double dt)
{
    Scene scene = empty_scene(dt);
    const GearShape first{.teeth = 18, .play = play}, second{.teeth = 27, .play = play};
    const Quaternion turn(
        Eigen::AngleAxisd(std::numbers::pi + std::numbers::pi / second.teeth, Vec3::UnitZ()));
    add(scene, "small", flat_ended(gear(first)), false);
    add(scene, "large",
        placed(flat_ended(gear(second)), turn, {first.pitch_radius() + second.pitch_radius(), 0, 0}), false);
    return scene;
}

}  // namespace enduring::chapter08
