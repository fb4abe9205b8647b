#include "common/scenes/body_reader.hpp"

#include "common/geometry/surface_checks.hpp"
#include "common/input/input_error.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/scenes/deformable_reader.hpp"
#include "common/scenes/frame_reader.hpp"
#include "common/scenes/friction_reader.hpp"
#include "common/scenes/motion_reader.hpp"
#include "common/scenes/placement.hpp"
#include "common/simulation/deforming_body.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>

namespace enduring {
namespace {

bool is_frame(const SurfaceMesh& mesh) { return mesh.faces.empty(); }

/// A shape's surface where the body lies; a border is for static bodies and sheets only, as all others need
/// an inside. Points and edges alone have none, and need none.
SurfaceMesh placed_surface(const JsonValue& shape, const Placement& placement,
                           const SceneSurroundings& surroundings, Border border)
{
    SurfaceMesh mesh = read_shape(shape, surroundings).surface;
    try {
        mesh = mend_if_asked(shape, std::move(mesh), border, surroundings);
        if (!is_frame(mesh))
            check_surface(mesh, "its mesh", border);
    } catch (const InputError& error) {
        shape.pass_on(error);
    }
    mesh.vertices = placement.place(mesh.vertices);
    return mesh;
}

void refuse_sheet_of_frame(const JsonValue& value, const SurfaceMesh& mesh)
{
    if (is_frame(mesh) && value.flag_or("sheet", false))
        value.at("sheet").complain("points and edges alone have no faces; leave the key out");
}

/// A surface pushes out of its front alone. So a sheet that holds on both sides has each face twice, the
/// second time turned over, on vertices of its own: both layers are manifold, and neither knows of the other.
SurfaceMesh on_both_sides(SurfaceMesh mesh)
{
    const std::vector<Vec3> front = mesh.vertices;
    const auto vertices = static_cast<int>(front.size());
    const std::size_t faces = mesh.faces.size();
    mesh.vertices.insert(mesh.vertices.end(), front.begin(), front.end());
    mesh.faces.reserve(2 * faces);
    for (std::size_t face = 0; face < faces; ++face) {
        const auto [a, b, c] = mesh.faces[face];
        mesh.faces.push_back({vertices + a, vertices + c, vertices + b});
    }
    return mesh;
}

constexpr std::size_t max_shapes = 10'000;
constexpr std::size_t max_positions = 50'000'000;  ///< of all shapes together: 1.2 GB

/// Where two shapes over time do not have the same faces, or points and edges.
void require_same_connectivity(const JsonValue& shape, const SurfaceMesh& first, const SurfaceMesh& mesh)
{
    const auto require = [&](std::size_t found, std::size_t wanted, const char* what) {
        if (found != wanted)
            shape.complain("has " + std::to_string(found) + " " + what + ", and the first shape has " +
                           std::to_string(wanted));
    };
    require(mesh.vertices.size(), first.vertices.size(), "vertices");
    require(mesh.faces.size(), first.faces.size(), "faces");
    require(mesh.wires.size(), first.wires.size(), "edges");
    const auto face = std::mismatch(mesh.faces.begin(), mesh.faces.end(), first.faces.begin()).first;
    if (face != mesh.faces.end())
        shape.complain("its face " + std::to_string(face - mesh.faces.begin()) +
                       " has other vertices than in the first shape");
    const auto edge = std::mismatch(mesh.wires.begin(), mesh.wires.end(), first.wires.begin()).first;
    if (edge != mesh.wires.end())
        shape.complain("its edge " + std::to_string(edge - mesh.wires.begin()) +
                       " has other vertices than in the first shape");
}

/// The key "shapes" of a static body: one mesh at several times.
std::unique_ptr<Body> read_deforming(const JsonValue& value, const SceneSurroundings& surroundings)
{
    for (const char* key : {"shape", "motion", "surface_velocity"})
        if (const std::optional<JsonValue> beside = value.find(key))
            beside->complain("stands beside \"shapes\", which tell where the body is at all times");
    const Placement placement = read_placement(value);
    SurfaceMesh first;
    std::vector<DeformingBody::Shape> shapes;
    for (const JsonValue& row : value.at("shapes").items(2, max_shapes)) {
        row.require_keys({"time", "shape"});
        const double time = read_time(row, shapes.empty() ? nullptr : &shapes.back().time);
        SurfaceMesh mesh = placed_surface(row.at("shape"), placement, surroundings, Border::allowed);
        if (shapes.empty())
            first = mesh;
        require_same_connectivity(row.at("shape"), first, mesh);
        if ((shapes.size() + 1) * mesh.vertices.size() > max_positions)
            row.complain("all shapes together have more than 50,000,000 vertices");
        if (value.flag_or("sheet", false))
            mesh = on_both_sides(std::move(mesh));
        shapes.push_back({time, std::move(mesh.vertices)});
    }
    refuse_sheet_of_frame(value, first);
    if (value.flag_or("sheet", false))
        first = on_both_sides(std::move(first));
    return std::make_unique<DeformingBody>(value.at("name").text(), topology_of(first), std::move(shapes));
}

std::unique_ptr<Body> read_static(const JsonValue& value, const SceneSurroundings& surroundings)
{
    value.require_keys({"name", "type", "shape", "shapes", "position", "rotation", "look", "material",
                        "motion", "surface_velocity", "sheet", "grain"});
    if (value.find("shapes"))
        return read_deforming(value, surroundings);
    SurfaceMesh mesh = placed_surface(value.at("shape"), read_placement(value), surroundings,
                                      Border::allowed);
    refuse_sheet_of_frame(value, mesh);
    if (value.flag_or("sheet", false))
        mesh = on_both_sides(std::move(mesh));
    const Vec3 running = value.vector_or("surface_velocity", {-1e4, 1e4, true, true, "m/s"}, Vec3::Zero());
    if (const std::optional<JsonValue> motion = value.find("motion")) {
        if (const std::optional<JsonValue> beside = value.find("surface_velocity"))
            beside->complain("stands beside \"motion\"; a body has one of the two");
        const ReadMotion given = read_given_motion(*motion, read_placement(value));
        return std::make_unique<DrivenBody>(value.at("name").text(), mesh, given.centre, given.motion);
    }
    auto body = std::make_unique<StaticBody>(value.at("name").text(), topology_of(mesh),
                                             std::move(mesh.vertices));
    body->set_surface_velocity(running);
    return body;
}

/// Of a sheet, and of points and edges, only the mass can be said: without a thickness a density gives none.
MassProperties read_mass_properties(const JsonValue& value, const SurfaceMesh& mesh,
                                    const SceneMaterials& materials, bool is_sheet)
{
    if (is_frame(mesh)) {
        if (const std::optional<JsonValue> density = value.find("density"))
            density->complain("points and edges have no volume; give their \"mass\"");
        return frame_properties(mesh, value.at("mass").number(mass_range));
    }
    if (is_sheet) {
        if (const std::optional<JsonValue> density = value.find("density"))
            density->complain("a sheet has no volume; give its \"mass\"");
        return with_mass(sheet_properties(mesh, 1.0), value.at("mass").number(mass_range));
    }
    const MassProperties of_unit_density = mass_properties(mesh, 1.0);
    return with_mass(of_unit_density, read_mass(value, of_unit_density.mass, materials));
}

std::unique_ptr<Body> read_rigid(const JsonValue& value, const SceneSurroundings& surroundings,
                                 const SceneMaterials& materials)
{
    value.require_keys({"name", "type", "shape", "density", "mass", "position", "rotation", "velocity",
                        "angular_velocity", "look", "material", "gravity", "forces", "locked", "sheet",
                        "grain"});
    const bool is_sheet = value.flag_or("sheet", false);
    const SurfaceMesh mesh = placed_surface(value.at("shape"), read_placement(value), surroundings,
                                            is_sheet ? Border::allowed : Border::refused);
    refuse_sheet_of_frame(value, mesh);
    if (is_frame(mesh))
        refuse_turns_about_own_line(value, mesh.vertices);
    const InitialMotion motion = read_motion(value);
    const std::vector<OutsideLoad> loads = read_loads(value, read_placement(value));
    const ReadLocks locks = read_locks(value, read_placement(value));
    try {
        const MassProperties properties = read_mass_properties(value, mesh, materials, is_sheet);
        auto body = std::make_unique<RigidBody>(value.at("name").text(),
                                                is_sheet ? on_both_sides(mesh) : mesh, properties,
                                                motion.velocity, motion.angular_velocity);
        if (locks.pin)
            body->pin(*locks.pin, locks.free.rotation, locks.free.axes);
        else if (!locks.free.hold_none())
            body->hold(locks.free);
        for (const OutsideLoad& load : loads)
            body->add_load(load);
        return body;
    } catch (const InputError& error) {
        value.pass_on(error);
    }
}

/// The grain's direction is that of the shape before it is placed. A body that moves as given has the axes of
/// its place.
void give_grain(const JsonValue& value, const JsonValue& grain, Body& body)
{
    const Grain read = read_grain(grain);
    const Vec3 placed = read_placement(value).rotation * read.direction;
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    body.set_grain(
        {rigid ? Vec3(rigid->motion().pose().orientation.conjugate() * placed) : placed, read.across});
}

}  // namespace

std::unique_ptr<Body> read_body(const JsonValue& value, const SceneSurroundings& surroundings,
                                const SceneMaterials& materials)
{
    const std::size_t type = value.at("type").choice({"static", "rigid", "deformable"});
    const std::optional<JsonValue> grain = value.find("grain");
    if (grain && type == 2)
        grain->complain("a soft body's parts turn against each other, so it has no direction of a grain");
    std::unique_ptr<Body> body = type == 0   ? read_static(value, surroundings)
                                 : type == 1 ? read_rigid(value, surroundings, materials)
                                             : read_deformable(value, surroundings, materials);
    body->set_material(material_of(value, materials));
    if (grain)
        give_grain(value, *grain, *body);
    if (!value.flag_or("gravity", true))
        body->switch_gravity_off();
    return body;
}

}  // namespace enduring
