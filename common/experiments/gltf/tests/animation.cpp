#include "common/experiments/gltf/animation.hpp"

#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

#include <tiny_gltf.h>

#include <cstdlib>
#include <cstring>

using namespace enduring;

namespace {

/// A rigid box that turns, a soft one that is thrown, a turntable that turns more than once, a floor, and a
/// plane.
const char* const thrown = R"({"name": "thrown", "dt": 0.01, "duration": 1, "gravity": [0, 0, 0],
  "planes": [{"name": "ground", "point": [0, -3, 0]}],
  "bodies": [
    {"name": "box", "type": "rigid", "shape": {"box": {"size": [1, 0.5, 0.25]}}, "density": 100, "position": [2, 0, 0], "velocity": [1, 2, 0],
     "angular_velocity": [3, 4, 5], "look": {"color": [0.1, 0.2, 0.3]}},
    {"name": "soft", "type": "deformable", "shape": {"bar": {"size": [1, 0.5, 0.5]}}, "density": 100, "young": 1e3, "poisson": 0.3,
     "angular_velocity": [0, 0, 3]},
    {"name": "table", "type": "static", "shape": {"box": {"size": [1, 0.1, 1]}}, "position": [-3, 0, 0], "motion": {"angular_velocity": [0, 9, 0]}},
    {"name": "floor", "type": "static", "shape": {"plane_grid": {"size": [4, 4]}}, "position": [0, -2, 0]}]})";

struct Run {
    TemporaryFolder folder;
    std::filesystem::path file = folder.path / "films" / "thrown.glb";
    /// all surfaces at each frame's time
    std::vector<std::pair<double, std::vector<std::vector<Vec3>>>> seen;
    tinygltf::Model model;

    explicit Run(const AnimationLimits& limits = {})
    {
        Scene scene = read_scene(thrown, "", "thrown", {});
        GltfAnimation animation(scene, file, limits);
        WatchProbe watch([this](const World& world, const Contacts&, double) {
            seen.emplace_back(world.time, std::vector<std::vector<Vec3>>());
            for (const auto& body : world.bodies)
                seen.back().second.emplace_back(body->positions_t0().begin(), body->positions_t0().end());
        });
        run(scene, Solver("nobody", {}, {}, {}), {&animation, &watch});
        animation.finish();
        std::string error, warning;
        REQUIRE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, file.string()));
        CHECK(error + warning == "");
    }

    std::vector<float> numbers(int accessor) const
    {
        const tinygltf::Accessor& of = model.accessors.at(static_cast<std::size_t>(accessor));
        const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(of.bufferView));
        std::vector<float> values(view.byteLength / sizeof(float));
        std::memcpy(values.data(), model.buffers.at(0).data.data() + view.byteOffset, view.byteLength);
        return values;
    }
    /// What drives a path of a node: times, and values.
    std::pair<std::vector<float>, std::vector<float>> samples(int node, const std::string& path) const
    {
        for (const auto& channel : model.animations.at(0).channels)
            if (channel.target_node == node && channel.target_path == path) {
                const auto& sampler =
                    model.animations[0].samplers.at(static_cast<std::size_t>(channel.sampler));
                return {numbers(sampler.input), numbers(sampler.output)};
            }
        return {};
    }
    const std::vector<std::vector<Vec3>>& surfaces_at(float time) const
    {
        const auto near = [&](const auto& one, const auto& other) {
            return std::abs(one.first - static_cast<double>(time)) <
                   std::abs(other.first - static_cast<double>(time));
        };
        return std::min_element(seen.begin(), seen.end(), near)->second;
    }
    std::vector<float> mesh_points(int node) const
    {
        return numbers(
            model.meshes.at(static_cast<std::size_t>(node)).primitives.at(0).attributes.at("POSITION"));
    }
};

Vec3 row(const std::vector<float>& numbers, std::size_t i)
{
    return Eigen::Vector3f(numbers.at(3 * i), numbers.at(3 * i + 1), numbers.at(3 * i + 2)).cast<double>();
}

}  // namespace

