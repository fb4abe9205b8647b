#include "chapters/motivating_scenes/scaled_scene.hpp"

#include "common/scenes/scene_reader.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace enduring::motivating {
namespace {

using nlohmann::json;

/// Multiplies a number or a list of numbers, if it is there.
void multiply(json& object, const char* key, double factor)
{
    if (!object.contains(key))
        return;
    json& value = object[key];
    if (value.is_number())
        value = factor * value.get<double>();
    else
        for (json& number : value)
            number = factor * number.get<double>();
}

void scale_body(json& body, const SceneScale& scale)
{
    const double s = scale.length, root = std::sqrt(s);
    multiply(body, "position", s);
    multiply(body, "velocity", root);
    multiply(body, "angular_velocity", 1 / root);
    multiply(body, "mass", s * s * s * scale.density);
    multiply(body, "density", scale.density);
    multiply(body, "young", s * scale.density);
    body["shape"]["scale"] = s * body["shape"].value("scale", 1.0);
    if (body.contains("rayleigh")) {
        multiply(body["rayleigh"], "mass", 1 / root);
        multiply(body["rayleigh"], "stiffness", root);
    }
    if (body.contains("fixed")) {
        multiply(body["fixed"], "min", s);
        multiply(body["fixed"], "max", s);
    }
}

json cube(const std::string& name, double x, double y, double z, double turn_deg, const json& axis)
{
    return {{"name", name}, {"type", "rigid"},       {"shape", {{"box", {{"size", {1, 1, 1}}}}}},
            {"mass", 10},   {"position", {x, y, z}}, {"rotation", {{"axis", axis}, {"angle_deg", turn_deg}}}};
}

json scene_of(const std::string& name, const json& bodies)
{
    return {{"name", name},
            {"dt", 0.01},
            {"duration", 1},
            {"contact", {{"friction", {{"model", "mass_splitting"}, {"mu_s", 0.5}, {"mu_d", 0.4}}}}},
            {"planes", {{{"name", "ground"}}}},
            {"bodies", bodies}};
}

json falling_stack()
{
    json bodies;
    for (int i = 0; i < 4; ++i)
        bodies.push_back(cube("cube " + std::to_string(i), 0.01 * i, 0.55 + 1.05 * i, 0, 7 * i, {0, 1, 0}));
    return scene_of("falling stack", bodies);
}

json on_triangles(const std::string& name, json body)
{
    const json slope{
        {"name", "slope"},
        {"type", "static"},
        {"shape", {{"slope", {{"size", {12, 0.5, 3}}, {"angle_deg", 10}, {"cells", {16, 1, 5}}}}}}};
    json scene = scene_of(name, {slope, std::move(body)});
    scene.erase("planes");
    return scene;
}

json sliding_block()
{
    json scene = on_triangles("sliding block", {{"name", "block"},
                                                {"type", "rigid"},
                                                {"shape", {{"box", {{"size", {1, 0.4, 1}}}}}},
                                                {"mass", 100},
                                                {"position", {-2.99, -0.31, 0.13}},
                                                {"rotation", {{"axis", {0, 0, 1}}, {"angle_deg", 10}}},
                                                {"velocity", {2.954423, 0.520945, 0.2}}});
    scene["contact"]["friction"]["mu_s"] = 0.185;
    scene["contact"]["friction"]["mu_d"] = 0.09;
    return scene;
}

json rolling_ball()
{
    return on_triangles("rolling ball", {{"name", "ball"},
                                         {"type", "rigid"},
                                         {"shape", {{"sphere", {{"radius", 0.5}}}}},
                                         {"mass", 10},
                                         {"position", {2, 0.87, 0.07}}});
}

json soft_cube(double x, double y, double z)
{
    return {{"name", "jelly"},
            {"type", "deformable"},
            {"shape", {{"bar", {{"size", {1, 1, 1}}, {"cells", {2, 2, 2}}}}}},
            {"mass", 20},
            {"young", 20000},
            {"poisson", 0.3},
            {"rayleigh", {{"mass", 0.5}, {"stiffness", 0.02}}},
            {"impulse_response", "implicit"},
            {"position", {x, y, z}},
            {"rotation", {{"axis", {1, 0, 0.3}}, {"angle_deg", 20}}}};
}

json heap()
{
    json bodies;
    for (int i = 0; i < 5; ++i)
        bodies.push_back(cube("cube " + std::to_string(i), 0.3 * (i % 3) - 0.3, 0.8 + 1.75 * i,
                              0.25 * (i % 2), 23 * i, {1, 0.2 * i, 0.7}));
    return scene_of("heap", bodies);
}

json weightless()
{
    json fast = cube("fast", -1.3, 0.1, 0.2, 30, {1, 2, 3}), slow = cube("slow", 0, 0, 0, 0, {0, 1, 0});
    fast["velocity"] = {4, 0, 0};
    json scene = scene_of("weightless", {fast, slow});
    scene.erase("planes");
    scene["gravity"] = {0, 0, 0};
    return scene;
}

json floor_below()
{
    return {{"name", "floor"},
            {"type", "static"},
            {"position", {0, -1, 0}},
            {"shape", {{"box", {{"size", {6, 2, 6}}, {"cells", {7, 3, 7}}}}}}};
}

json inside(const std::string& name, const json& bodies, bool on_plane, double gravity)
{
    json scene = scene_of(name, bodies);
    if (!on_plane)
        scene.erase("planes");
    scene["gravity"] = {0, gravity, 0};
    return scene;
}

}  // namespace

