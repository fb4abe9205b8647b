#include "common/scenes/scene_reader.hpp"

#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"
#include "common/input/json_value.hpp"
#include "common/input/mistakes.hpp"
#include "common/input/source_directory.hpp"
#include "common/scenes/body_reader.hpp"
#include "common/scenes/friction_reader.hpp"
#include "common/scenes/joint_reader.hpp"
#include "common/scenes/material_reader.hpp"
#include "common/scenes/motion_reader.hpp"
#include "common/scenes/scene_warnings.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace enduring {
namespace {

constexpr std::size_t max_planes = 100;
const NumberRange stiffness_range{0, 1e12, false, true, "N/m"};

/// @param restitution  is set to that of all bodies without a material, if it is given
/// @param asks_exact   is set to the place where exact contact is asked for, if it is
ContactParameters read_contact(const JsonValue& value, double& restitution, std::string& asks_exact)
{
    value.require_keys({"method", "stiffness", "friction", "max_depenetration_velocity", "wanted_depth",
                        "restitution", "exact"});
    ContactParameters contact;
    Mistakes mistakes;
    mistakes.gather([&] {
        if (const std::optional<JsonValue> method = value.find("method"))
            contact.method = static_cast<PenaltyMethod>(method->choice(penalty_words));
    });
    mistakes.gather(
        [&] { contact.stiffness = value.number_or("stiffness", stiffness_range, contact.stiffness); });
    const auto read_if_given = [&](const char* key, const NumberRange& range, std::optional<double>& number) {
        mistakes.gather([&] {
            if (const std::optional<JsonValue> given = value.find(key))
                number = given->number(range);
        });
    };
    read_if_given("max_depenetration_velocity", {0, 10, false, true, "m/s"},
                  contact.max_depenetration_velocity);
    read_if_given("wanted_depth", {0, 1, false, true, "m"}, contact.wanted_depth);
    mistakes.gather([&] { restitution = value.number_or("restitution", {0, 1}, restitution); });
    mistakes.gather([&] {
        if (value.flag_or("exact", false))
            asks_exact = value.file() + ": " + value.path() + "/exact";
    });
    mistakes.gather([&] {
        if (const std::optional<JsonValue> friction = value.find("friction"))
            contact.friction = read_friction(*friction, contact.stiffness);
    });
    mistakes.gather([&] {
        if (const std::optional<JsonValue> friction = value.find("friction"))
            contact.surface_laws = read_surface_laws(*friction, {});
    });
    mistakes.complain();
    return contact;
}

SceneCamera read_camera(const JsonValue& value)
{
    value.require_keys({"eye", "target", "field_of_view_deg"});
    const NumberRange place{-1e5, 1e5, true, true, "m"};
    SceneCamera camera;
    camera.eye = value.vector_or("eye", place, camera.eye);
    camera.target = value.vector_or("target", place, camera.target);
    camera.field_of_view_deg = value.number_or("field_of_view_deg", {1, 120, true, true, "degrees"},
                                               camera.field_of_view_deg);
    if ((camera.eye - camera.target).norm() < 1e-9)
        value.complain("\"eye\" and \"target\" are the same point");
    return camera;
}

BodyLook read_look(const JsonValue& value)
{
    value.require_keys({"color", "smooth"});
    BodyLook look;
    look.color = value.vector_or("color", {0, 1}, look.color);
    look.smooth = value.flag_or("smooth", look.smooth);
    return look;
}

Plane read_plane(const JsonValue& value, const SceneMaterials& materials)
{
    value.require_keys({"name", "point", "normal", "stiffness", "material", "grain"});
    Plane plane;
    plane.name = value.at("name").text();
    plane.point = value.vector_or("point", {-1e4, 1e4, true, true, "m"}, plane.point);
    if (const std::optional<JsonValue> normal = value.find("normal"))
        plane.normal = normal->direction();
    if (const std::optional<JsonValue> stiffness = value.find("stiffness"))
        plane.stiffness = stiffness->number(stiffness_range);
    plane.material = material_of(value, materials);
    if (const std::optional<JsonValue> grain = value.find("grain"))
        plane.grain = read_grain(*grain);
    return plane;
}

/// Probes and pictures find bodies and planes by name, so no two may share one.
void require_new_name(const JsonValue& entry, std::set<std::string>& names)
{
    if (!names.insert(entry.at("name").text()).second)
        entry.at("name").complain("another body or plane is already called \"" + entry.at("name").text() +
                                  "\"");
}

void read_planes(const JsonValue& root, const SceneMaterials& materials, std::set<std::string>& names,
                 Scene& scene, Mistakes& mistakes)
{
    const std::optional<JsonValue> planes = root.find("planes");
    if (!planes)
        return;
    for (const JsonValue& entry : planes->items(0, max_planes))
        mistakes.gather([&] {
            require_new_name(entry, names);
            scene.world.planes.push_back(read_plane(entry, materials));
        });
}

void read_bodies(const JsonValue& root, const SceneSurroundings& surroundings,
                 const SceneMaterials& materials, std::set<std::string>& names, Scene& scene,
                 Mistakes& mistakes)
{
    for (const JsonValue& entry : root.at("bodies").items(1, surroundings.limits.bodies)) {
        mistakes.gather([&] {
            require_new_name(entry, names);
            scene.world.bodies.push_back(read_body(entry, surroundings, materials));
            if (scene.asks_frames.empty() && scene.world.bodies.back()->surface().faces().empty())
                scene.asks_frames = entry.file() + ": " + entry.path() + "/shape";
            if (const auto* rigid = dynamic_cast<const RigidBody*>(scene.world.bodies.back().get()))
                require_slow_springs(entry, *rigid, scene.dt);
        });
        mistakes.gather([&] {
            const std::optional<JsonValue> look = entry.find("look");
            const BodyLook read = look ? read_look(*look) : BodyLook{};
            if (const std::optional<JsonValue> name = entry.find("name"))
                scene.looks[name->text()] = read;
        });
    }
}

void read_joints(const JsonValue& root, Scene& scene, Mistakes& mistakes)
{
    const std::optional<JsonValue> joints = root.find("joints");
    if (!joints)
        return;
    std::set<std::string> names;
    for (const JsonValue& entry : joints->items(0, max_joints))
        mistakes.gather([&] {
            const Joint& joint = scene.world.joints.emplace_back(read_joint(entry, scene.world));
            if (!names.insert(joint.name).second)
                entry.at("name").complain("another joint is already called \"" + joint.name + "\"");
        });
    if (!scene.world.joints.empty())
        scene.asks_joints = joints->file() + ": " + joints->path();
}

/// The first place with a law of surfaces or a grain; empty where there is none.
std::string place_of_surface_laws(const JsonValue& root, const Scene& scene)
{
    const auto place = [&](const char* path) { return root.file() + ": " + path; };
    if (scene.contact.surface_laws.any())
        return place("/contact/friction");
    const std::vector<FrictionCoefficients>& between = scene.world.friction.between;
    if (std::any_of(between.begin(), between.end(), [](const auto& one) { return one.laws.any(); }))
        return place("/materials");
    const std::vector<Plane>& planes = scene.world.planes;
    if (std::any_of(planes.begin(), planes.end(), [](const Plane& plane) { return plane.grain.any(); }))
        return place("/planes");
    const auto& bodies = scene.world.bodies;
    return std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body->grain().any(); })
               ? place("/bodies")
               : "";
}

