#include "common/scenes/body_reader.hpp"

#include "common/geometry/surface_checks.hpp"
#include "common/input/input_error.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/scenes/deformable_reader.hpp"
#include "common/scenes/placement.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

namespace enduring {
namespace {

/// The body's surface in the world; a border is for static bodies only, as all others need an inside.
SurfaceMesh placed_surface(const JsonValue& value, const SceneSurroundings& surroundings, Border border)
{
    SurfaceMesh mesh = read_shape(value.at("shape"), surroundings).surface;
    try {
        check_surface(mesh, "the surface", border);
    } catch (const InputError& error) {
        value.at("shape").pass_on(error);
    }
    mesh.vertices = read_placement(value).place(mesh.vertices);
    return mesh;
}

std::unique_ptr<Body> read_static(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"name", "type", "shape", "position", "rotation", "look"});
    SurfaceMesh mesh = placed_surface(value, surroundings, Border::allowed);
    SurfaceTopology surface(static_cast<int>(mesh.vertices.size()), std::move(mesh.faces));
    return std::make_unique<StaticBody>(value.at("name").text(), std::move(surface),
                                        std::move(mesh.vertices));
}

MassProperties read_mass_properties(const JsonValue& value, const SurfaceMesh& mesh)
{
    const MassProperties of_unit_density = mass_properties(mesh, 1.0);
    return with_mass(of_unit_density, read_mass(value, of_unit_density.mass));
}

std::unique_ptr<Body> read_rigid(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"name", "type", "shape", "density", "mass", "position", "rotation", "velocity",
                        "angular_velocity", "look"});
    const SurfaceMesh mesh = placed_surface(value, surroundings, Border::refused);
    const InitialMotion motion = read_motion(value);
    try {
        const MassProperties properties = read_mass_properties(value, mesh);
        return std::make_unique<RigidBody>(value.at("name").text(), mesh, properties, motion.velocity,
                                           motion.angular_velocity);
    } catch (const InputError& error) {
        value.pass_on(error);
    }
}

}  // namespace

std::unique_ptr<Body> read_body(const JsonValue& value, const SceneSurroundings& surroundings)
{
    switch (value.at("type").choice({"static", "rigid", "deformable"})) {
        case 0: return read_static(value, surroundings);
        case 1: return read_rigid(value, surroundings);
        default: return read_deformable(value, surroundings);
    }
}

}  // namespace enduring
