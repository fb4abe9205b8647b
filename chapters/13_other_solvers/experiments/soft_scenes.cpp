#include "chapters/13_other_solvers/experiments/soft_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"

namespace enduring::chapter13 {
void append_soft_cube(Scene& scene, const SoftCube& cube, const std::string& name)
{
    DeformableSettings settings;
    settings.material = {
        .young = soft_young, .poisson = cube.poisson, .density = soft_density, .law = cube.law};
    settings.position = cube.centre;
    settings.velocity = cube.velocity;
    scene.world.bodies.push_back(std::make_unique<DeformableBody>(
        name, bar(Vec3::Ones(), {cube.cells, cube.cells, cube.cells}), settings));
}

Scene soft_cube_scene(const SoftCube& cube, double slope_deg, double mu, double dt)
{
    Scene scene = chapter07::scene_of({}, dt, slope_deg, mu, mu);
    append_soft_cube(scene, cube);
    return scene;
}

Scene clamped_bar(double dt, double mass_damping)
{
    Scene scene = chapter07::scene_of({}, dt);
    const TetrahedralMesh mesh = bar(Vec3(1, 0.25, 0.25), {4, 1, 1});
    DeformableSettings settings;
    settings.material = {.young = 4e4, .poisson = 0.3, .density = 100, .mass_damping = mass_damping};
    settings.position = Vec3(0, 2, 0);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        if (mesh.nodes[static_cast<std::size_t>(n)].x() < -0.5 + 1e-9)
            settings.fixed_nodes.push_back(n);
    scene.world.bodies.push_back(std::make_unique<DeformableBody>("bar", mesh, settings));
    return scene;
}

const DeformableBody& soft_body(const Scene& scene, std::size_t index)
{
    return dynamic_cast<const DeformableBody&>(*scene.world.bodies[index]);
}

Vec3 mean_of_side(const DeformableBody& body, int axis, double direction)
{
    const auto along = direction * body.elastic().mesh().rest().row(axis);
    const double most = along.maxCoeff();
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (int n = 0; n < along.cols(); ++n)
        if (along[n] > most - 1e-9) {
            sum += body.elastic().positions().col(n);
            ++count;
        }
    return sum / count;
}

double column_sinks() { return soft_density * 9.81 / (2 * soft_young); }

double mean_over(Scene& scene, Contacts& contacts, const Solver& solver, int steps,
                 const std::function<double()>& value)
{
    double sum = 0;
    for (int step = 0; step < steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        sum += value() / steps;
    }
    return sum;
}

}  // namespace enduring::chapter13