Scene read_root(const JsonValue& root, const SceneSurroundings& surroundings)
{
    Scene scene;
    std::set<std::string> names;
    Mistakes mistakes;
    mistakes.gather([&] {
        root.require_keys({"name", "description", "gravity", "dt", "duration", "contact", "materials",
                           "material_pairs", "planes", "bodies", "joints", "camera"});
    });
    mistakes.gather([&] { scene.name = root.at("name").text(); });
    mistakes.gather([&] { scene.description = root.text_or("description", ""); });
    mistakes.gather([&] { scene.dt = root.at("dt").number({1e-6, 3600, true, true, "s"}); });
    mistakes.gather([&] { scene.duration = root.at("duration").number({0, 3600, false, true, "s"}); });
    mistakes.gather([&] {
        scene.world.gravity = root.vector_or("gravity", {-1e3, 1e3, true, true, "m/s^2"},
                                             scene.world.gravity);
    });
    double restitution = 0;
    mistakes.gather([&] {
        if (const std::optional<JsonValue> contact = root.find("contact")) {
            scene.contact = read_contact(*contact, restitution, scene.asks_exact);
            scene.gives_stiffness = contact->find("stiffness").has_value();
        }
    });
    mistakes.gather([&] {
        scene.camera_given = root.find("camera").has_value();
        scene.camera = scene.camera_given ? read_camera(root.at("camera")) : scene.camera;
    });
    const ContactOfAll of_scene{coefficients_of(scene.contact), restitution};
    SceneMaterials materials;
    mistakes.gather([&] { materials = read_materials(root, of_scene, mistakes); });
    mistakes.gather([&] {
        MaterialTables tables = read_material_tables(root, materials, of_scene, mistakes);
        scene.world.friction = std::move(tables.friction);
        scene.world.restitution = std::move(tables.restitution);
    });
    mistakes.gather([&] { read_planes(root, materials, names, scene, mistakes); });
    mistakes.gather([&] { read_bodies(root, surroundings, materials, names, scene, mistakes); });
    scene.asks_surface_laws = place_of_surface_laws(root, scene);
    mistakes.complain();  // a joint of a body that is not there is no mistake of its own
    mistakes.gather([&] { read_joints(root, scene, mistakes); });
    mistakes.complain();
    return scene;
}

}  // namespace

