#include "chapters/06_redefinition/solver.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/run/run.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>

namespace enduring::chapter08 {
namespace {

constexpr double block_size = 0.4;

/// A block of 20 kg that begins so deep in a floor of 1 m [m], its sole parallel to the floor.
Scene block_in_floor(double depth)
{
    Scene scene;
    scene.dt = 0.01;
    scene.contact.stiffness = 5000;
    const SurfaceMesh floor = box({2, 1, 2}, {7, 3, 7});
    SurfaceMesh block = box(Vec3::Constant(block_size), {2, 2, 2});
    for (Vec3& x : block.vertices)
        x += Vec3(0.013, block_size / 2 - depth, 0.021);
    std::vector<Vec3> lowered = floor.vertices;
    for (Vec3& x : lowered)
        x.y() -= 0.5;
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "floor", SurfaceTopology(static_cast<int>(lowered.size()), floor.faces), lowered));
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>("block", block, with_mass(mass_properties(block, 1000), 20)));
    return scene;
}

/// Vertices of the block that are in the floor, by the winding number.
long inside(const World& world)
{
    const Body& block = *world.bodies[1];
    return std::count_if(block.positions_t0().begin(), block.positions_t0().end(),
                         [&](const Vec3& x) { return motivating::depth_inside(*world.bodies[0], x) > 0; });
}

}  // namespace

/// A block that begins inside a floor: what has no history has no pairs, and nobody to ask.
void born_inside(const RunOptions&, Report& report)
{
    Table table(
        {"depth_mm", "solver", "vertices_inside", "pairs_at_first", "height_after_1_s_m", "fastest_m_per_s"});
    for (const double depth : {0.001, 0.01, 0.05, 0.1, 0.4})
        for (const auto& [name, make] :
             {std::pair("chapter 6", &chapter06_solver), std::pair("chapter 8", &chapter08_solver)}) {
            Scene scene = block_in_floor(depth);
            const long buried = inside(scene.world);
            long pairs = 0;
            double fastest = 0;
            WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
                pairs = world.step == 1 ? static_cast<long>(contacts.size()) : pairs;
                fastest = std::max(fastest, world.bodies[1]->mean_velocity().norm());
            });
            run(scene, make(scene.contact), {&watch}, failure_on_purpose({.steps = 100}));
            table.add({1000 * depth, std::string(name), buried, pairs,
                       scene.world.bodies[1]->centre().y() - block_size / 2, fastest});
        }
    report.table("born_inside", table);
    report.page_table("born_inside", table);
}

}  // namespace enduring::chapter08
