#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/static_body.hpp"

#include <nlohmann/json.hpp>

#include <fstream>

namespace enduring::chapter07 {

Scene ton_on_block(const LoadedBlock& block, double dt)
{
    Scene scene = scene_of(
        {{.mass = 1000, .centre = Vec3(0.03, 1.4 + 2e-4, 0.02), .turn_deg = 10, .size = Vec3::Constant(0.8)}},
        dt);
    DeformableSettings settings;
    settings.material.density = block.mass;  // its volume is 1 m^3
    settings.material.young = block.young;
    settings.material.stiffness_damping = 0.01;
    settings.position = Vec3(0, 0.5 + 1e-4, 0);
    settings.impulse_response = ImpulseResponse::implicit;
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(
        "block", bar(Vec3::Ones(), {block.cells, block.cells, block.cells}), settings));
    return scene;
}

Scene soft_cube_on_triangles(const SoftCube& cube, double mu)
{
    Scene scene = scene_of(std::vector<Box>{}, cube.dt, 10, mu, mu);
    scene.world.planes.clear();
    SurfaceMesh ground = plane_grid(6, 6, {12, 12});
    for (Vec3& x : ground.vertices)
        x += Vec3(0.13, 0, 0.11);  // no vertex upon an edge
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "ground", SurfaceTopology(static_cast<int>(ground.vertices.size()), ground.faces), ground.vertices));
    DeformableSettings settings;
    settings.material.density = cube.mass;  // its volume is 1 m^3
    settings.material.young = cube.young;
    settings.material.poisson = 0.3;
    settings.material.stiffness_damping = soft_damping;
    settings.position = Vec3(0, 0.5 + 1e-4, 0);
    settings.impulse_response = ImpulseResponse::implicit;
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(
        "cube", bar(Vec3::Ones(), {cube.cells, cube.cells, cube.cells}), settings));
    return scene;
}

Scene falling_mat(double width, int cells, const nlohmann::json& change)
{
    using nlohmann::json;
    json mat{{"name", "mat"},
             {"type", "deformable"},
             {"shape", {{"bar", {{"size", {width, 0.04, width}}, {"cells", {cells, 1, cells}}}}}},
             {"basis", "quadratic"},
             {"young", 5e4},
             {"poisson", 0.2}};
    mat.update(change);
    const json scene{{"name", "mat"},
                     {"dt", 0.01},
                     {"duration", 0.3},
                     {"contact", {{"friction", {{"model", "mass_splitting"}, {"mu_s", 0.5}, {"mu_d", 0.5}}}}},
                     {"planes", {{{"name", "ground"}}}},
                     {"bodies", {mat}}};
    return read_scene(scene.dump(), "", "mat.json", {});
}

Scene bunnies_in_bowl(const Bunnies& bunnies, double dt)
{
    using nlohmann::json;
    const std::filesystem::path file = scene_file("bunny_at_rest");
    std::ifstream text(file);
    const json scene = json::parse(text);
    json bunny = scene["bodies"][1];
    bunny["shape"]["file"] = "bunny_" + std::to_string(bunnies.elements) + ".msh";
    bunny["basis"] = bunnies.basis;
    bunny["young"] = bunnies.young;
    json change = {{"dt", dt}, {"contact", {{"stiffness", nullptr}}}};
    change["planes"] = json::array({json{{"name", "ground"}}});
    change["bodies"] = json::array({scene["bodies"][0]});
    for (int i = 0; i < bunnies.count; ++i) {
        bunny["name"] = "bunny " + std::to_string(i + 1);
        bunny["position"] = {0.1 - 0.2 * i, 1.2 + i, 0};
        if (i > 0)
            bunny["look"]["color"] = {0.6, 0.45, 0.1};
        change["bodies"].push_back(bunny);
    }
    return load_scene(file, change.dump());
}

}  // namespace enduring::chapter07
