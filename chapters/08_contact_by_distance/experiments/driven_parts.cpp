#include "chapters/08_contact_by_distance/experiments/driven_parts.hpp"

#include "common/experiments/run/run.hpp"
#include "common/scenes/scene_reader.hpp"

namespace enduring::chapter08::driven_parts {

Scene scene_from(const json& scene) { return read_scene(scene.dump(), "", "driven.json", {}); }

json scene_text(const std::string& name, double dt, double duration, double mu_s, double mu_d)
{
    return {{"name", name},
            {"dt", dt},
            {"duration", duration},
            {"contact", {{"friction", {{"model", "mass_splitting"}, {"mu_s", mu_s}, {"mu_d", mu_d}}}}}};
}

json box_body(const std::string& name, const std::string& type, const json& size, const json& position)
{
    json body{{"name", name}, {"type", type}, {"shape", {{"box", {{"size", size}}}}}, {"position", position}};
    if (type == "rigid")
        body["mass"] = 2;
    return body;
}

void run_watched(Scene& scene, const std::function<bool(const World&)>& watch,
                 const ImplicitSettings& settings)
{
    run(scene, chapter08_solver(scene.contact, settings), {},
        {.stop = [&](const World& world, const Contacts&) { return watch(world); }});
}

void run_whole(Scene& scene)
{
    run_watched(scene, [](const World&) { return false; });
}

const RigidMotion& motion_of(const World& world, std::size_t body)
{
    return dynamic_cast<const RigidBody&>(*world.bodies[body]).motion();
}

}  // namespace enduring::chapter08::driven_parts
