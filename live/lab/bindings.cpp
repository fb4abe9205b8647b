#include "common/scenes/drawn_body.hpp"
#include "live/laboratory.hpp"

#include <emscripten/bind.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <tuple>

using namespace enduring;
using namespace enduring::laboratory;
using emscripten::val;

namespace {

const std::filesystem::path mesh_folder = "/meshes";
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

val parsed(const nlohmann::json& shown) { return val::global("JSON").call<val>("parse", line_of(shown)); }

/// Numbers of all pairs, one behind the other.
val pairs_of(const Laboratory& lab)
{
    const std::vector<PairNumbers> pairs = lab.pairs();
    std::vector<double> list;
    list.reserve(std::tuple_size_v<PairNumbers> * pairs.size());
    for (const PairNumbers& pair : pairs)
        list.insert(list.end(), pair.begin(), pair.end());
    return array_of("Float64Array", list);
}

val positions_of(const Laboratory& lab)
{
    std::vector<double> list;
    for (const auto& body : lab.scene().world.bodies)
        for (const Vec3& x : drawn_points(*body))
            list.insert(list.end(), x.begin(), x.end());
    return array_of("Float64Array", list);
}

val frame()
{
    val result = val::object();
    result.set("numbers", parsed(shown_numbers(laboratory->numbers())));
    result.set("pairs", pairs_of(*laboratory));
    result.set("joints", array_of("Float64Array", joint_numbers(laboratory->scene().world)));
    result.set("positions", positions_of(*laboratory));
    return result;
}

void add_mesh(const std::string& name, const std::string& text)
{
    std::filesystem::create_directories(mesh_folder);
    std::ofstream(mesh_folder / name, std::ios::binary) << text;
}

val load(const std::string& text, const std::string& file, const std::string& solver)
{
    return caught([&] {
        laboratory = std::make_unique<Laboratory>(text, file, std::vector{mesh_folder}, solver);
        const Scene& scene = laboratory->scene();
        return parsed(shown_scene(scene, scene.world, laboratory->solver().name));
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
