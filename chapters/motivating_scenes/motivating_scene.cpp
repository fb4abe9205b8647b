#include "chapters/motivating_scenes/motivating_scene.hpp"

#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <stdexcept>

namespace enduring::motivating {

const MotivatingScene& motivating_scene(const std::string& name)
{
    std::string known;
    for (const MotivatingScene& scene : motivating_scenes()) {
        if (scene.name == name)
            return scene;
        known += (known.empty() ? "" : ", ") + scene.name;
    }
    throw InputError("there is no motivating scene \"" + name + "\"; there are " + known);
}

bool passes(const MotivatingScene& scene, const std::optional<double>& value)
{
    return value && (scene.bound == Bound::at_least ? *value >= scene.limit : *value <= scene.limit);
}

RunLimits limits_of(const MotivatingScene& scene, int chapter)
{
    return {.may_gain_energy = scene.expected[static_cast<std::size_t>(chapter) - 1] == 'f'};
}

std::string bound_text(const MotivatingScene& scene)
{
    return (scene.bound == Bound::at_least ? "at least " : "at most ") + readable(scene.limit, 3) + " " +
           scene.unit;
}

Outcome try_scene(const MotivatingScene& scene, const MakeSolver& make, const RunLimits& limits,
                  bool with_picture)
{
    const PrepareScene prepare = [&make](Scene& prepared) { return make(prepared.contact); };
    return try_scene(scene, prepare, limits, with_picture);
}

Outcome try_scene(const MotivatingScene& motivating, const PrepareScene& prepare, const RunLimits& limits,
                  bool with_picture)
{
    Scene scene = load_scene(scene_file(motivating.file), motivating.patch);
    Gauge gauge(motivating.reading);
    Outcome outcome;
    std::vector<Probe*> probes{&gauge};
    std::unique_ptr<Renderer> renderer;
    WatchProbe camera([&](const World& world, const Contacts& contacts, double dt) {
        if (outcome.picture || world.time < motivating.moments.back() - 0.5 * dt)
            return;
        Stage stage = stage_of(world, scene);
        mark_pairs(stage, world, contacts);
        outcome.picture = renderer->draw(stage);
    });
    if (with_picture) {
        renderer = std::make_unique<Renderer>(400, 280);
        probes.push_back(&camera);
    }
    try {
        const Solver solver = prepare(scene);
        if (!solver.has_joints)
            scene.asks_joints.clear();  // a row shows what the bodies do then
        run(scene, solver, probes, limits);
        outcome.value = gauge.value();
    } catch (const std::runtime_error& error) {
        outcome.broken = error.what();
    }
    return outcome;
}

}  // namespace enduring::motivating
