#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace enduring::chapter08 {
namespace {

constexpr double wanted = 1e-3;  // [m]

/// A body that is laid on the ground.
struct Laid {
    int cells = 0;     ///< of a rigid cube, along its edges of 1 m; or
    int elements = 0;  ///< of the soft bunny
    double mass, dt;
};

Scene rigid_cube(const Laid& laid)
{
    Scene scene = chapter07::scene_of({}, laid.dt);
    SurfaceMesh mesh = box(Vec3::Ones(), {laid.cells, laid.cells, laid.cells});
    for (Vec3& x : mesh.vertices)
        x.y() += 0.5;
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1000), laid.mass)));
    return scene;
}

/// The bunny of the bowl, alone on the ground. Its modulus grows with its mass, so that it sags alike.
Scene soft_bunny(const Laid& laid)
{
    const auto placed = [&](double height) {
        const nlohmann::json change{
            {"dt", laid.dt},
            {"/bodies/bunny",
             {{"shape", {{"file", "bunny_" + std::to_string(laid.elements) + ".msh"}}},
              {"mass", laid.mass},
              {"young", 50000 * laid.mass / 30},
              {"position", {0, height, 0}}}}};
        Scene scene = load_scene(scene_file("bunny_at_rest"), change.dump());
        std::erase_if(scene.world.bodies, [](const auto& body) { return body->name() == "bowl"; });
        return scene;
    };
    const Scene high = placed(2);
    double lowest = INFINITY;
    for (const Vec3& x : high.world.bodies[0]->positions_t0())
        lowest = std::min(lowest, x.y());
    return placed(2 - lowest + 1e-6);
}

std::vector<Laid> all_laid(bool quick)
{
    std::vector<Laid> all;
    for (const double dt : {0.002, 0.005, 0.01, 0.02})
        for (const double mass : {1.0, 30.0, 1000.0}) {
            if (quick && (mass == 30 || dt == 0.005 || dt == 0.02))
                continue;
            for (const int cells : {1, 4})
                all.push_back({.cells = cells, .mass = mass, .dt = dt});
            if (quick ? dt == 0.01 && mass == 1 : dt >= 0.01 || mass == 30)
                all.push_back({.elements = 363, .mass = mass, .dt = dt});
        }
    if (!quick)
        for (const int elements : {785, 1452})
            all.push_back({.elements = elements, .mass = 30, .dt = 0.01});
    return all;
}

chapter07::PileOutcome lay(const Laid& laid)
{
    Scene scene = laid.elements > 0 ? soft_bunny(laid) : rigid_cube(laid);
    scene.contact.wanted_depth = wanted;
    return chapter07::watch(scene, 3, chapter08_solver);
}

}  // namespace

/// Asked for a depth of a millimetre: how deep is a body that nothing else loads?
void wanted_depth(const RunOptions& options, Report& report)
{
    const std::vector<Laid> all = all_laid(options.quick);
    GrowingTable table(report, "wanted_depth",
                       {"body", "mass_kg", "dt_s", "deepest_mm", "drift_um_per_s", "unconverged"},
                       all.size());
    Table page(table.columns());
    long too_deep = 0;
    double deepest = 0;
    for (const Laid& laid : all) {
        const chapter07::PileOutcome outcome = lay(laid);
        table.add({laid.elements > 0 ? "bunny, " + std::to_string(laid.elements) + " elements"
                                     : "cube, " + std::to_string(laid.cells) + " cells an edge",
                   laid.mass, laid.dt, outcome.deepest_mm, outcome.drift_um_per_s,
                   outcome.solves.unconverged});
        if (laid.mass == 1 || laid.elements > 0)
            page.add(table.rows().back());
        too_deep += outcome.deepest_mm > 1000 * wanted;
        deepest = std::max(deepest, outcome.deepest_mm);
    }
    report.table("wanted_depth", table);
    report.page_table("wanted_depth", page, 3);
    report.fact("wanted_depth", "runs", static_cast<double>(table.rows().size()));
    report.fact("wanted_depth", "too_deep", static_cast<double>(too_deep));
    report.fact("wanted_depth", "deepest_mm", deepest, 2);
}

}  // namespace enduring::chapter08
