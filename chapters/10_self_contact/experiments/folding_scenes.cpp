#include "chapters/10_self_contact/experiments/folding_scenes.hpp"

#include "chapters/10_self_contact/experiments/bent_bars.hpp"
#include "chapters/10_self_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/input/source_directory.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>

namespace enduring::chapter10 {

SoftRun falling_strip(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.planes.push_back({"ground"});
    add_soft(run.scene, "strip", upright_strip(0.4, 0.02, 0.03, {8 * variant.cells, 1, 1}, 0.02), variant,
             {0, 0.05, 0});
    return run;
}

SoftRun spirals(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    const TetrahedralMesh mesh = spiral(0.03, 0.06, 0.5, 0.015, 0.03, {10 * variant.cells, 1, 1});
    add_soft(run.scene, "left", mesh, variant, {-0.14, 0, 0}, {2, 0, 0});
    add_soft(run.scene, "right", mesh, variant, {0.14, 0.02, 0}, {-2, 0, 0});
    return run;
}

SoftRun squashed_ring(const SoftVariant& variant)
{
    SoftRun run = soft_run(variant);
    run.scene.world.planes.push_back({"ground"});
    add_soft(run.scene, "ring", ring(0.06, 0.012, 0.03, {8 * variant.cells, 1, 1}), variant, {0, 0.067, 0});
    SurfaceMesh board = box({0.3, 0.02, 0.1}, {6, 1, 2});
    for (Vec3& x : board.vertices)
        x.y() += 0.15;
    run.scene.world.bodies.push_back(std::make_unique<RigidBody>(
        "board", board, with_mass(mass_properties(board, 1000), 0.5), Vec3(0, -1, 0)));
    return run;
}

SoftRun pressed_ears(const SoftVariant& variant)
{
    constexpr double scale = 0.02;  // of the scan, in which it is 9 m high
    SoftRun run = soft_run(variant);
    run.scene.world.gravity.setZero();
    TetrahedralMesh mesh = read_gmsh(source_directory() / "common/meshes" /
                                     (variant.cells > 2 ? "bunny_785.msh" : "bunny_363.msh"));
    std::vector<int> feet;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node) {
        mesh.nodes[node] *= scale;
        if (mesh.nodes[node].y() < scale)
            feet.push_back(static_cast<int>(node));
    }
    add_soft(run.scene, "bunny", mesh, variant, Vec3::Zero(), Vec3::Zero(), feet);
    const Body& bunny = *run.scene.world.bodies.back();
    Pull ears{.force = {1, -2, 0.2}, .until = 1};
    for (int vertex = 0; vertex < bunny.surface().vertex_count(); ++vertex)
        if (bunny.positions_t0()[vertex].y() > 7.6 * scale)
            ears.vertices.push_back(vertex);
    run.pulls = {ears};
    return run;
}

SoftRun falling_hairpin(double gap, double dt)
{
    const SoftVariant variant{3e4, 2, dt, 0.3};
    SoftRun run = soft_run(variant);
    add_soft(run.scene, "hairpin", hairpin(gap, {20 * variant.cells, 1, 1}), variant);
    return run;
}

HairpinFall run_hairpin(double gap, double dt, int steps)
{
    SoftRun run = falling_hairpin(gap, dt);
    World& world = run.scene.world;
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    const Solver solver = chapter10_solver(run.scene.contact, quiet);
    const Body& body = *world.bodies[0];
    const std::vector<Vec3> start(body.positions_t0().begin(), body.positions_t0().end());
    HairpinFall fall;
    Contacts contacts;
    for (int step = 0; step < steps; ++step) {
        advance(world, contacts, solver, dt);
        for (const Contact& contact : contacts)
            fall.pushed += contact.impulse.norm() + contact.friction.norm();
    }
    const double time = steps * dt;
    fall.pushed /= body.mass() * world.gravity.norm() * time;
    const Vec3 fallen = 0.5 * time * (time + dt) * world.gravity;
    for (std::size_t v = 0; v < start.size(); ++v)
        fall.off_fall = std::max(fall.off_fall,
                                 (body.positions_t0()[v] - start[v] - fallen).norm() / body.size());
    return fall;
}

}  // namespace enduring::chapter10
