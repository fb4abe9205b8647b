#include "chapters/engines/mjcf.hpp"
#include "common/input/pending_file.hpp"
#include "common/input/source_directory.hpp"

#include <nlohmann/json.hpp>

#include <unistd.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace enduring::engines {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Where npm has put the engines (`./course run engines` does).
fs::path npm_folder()
{
    const char* const given = std::getenv("ENDURING_NPM");
    return given ? fs::path(given) : source_directory() / "build/engines";
}

/// A file that goes when its scene has run.
class SceneFile {
public:
    explicit SceneFile(const json& scene)
    {
        static int count = 0;
        path_ = fs::temp_directory_path() /
                ("enduring_scene_" + std::to_string(getpid()) + "_" + std::to_string(++count) + ".json");
        write_file(path_, scene.dump());
    }
    ~SceneFile()
    {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    SceneFile(const SceneFile&) = delete;
    SceneFile& operator=(const SceneFile&) = delete;
    const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// What a command prints, line by line.
/// @throws std::runtime_error  it failed
void read_lines(const std::string& command, const std::function<void(const std::string&)>& take)
{
    FILE* const pipe = popen(command.c_str(), "r");
    if (!pipe)
        throw std::runtime_error("it does not start: " + command);
    std::string line;
    std::array<char, 1 << 16> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe)) {
        line += part.data();
        if (line.back() == '\n') {
            take(line);
            line.clear();
        }
    }
    if (pclose(pipe) != 0)
        throw std::runtime_error("failed: " + command);
}

Pose pose_from(const json& n)
{
    return {Vec3(n[0], n[1], n[2]),
            Quaternion(n[3].get<double>(), n[4].get<double>(), n[5].get<double>(), n[6].get<double>())};
}

/// The process gets a scene as JSON, and prints a line of JSON a frame: {"ms": time, "poses": [[x, y, z, w,
/// x, y, z], ...]}.
Trajectory run_process(const std::string& command, const Scene& scene, const Way& way, int steps,
                       double default_dt)
{
    const EngineScene described = describe(scene);
    const int substeps = substeps_of(way, described, default_dt);
    json all = to_json(described);
    all["steps"] = steps;
    all["way"] = {{"substeps", substeps}, {"iterations", way.iterations}, {"fine", way.fine}};
    all["mjcf"] = mjcf_of(described, way, described.dt / substeps, false);
    all["velocities"] = mujoco_velocities(described);
    const SceneFile file(all);
    Trajectory run;
    read_lines(command + " '" + file.path().string() + "'", [&](const std::string& line) {
        const json frame = json::parse(line);
        Frame& next = run.emplace_back();
        next.ms = frame["ms"];
        for (const json& pose : frame["poses"])
            next.poses.push_back(pose_from(pose));
    });
    if (run.size() != static_cast<std::size_t>(steps) + 1)
        throw std::runtime_error(command + " ended after " + std::to_string(run.size()) + " frames");
    return run;
}

Engine node_engine(Engine engine, const std::string& package, const std::string& script, double default_dt)
{
    std::ifstream file(npm_folder() / "node_modules" / package / "package.json");
    if (!file)
        engine.missing = "npm's " + package + " is not installed: ./course run engines";
    else if (std::system("node --version > /dev/null 2>&1") != 0)
        engine.missing = "node is not installed";
    else
        engine.version = json::parse(file)["version"];
    const std::string command = "node '" + (source_directory() / "chapters/engines/node" / script).string() +
                                "' '" + npm_folder().string() + "'";
    engine.run = [=](const Scene& scene, const Way& way, int steps) {
        return run_process(command, scene, way, steps, default_dt);
    };
    return engine;
}

}  // namespace

Engine npm_mujoco_engine()
{
    return node_engine({"MuJoCo of npm",
                        "",
                        "",
                        "https://mujoco.readthedocs.io/en/stable/modeling.html#preventing-slip",
                        {"default", 0},
                        {"best", 0, 0, true},
                        {}},
                       "@mujoco/mujoco", "mujoco.mjs", mujoco_default_step);
}

Engine jolt_engine()
{
    return node_engine({"Jolt",
                        "",
                        "",
                        "https://jrouwe.github.io/JoltPhysics/class_physics_settings.html",
                        {"default"},
                        {"best", 4, 0, true},
                        {}},
                       "jolt-physics", "jolt.mjs", 1.0 / 60);
}

Engine rapier_engine()
{
    return node_engine({"Rapier",
                        "",
                        "",
                        "https://rapier.rs/docs/user_guides/javascript/integration_parameters",
                        {"default"},
                        {"best", 4, 0, true},
                        {}},
                       "@dimforge/rapier3d-compat", "rapier.mjs", 1.0 / 60);
}

/// Default: a step a frame. Best: its own time step of 1 ms, and so ten or more.
Engine dart_engine()
{
    Engine engine{"DART", "", "", "https://dartsim.github.io/", {"default"}, {"best", 0}, {}};
#ifdef ENDURING_DART
    engine.version = ENDURING_DART;
    engine.run = [](const Scene& scene, const Way& way, int steps) {
        return run_process("'" ENDURING_DART_PROGRAM "'", scene, way, steps, 1e-3);
    };
#else
    engine.missing = "libdart-dev is not installed, which is large: ./course setup dart";
#endif
    return engine;
}

}  // namespace enduring::engines
