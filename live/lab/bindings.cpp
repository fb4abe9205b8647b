#include "live/laboratory.hpp"

#include <emscripten/bind.h>

#include <filesystem>
#include <fstream>

using namespace enduring;
using namespace enduring::laboratory;
using emscripten::val;

namespace {

const std::filesystem::path mesh_folder = "/meshes";
constexpr std::size_t numbers_a_pair = 24;
std::unique_ptr<Laboratory> laboratory;

/// A copy that JavaScript owns.
template <class Number>
val array_of(const char* type, const std::vector<Number>& numbers)
{
    return val::global(type).new_(emscripten::typed_memory_view(numbers.size(), numbers.data()));
}

/// What `work` gives, or {error} with the message that a terminal would show.
template <class Work>
val caught(const Work& work)
{
    try {
        return work();
    } catch (const std::exception& error) {
        val result = val::object();
        result.set("error", std::string(error.what()));
        return result;
    }
}

void append(std::vector<double>& list, const Vec3& v) { list.insert(list.end(), {v.x(), v.y(), v.z()}); }

val triple(const Vec3& v) { return array_of("Float64Array", std::vector<double>{v.x(), v.y(), v.z()}); }

val body_of(const Scene& scene, const Body& body)
{
    val result = val::object();
    std::vector<int> faces;
    for (const Face& face : body.surface().faces())
        faces.insert(faces.end(), face.begin(), face.end());
    const auto look = scene.looks.find(body.name());
    const BodyLook shown = look == scene.looks.end() ? BodyLook{} : look->second;
    result.set("name", body.name());
    result.set("still", body.is_static());
    result.set("mass", body.mass());
    result.set("faces", array_of("Int32Array", faces));
    result.set("vertices", static_cast<int>(body.positions_t0().size()));
    result.set("colour", triple(shown.color));
    result.set("smooth", shown.smooth);
    return result;
}

val described(const Laboratory& lab)
{
    const Scene& scene = lab.scene();
    val result = val::object(), bodies = val::array(), planes = val::array(), warnings = val::array();
    for (const auto& body : scene.world.bodies)
        bodies.call<void>("push", body_of(scene, *body));
    for (const Plane& plane : scene.world.planes) {
        val shown = val::object();
        shown.set("name", plane.name);
        shown.set("point", triple(plane.point));
        shown.set("normal", triple(plane.normal));
        planes.call<void>("push", shown);
    }
    for (const std::string& warning : scene.warnings)
        warnings.call<void>("push", warning);
    result.set("name", scene.name);
    result.set("description", scene.description);
    result.set("dt", scene.dt);
    result.set("duration", scene.duration);
    result.set("bodies", bodies);
    result.set("planes", planes);
    result.set("warnings", warnings);
    result.set("camera_given", scene.camera_given);
    result.set("eye", triple(scene.camera.eye));
    result.set("target", triple(scene.camera.target));
    result.set("field_of_view", scene.camera.field_of_view_deg);
    result.set("solver", lab.solver().name);
    return result;
}

val numbers_of(const StepNumbers& n)
{
    val result = val::object();
    result.set("time", n.time);
    result.set("step", n.step);
    result.set("kinetic", n.kinetic);
    result.set("gravitational", n.gravitational);
    result.set("elastic", n.elastic);
    result.set("springs", n.springs);
    result.set("depth", n.depth);
    result.set("pairs", n.pairs);
    result.set("rounds", n.rounds);
    result.set("newton_steps", n.newton_steps);
    result.set("thrown_away", static_cast<int>(n.thrown_away));
    result.set("ended_badly", static_cast<int>(n.ended_badly));
    return result;
}

/// Numbers of all pairs, numbers_a_pair each, in the order of live/lab/pairs.js.
val pairs_of(const Laboratory& lab)
{
    std::vector<double> list;
    const std::vector<PairNumbers> pairs = lab.pairs();
    list.reserve(numbers_a_pair * pairs.size());
    for (const PairNumbers& p : pairs) {
        list.insert(list.end(), {static_cast<double>(p.kind), static_cast<double>(p.body_a),
                                 static_cast<double>(p.body_b), static_cast<double>(p.feature_a),
                                 static_cast<double>(p.feature_b)});
        append(list, p.point);
        append(list, p.normal);
        list.push_back(p.depth);
        append(list, p.impulse);
        append(list, p.friction);
        list.insert(list.end(), {p.stiffness, p.rest_offset, p.load, p.slip, p.pushes ? 1.0 : 0.0,
                                 static_cast<double>(p.since)});
    }
    return array_of("Float64Array", list);
}

val positions_of(const Laboratory& lab)
{
    std::vector<double> list;
    for (const auto& body : lab.scene().world.bodies)
        for (const Vec3& x : body->positions_t0())
            append(list, x);
    return array_of("Float64Array", list);
}

val frame()
{
    val result = val::object();
    result.set("numbers", numbers_of(laboratory->numbers()));
    result.set("pairs", pairs_of(*laboratory));
    result.set("positions", positions_of(*laboratory));
    return result;
}

void add_mesh(const std::string& name, const std::string& text)
{
    std::filesystem::create_directories(mesh_folder);
    std::ofstream(mesh_folder / name, std::ios::binary) << text;
}

val load(const std::string& text, const std::string& file, int chapter)
{
    return caught([&] {
        laboratory = std::make_unique<Laboratory>(text, file, std::vector{mesh_folder}, chapter);
        return described(*laboratory);
    });
}

val advance_by(int steps)
{
    return caught([&] {
        for (int i = 0; i < steps; ++i)
            laboratory->step();
        return frame();
    });
}

void hold(int body, int face, double x, double y, double z) { laboratory->hold({body, face, {x, y, z}}); }

}  // namespace

EMSCRIPTEN_BINDINGS(lab)
{
    emscripten::function("add_mesh", &add_mesh);
    emscripten::function("load", &load);
    emscripten::function("frame", &frame);
    emscripten::function("advance", &advance_by);
    emscripten::function("hold", &hold);
}
