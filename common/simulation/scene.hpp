#pragma once

#include "common/geometry/vector.hpp"
#include "common/simulation/step.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace enduring {

enum class PenaltyMethod { discrete, continuous };  ///< "dpf" or "cpf" in the file

enum class FrictionModel { none, yamane_nakamura, mended };  ///< "none", "yamane_nakamura" or "mended" in the file

/// Friction of every pair (chapter 4).
struct FrictionParameters {
    FrictionModel model = FrictionModel::none;
    double mu_s = 0.5, mu_d = 0.3;  ///< static and dynamic coefficient; 0 <= mu_d <= mu_s
    double spring = 100;            ///< tangential stiffness of one pair [N/m]; k_FP of (5.22)
    double damper = 25;             ///< yamane_nakamura: k_FD of (5.22), of one pair [N s/m]
    double damping_ratio = 20;      ///< mended: the damper beside the spring, relative to critical for the pair's share of mass
    double weighting = 10000;       ///< k_w of (5.24) [s/m]: 1/k_w is the slip speed at which friction becomes dynamic
};

/// What a scene leaves out: the thesis' constants for yamane_nakamura (its section 7.3); for mended a spring as stiff as
/// the pair along its normal, and 1/k_w = 5 cm/s.
/// @param stiffness  k of one pair [N/m]
FrictionParameters friction_defaults(FrictionModel model, double stiffness);

/// What a scene says about contact. A chapter reads what its layer knows and leaves the rest.
struct ContactParameters {
    PenaltyMethod method = PenaltyMethod::continuous;
    double stiffness = 1000;  ///< k of one pair [N/m], positive
    FrictionParameters friction{};
};

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

/// One documented JSON file, read by every chapter's solver (docs: the scene format). A scene read twice builds the same
/// world to the last bit.
struct Scene {
    std::string name, description;
    double dt = 0.01;       ///< [s]
    double duration = 1.0;  ///< [s]
    ContactParameters contact;
    SceneCamera camera;
    std::map<std::string, BodyLook> looks;  ///< by body name
    World world;                            ///< bodies placed, velocities set, time 0
    std::vector<std::string> warnings;      ///< what will probably go wrong, a sentence each (see scene_warnings()); run() tells them
};

/// Changes to a scene before it is built, as a JSON merge patch: {"contact": {"stiffness": 2000}}.
/// @param path   the file; meshes it names are searched beside it, then in common/meshes
/// @param patch  merge patch as text, empty for none (what experiments use to vary one number)
/// @throws InputError  names the file, the JSON path as /bodies/0/density, what was expected and what stands there
Scene load_scene(const std::filesystem::path& path, const std::string& patch = "");

/// A scene that ships with the course: common/scenes/NAME.json.
std::filesystem::path scene_file(const std::string& name);

}  // namespace enduring