TEST_CASE("gltf: what moves as a whole is where the run had it, at every frame, and turns without a jump")
{
    const Run run;
    for (const int node : {0, 2}) {
        CAPTURE(node);
        const auto [times, places] = run.samples(node, "translation");
        const auto [same_times, turns] = run.samples(node, "rotation");
        const std::vector<float> points = run.mesh_points(node);
        REQUIRE(times.size() == 31);
        const std::vector<double>& begin = run.model.nodes.at(static_cast<std::size_t>(node)).translation;
        REQUIRE(begin.size() == 3);  // for who plays no animation
        CHECK((Vec3(begin[0], begin[1], begin[2]) - row(places, 0)).norm() < 1e-6);
        CHECK(times == same_times);
        for (std::size_t frame = 0; frame < times.size(); ++frame) {
            const Eigen::Map<const Eigen::Quaternionf> turn(turns.data() + 4 * frame);
            const std::vector<Vec3>& is = run.surfaces_at(times[frame])[static_cast<std::size_t>(node)];
            for (std::size_t v = 0; v < is.size(); ++v)
                CHECK((turn.cast<double>() * row(points, v) + row(places, frame) - is[v]).norm() < 1e-5);
            if (frame > 0)
                CHECK(turn.dot(Eigen::Map<const Eigen::Quaternionf>(turns.data() + 4 * frame - 4)) > 0.9F);
        }
    }
}

TEST_CASE(
    "gltf: a soft body is its first surface and one way from there at a time, in a bounded number of frames")
{
    for (const std::size_t most : {64, 10}) {
        const Run run({.soft_frames = most});
        const auto [times, weights] = run.samples(1, "weights");
        const auto& primitive = run.model.meshes.at(1).primitives.at(0);
        REQUIRE(times.size() == (most == 64 ? 31 : 9));
        CHECK(times.back() == doctest::Approx(1));
        for (std::size_t frame = 1; frame < 8; ++frame)
            CHECK(times[frame] - times[frame - 1] ==
                  doctest::Approx(most == 64 ? 1.0 / 30 : 4.0 / 30).epsilon(0.4));
        REQUIRE(primitive.targets.size() == times.size() - 1);
        REQUIRE(weights.size() == times.size() * (times.size() - 1));
        for (std::size_t frame = 0; frame < times.size(); ++frame) {
            std::vector<float> points = run.mesh_points(1);
            for (std::size_t target = 0; target + 1 < times.size(); ++target) {
                const std::vector<float> way = run.numbers(primitive.targets[target].at("POSITION"));
                for (std::size_t i = 0; i < way.size(); ++i)
                    points[i] += weights[frame * (times.size() - 1) + target] * way[i];
            }
            const std::vector<Vec3>& is = run.surfaces_at(times[frame]).at(1);
            for (std::size_t v = 0; v < is.size(); ++v)
                CHECK((row(points, v) - is[v]).norm() < 1e-5);
        }
    }
}

TEST_CASE(
    "gltf: names and colours are the scene's, what stands has no animation, and a plane is a square on it")
{
    const Run run;
    REQUIRE(run.model.nodes.size() == 5);
    CHECK(run.model.nodes[0].name == "box");
    const std::vector<double>& color = run.model.materials.at(0).pbrMetallicRoughness.baseColorFactor;
    CHECK(color.at(0) == doctest::Approx(0.1));
    CHECK(color.at(2) == doctest::Approx(0.3));
    CHECK_FALSE(run.model.materials.at(0).doubleSided);
    CHECK(run.model.materials.at(3).doubleSided);
    for (const auto& channel : run.model.animations.at(0).channels)
        CHECK(channel.target_node < 3);
    const std::vector<float> square = run.mesh_points(4);
    REQUIRE(square.size() == 12);
    for (std::size_t corner = 0; corner < 4; ++corner)
        CHECK(row(square, corner).y() == doctest::Approx(-3));
    CHECK((row(square, 1) - row(square, 0)).cross(row(square, 3) - row(square, 0)).y() > 0);
}

TEST_CASE("gltf: a file of another ending is refused")
{
    const Scene scene = read_scene(thrown, "", "thrown", {});
    CHECK_THROWS_WITH_AS(GltfAnimation(scene, "thrown.gltf"), "--gltf: 'thrown.gltf' should end with .glb",
                         InputError);
}

TEST_CASE("gltf: Khronos' validator finds no error, where node has it")
{
    const char* const check =
        "require('gltf-validator').validateBytes(new Uint8Array(require('fs').readFileSync(process.argv[1])))"
        ".then(r => { const n = r.issues; console.log(JSON.stringify(n.messages));"
        " process.exit(n.numErrors + n.numWarnings ? 1 : 0) })";
    if (!is_installed("node") || std::system("node -e \"require('gltf-validator')\" 2>/dev/null") != 0) {
        MESSAGE("no gltf-validator: npm install gltf-validator, and NODE_PATH");
        return;
    }
    const Run run;
    Subprocess node({"node", "-e", check, run.file.string()}, "nodejs");
    CHECK_NOTHROW(node.finish());
}
