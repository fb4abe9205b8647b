#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/number_text.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring::chapter06 {
namespace {

/// What happens when the cube rams the block at some speed.
struct Ram {
    double deepest_vertex = 0;  ///< of either body in the other [m]
    /// depth of a vertex-face pair that pushes upwards, which nothing here should do [m]
    double deepest_pair = 0;
    double energy_ratio = 0;  ///< kinetic energy after over before
};

double deepest_in(const Body& of, const Body& in)
{
    double deepest = 0;
    for (const Vec3& x : of.positions_t0())
        deepest = std::max(deepest, motivating::depth_inside(in, x));
    return deepest;
}

Ram ram(const Compared& compared, double speed)
{
    Scene scene = load_scene(scene_file("deep"),
                             R"({"/bodies/cube/velocity": [)" + shortest(speed) + ", 0, 0]}");
    Ram result;
    double before = 0;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        const Body &block = body_named(world, "block"), &cube = body_named(world, "cube");
        const double energy = cube.energy(world.gravity).kinetic;
        before = world.step == 0 ? energy : before;
        result.energy_ratio = energy / before;
        result.deepest_vertex =
            std::max({result.deepest_vertex, deepest_in(block, cube), deepest_in(cube, block)});
        for (const Contact& contact : contacts) {
            const ContactGeometry at = contact_geometry(world, contact, 0);
            if (contact.kind == ContactKind::vertex_face && !contact.impulse.isZero() &&
                std::abs(at.normal.y()) > std::sqrt(0.5))
                result.deepest_pair = std::max(result.deepest_pair, -at.depth);
        }
    });
    run(scene, compared.make(scene.contact), {&watch}, failure_on_purpose());
    return result;
}

}  // namespace

/// Where the categories have nothing to go by: thesis 6.2.2, its figure 6.9.
void deep(const RunOptions& options, Report& report)
{
    artefact("deep", options, report);
    Table table({"speed_m_per_s", "solver", "deepest_vertex_mm", "deepest_upward_pair_mm", "energy_ratio"});
    for (const double speed : {0.5, 1.0, 2.0, 3.0})
        for (const Compared& compared : last_and_this) {
            const Ram result = ram(compared, speed);
            table.add({speed, "chapter " + std::to_string(compared.chapter), 1000 * result.deepest_vertex,
                       1000 * result.deepest_pair, result.energy_ratio});
            if (speed == 3 && compared.chapter == 6) {
                report.fact("deep", "vertex_mm", 1000 * result.deepest_vertex, 2);
                report.fact("deep", "pair_mm", 1000 * result.deepest_pair, 2);
            }
        }
    report.table("deep_speeds", table);
    report.page_table("deep_speeds", table, 3);
}

}  // namespace enduring::chapter06
