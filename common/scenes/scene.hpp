#pragma once

#include "common/geometry/vector.hpp"
#include "common/simulation/contact_parameters.hpp"
#include "common/simulation/step.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// Where a picture is taken from.
struct SceneCamera {
    Vec3 eye{3, 2, 4}, target{0, 0, 0};
    double field_of_view_deg = 35;
};

/// How a body looks; has no influence on the simulation.
struct BodyLook {
    Vec3 color{0.7, 0.7, 0.7};  ///< linear RGB in [0, 1]
    bool smooth = false;
};

/// One documented JSON file, read by every chapter's solver (docs: the scene format). A scene read twice
/// builds the same world to the last bit.
struct Scene {
    std::string name, description;
    double dt = 0.01;       ///< [s]
    double duration = 1.0;  ///< [s]
    ContactParameters contact;
    SceneCamera camera;
    bool camera_given = false;              ///< by the file; else one may be chosen that sees more
    std::map<std::string, BodyLook> looks;  ///< by body name
    World world;                            ///< bodies placed, velocities set, time 0
    bool gives_stiffness = false;           ///< in its file; else that of `contact` is the default
    std::string asks_exact = {};            ///< where its file asks for exact contact, or empty
    std::string asks_joints = {};           ///< where its file has joints, or empty
    std::string asks_frames = {};           ///< where its file has a body of points and edges alone, or empty
    std::string asks_surface_laws = {};     ///< where its file has one of SurfaceLaws or a grain, or empty
    /// what will probably go wrong, a sentence each (see scene_warnings()); run() tells them
    std::vector<std::string> warnings;
    /// the same under a solver that takes the scene's stiffness
    std::optional<std::string> stiffness_warning;
};

/// Changes to a scene before it is built, as a JSON merge patch: {"contact": {"stiffness": 2000}}.
/// @param path   the file; meshes it names are searched beside it, then in common/meshes
/// @param patch  merge patch as text, empty for none (what experiments use to vary one number)
/// @throws InputError  names the file, the JSON path as /bodies/0/density,
///     what was expected and what stands there
Scene load_scene(const std::filesystem::path& path, const std::string& patch = "");

/// @throws InputError  the scene asks for exact contact, and the springs of this solver give, or for joints,
///     for bodies of points and edges alone, or for a law of surfaces that it does not have: names the place
void require_asked(const Scene& scene, const Solver& solver);

/// A scene that ships with the course: common/scenes/NAME.json.
std::filesystem::path scene_file(const std::string& name);

}  // namespace enduring
