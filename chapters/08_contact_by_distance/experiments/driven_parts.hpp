#pragma once

#include "chapters/08_contact_by_distance/experiments/driven_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/rigid_body.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

/// What the scenes of bodies that are driven are made of: texts of scene files, and runs of them.
namespace enduring::chapter08::driven_parts {

using json = nlohmann::json;
constexpr double earth = 9.81;  ///< [m/s^2]

/// A scene without bodies.
json scene_text(const std::string& name, double dt, double duration, double mu_s, double mu_d);
/// A box, of 2 kg where it moves by itself.
json box_body(const std::string& name, const std::string& type, const json& size, const json& position);
Scene scene_from(const json& scene);

/// Runs a scene until its end, or until `watch` has seen enough in the world after a step.
void run_watched(Scene& scene, const std::function<bool(const World&)>& watch,
                 const ImplicitSettings& settings = {});
void run_whole(Scene& scene);

const RigidMotion& motion_of(const World& world, std::size_t body);

}  // namespace enduring::chapter08::driven_parts
