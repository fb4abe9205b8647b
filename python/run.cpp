#include "python/run.hpp"

#include "common/geometry/solid_checks.hpp"
#include "common/geometry/surface_checks.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <cmath>
#include <utility>

namespace enduring::python {

void Run::choose(int chapter)
{
    if (scene.world.step > 0)
        throw InputError("a solver is chosen before the first step: it remembers what it needs");
    Solver solver = solvers::chapter_solver(chapter, scene.contact);
    require_asked(scene, solver);
    solver_ = std::move(solver);
    chapter_ = chapter;
}

void Run::step(int steps)
{
    if (steps < 0)
        throw InputError("steps: expected a whole number from 0, found " + std::to_string(steps));
    if (contacts.use_count() > 1)  // somebody looks at the pairs of this moment
        contacts = std::make_shared<Contacts>(*contacts);
    for (int i = 0; i < steps; ++i)
        advance(scene.world, *contacts, solver_, scene.dt);
}

void Run::require_new(const std::string& name) const
{
    const World& world = scene.world;
    if (world.step > 0)
        throw InputError("'" + name + "' comes too late: bodies and planes are added before the first step");
    if (name.empty())
        throw InputError("name: expected a text that is not empty");
    bool is_taken = false;
    for (const auto& body : world.bodies)
        is_taken |= body->name() == name;
    for (const Plane& plane : world.planes)
        is_taken |= plane.name == name;
    if (is_taken)
        throw InputError("name: another body or plane is already called '" + name + "'");
}

Body& Run::add(std::unique_ptr<Body> body)
{
    require_new(body->name());
    scene.world.bodies.push_back(std::move(body));
    choose(chapter_);
    return *scene.world.bodies.back();
}

namespace {

SurfaceMesh surface_from(const Rows<double>& vertices, const Rows<int>& faces, Border border)
{
    SurfaceMesh mesh{points_of(vertices, "vertices"), rows_of<int, 3>(faces, "faces")};
    check_surface(mesh, "its mesh", border);
    return mesh;
}

}  // namespace

Scene empty_scene(double dt, const Numbers& gravity, double mu_s, double mu_d)
{
    Scene scene;
    scene.name = "scene";
    if (!(dt >= 1e-6 && dt <= 3600))
        throw InputError("dt: expected a number from 1e-06 to 3600 [s]");
    if (!vec3(gravity).allFinite())
        throw InputError("gravity: expected three finite numbers [m/s^2]");
    if (!(mu_d >= 0 && mu_d <= mu_s && mu_s <= 10))
        throw InputError("mu_s, mu_d: expected 0 <= mu_d <= mu_s <= 10");
    scene.dt = dt;
    scene.world.gravity = vec3(gravity);
    if (mu_s > 0)
        scene.contact.friction = MassSplitting{mu_s, mu_d};
    return scene;
}

void add_plane(Run& run, const std::string& name, const Numbers& point, const Numbers& normal)
{
    run.require_new(name);
    const double length = vec3(normal).norm();
    if (!(length > 0 && std::isfinite(length)))
        throw InputError("normal: expected three finite numbers that are not all zero");
    if (!vec3(point).allFinite())
        throw InputError("point: expected three finite numbers [m]");
    run.scene.world.planes.push_back({name, vec3(point), vec3(normal) / length});
}

Body& add_static(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces)
{
    SurfaceMesh mesh = surface_from(vertices, faces, Border::allowed);
    const int count = static_cast<int>(mesh.vertices.size());
    return run.add(std::make_unique<StaticBody>(name, SurfaceTopology(count, std::move(mesh.faces)),
                                                std::move(mesh.vertices)));
}

Body& add_rigid(Run& run, const std::string& name, const Rows<double>& vertices, const Rows<int>& faces,
                double density, const Numbers& velocity, const Numbers& angular_velocity)
{
    const SurfaceMesh mesh = surface_from(vertices, faces, Border::refused);
    return run.add(std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, density), vec3(velocity),
                                               vec3(angular_velocity)));
}

Body& add_deformable(Run& run, const std::string& name, const Rows<double>& nodes,
                     const Rows<int>& tetrahedra, double young, double poisson, double density,
                     const Numbers& velocity)
{
    const TetrahedralMesh mesh{points_of(nodes, "nodes"), rows_of<int, 4>(tetrahedra, "tetrahedra")};
    check_solid(mesh, "the mesh");
    DeformableSettings settings;
    settings.material = {young, poisson, density};
    settings.velocity = vec3(velocity);
    return run.add(std::make_unique<DeformableBody>(name, mesh, settings));
}

}  // namespace enduring::python
