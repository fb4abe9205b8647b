#include "common/experiments/own_scene/replay.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/simulation/make_joint.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <fstream>

using namespace enduring;
using nlohmann::json;

namespace {

/// A ball at 3 m/s, and a table that rests.
Scene ball_and_table(const std::filesystem::path& folder)
{
    write_file(folder / "scene.json",
               R"({"name": "ball", "dt": 0.01, "duration": 1, "planes": [{"name": "ground"}], "bodies": [
        {"name": "table", "type": "static", "shape": {"box": {"size": [1, 1, 1]}}},
        {"name": "ball", "type": "rigid", "shape": {"box": {"size": [2, 2, 2]}}, "mass": 5, "position": [0, 4, 0]}]})");
    return load_scene(folder / "scene.json");
}

json written(const Replay& replay, const std::filesystem::path& folder)
{
    replay.write(folder / "replay.json");
    return json::parse(std::ifstream(folder / "replay.json"));
}

/// The floats of a text in base64, letter by letter.
std::vector<float> floats_in(const std::string& text)
{
    const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bits, bytes;
    for (const char letter : text.substr(0, text.find('=')))
        for (int bit = 5; bit >= 0; --bit)
            bits += (letters.find(letter) >> static_cast<unsigned>(bit) & 1U) != 0 ? '1' : '0';
    for (std::size_t at = 0; at + 8 <= bits.size(); at += 8)
        bytes += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
    std::vector<float> numbers(bytes.size() / sizeof(float));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(float));
    return numbers;
}

/// Shows it as many steps, without a solver.
void watch(Replay& replay, World& world, int steps)
{
    for (int i = 0; i < steps; ++i) {
        replay.observe(world, {}, 0.01);
        world.step += 1;
        world.time += 0.01;
    }
}

std::vector<int> steps_in(const json& file)
{
    std::vector<int> steps;
    for (const json& frame : file["frames"])
        steps.push_back(frame["numbers"]["step"].get<int>());
    return steps;
}

}  // namespace

TEST_CASE("replay: a rigid body's frame is its place and its turn, in floats and base64")
{
    const TemporaryFolder folder;
    Scene scene = ball_and_table(folder.path);
    Replay replay(scene, "nobody");
    watch(replay, scene.world, 1);
    const json file = written(replay, folder.path);
    CHECK(file["replay"] == 1);
    CHECK(file["scene"]["solver"] == "nobody");
    CHECK(file["scene"]["bodies"][0]["kind"] == "rests");
    CHECK(file["scene"]["bodies"][1]["kind"] == "rigid");
    CHECK(file["scene"]["bodies"][1]["faces"].size() == std::size_t{3 * 12});
    CHECK(file["scene"]["planes"][0]["name"] == "ground");
    const std::vector<float> motion = floats_in(file["frames"][0]["motion"]), pose{0, 4, 0, 0, 0, 0, 1};
    REQUIRE(motion.size() == 9);  // zeros follow
    for (std::size_t i = 0; i < pose.size(); ++i)
        CHECK(motion[i] == doctest::Approx(pose[i]));
    const std::vector<float> points = floats_in(file["scene"]["bodies"][1]["points"]);
    REQUIRE(points.size() == std::size_t{3 * 8});
    for (const float coordinate : points)  // of the cube itself
        CHECK(std::abs(coordinate) == doctest::Approx(1));
    CHECK(file["frames"][0]["pairs"] == "");
}

TEST_CASE("replay: above its size every other frame goes, and the first and the last stay")
{
    const TemporaryFolder folder;
    Scene scene = ball_and_table(folder.path);
    Replay replay(scene, "nobody", 10 * 40);  // ten frames of 28 bytes, 40 letters
    watch(replay, scene.world, 24);
    CHECK(steps_in(written(replay, folder.path)) == std::vector<int>{0, 4, 8, 12, 16, 20, 23});
}

TEST_CASE(
    "replay: a frame has the points and the axis of each joint that holds, and none of a gear or a broken one")
{
    const TemporaryFolder folder;
    Scene scene = ball_and_table(folder.path);
    World& world = scene.world;
    Replay alone(scene, "nobody");
    watch(alone, world, 1);
    CHECK(!written(alone, folder.path)["frames"][0].contains("joints"));

    world.joints.push_back(
        make_joint(world, "hinge", JointKind::hinge, 1, -1, Vec3(0, 5, 0), axes_about(Vec3(1, 0, 0))));
    world.joints.push_back(make_rod(world, "rod", 1, -1, Vec3(0, 4, 0), Vec3(0, 7, 1)));
    world.joints.push_back(make_joint(world, "broken", JointKind::ball, 1, -1, Vec3(0, 5, 0)));
    world.joints.back().broken = true;
    Replay replay(scene, "nobody");
    watch(replay, world, 1);
    const std::vector<float> found = floats_in(written(replay, folder.path)["frames"][0]["joints"]);
    const std::vector<float> wanted{0, 5, 0, 0, 5, 0, 1, 0, 0, /**/ 0, 4, 0, 0, 7, 1, 0, 0, 0};
    REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i)
        CHECK(found[i] == doctest::Approx(wanted[i]));
}