std::string scaled(const std::string& text, const SceneScale& scale)
{
    json scene = json::parse(text);
    const double s = scale.length, root = std::sqrt(s);
    multiply(scene, "dt", root);
    multiply(scene, "duration", root);
    if (scene.contains("contact")) {
        multiply(scene["contact"], "stiffness", s * s * scale.density);
        multiply(scene["contact"], "max_depenetration_velocity", root);
        multiply(scene["contact"], "wanted_depth", s);
    }
    if (scene.contains("planes"))
        for (json& plane : scene["planes"])
            multiply(plane, "point", s);
    for (json& body : scene["bodies"])
        scale_body(body, scale);
    return scene.dump();
}

const std::vector<ScaleTrial>& scale_trials()
{
    static const std::vector<ScaleTrial> all{
        {"falling stack", falling_stack().dump(), 60},
        {"sliding block", sliding_block().dump(), 100},
        {"rolling ball", rolling_ball().dump(), 60},
        {"soft cube", scene_of("soft", json::array({soft_cube(0, 0.9, 0)})).dump(), 40},
        {"heap", heap().dump(), 80},
        {"weightless", weightless().dump(), 60}};
    return all;
}

const std::vector<ScaleTrial>& inside_scale_trials()
{
    const json leaning = cube("cube", 0.1, 0.35, 0.2, 17, {1, 0.2, 0.7}),
               above = cube("cube", 0.1, 1.5, 0.1, 30, {0, 1, 0.2});
    static const std::vector<ScaleTrial> all{
        {"in a plane", inside("in a plane", json::array({leaning}), true, -9.81).dump(), 80},
        {"in a floor", inside("in a floor", {floor_below(), leaning}, false, -9.81).dump(), 80},
        {"in a soft cube", inside("in a soft cube", {soft_cube(0, 0.6, 0), above}, true, -9.81).dump(), 20},
        {"in a floor, weightless", inside("weightless", {floor_below(), leaning}, false, 0).dump(), 80}};
    return all;
}

double difference(const World& world, const World& scaled, const SceneScale& scale)
{
    double largest = 0;
    for (std::size_t body = 0; body < world.bodies.size(); ++body) {
        const auto mine = world.bodies[body]->positions_t0(), its = scaled.bodies[body]->positions_t0();
        for (std::size_t vertex = 0; vertex < mine.size(); ++vertex)
            largest = std::max(largest, (its[vertex] / scale.length - mine[vertex]).norm());
    }
    return largest;
}

double difference_over_scales(const ScaleTrial& trial,
                              const std::function<Solver(const ContactParameters&)>& make_solver)
{
    const auto run_at = [&](const SceneScale& scale) {
        Scene scene = read_scene(scaled(trial.scene, scale), "", "scaled.json", {});
        const Solver solver = make_solver(scene.contact);
        Contacts contacts;
        for (int i = 0; i < trial.steps; ++i)
            advance(scene.world, contacts, solver, scene.dt);
        return scene;
    };
    const Scene metres = run_at({});
    double largest = 0;
    for (const SceneScale& scale :
         {SceneScale{1.0 / 1024}, SceneScale{64, 1.0 / 8}, SceneScale{1e-3, 3}, SceneScale{100, 0.7}})
        largest = std::max(largest, difference(metres.world, run_at(scale).world, scale));
    return largest;
}

}  // namespace enduring::motivating