Scene read_scene(const std::string& text, const std::string& patch, const std::string& file,
                 const SceneSurroundings& surroundings)
{
    nlohmann::json document = parse_json(text, file);
    if (!patch.empty())
        apply_patch(document, parse_json(patch, file + " (change)"), file);
    std::vector<std::string> told;
    SceneSurroundings telling = surroundings;
    telling.told = &told;
    Scene scene = read_root(JsonValue(document, file), telling);
    scene.warnings = scene_warnings(scene, file);
    scene.warnings.insert(scene.warnings.begin(), told.begin(), told.end());
    scene.stiffness_warning = stiffness_warning(scene, file);
    return scene;
}

Scene load_scene(const std::filesystem::path& path, const std::string& patch)
{
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path()
                                                                : std::filesystem::path(".");
    const std::filesystem::path course_meshes = source_directory() / "common" / "meshes";
    Scene scene = read_scene(read_text_file(path), patch, path.string(), {{folder, course_meshes}});
    if (const std::string stem = path.stem().string(); scene.name != stem)
        scene.warnings.push_back(path.string() + ": /name: is \"" + scene.name +
                                 "\", and the file is called \"" + stem +
                                 "\"; results and pictures go by the file");
    return scene;
}

void require_asked(const Scene& scene, const Solver& solver)
{
    if (!scene.asks_exact.empty() && !solver.exact)
        throw InputError(scene.asks_exact + ": the springs of " + solver.name +
                         " give under a load; choose a solver of exact contact, or leave the key out");
    if (!scene.asks_frames.empty() && !solver.has_frames)
        throw InputError(
            scene.asks_frames + ": " + solver.name +
            " asks on which side of a face a body is, and points and edges have no inside; choose the solver of chapter 8 or a later one");
    if (!scene.asks_joints.empty() && !solver.has_joints)
        throw InputError(scene.asks_joints + ": " + solver.name +
                         " has no joints; choose the solver of chapter 12, or leave the key out");
    if (!scene.asks_surface_laws.empty() && !solver.has_surface_laws)
        throw InputError(
            scene.asks_surface_laws + ": " + solver.name +
            " knows no \"viscous\", \"rolling\", \"patch\" and \"grain\"; choose the solver of one of the "
            "chapters 7 to 10 or 12, or leave the keys out");
}

std::filesystem::path scene_file(const std::string& name)
{
    return source_directory() / "common" / "scenes" / (name + ".json");
}

}  // namespace enduring
