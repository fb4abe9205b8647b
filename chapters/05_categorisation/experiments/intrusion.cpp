#include "chapters/05_categorisation/experiments/intrusion.hpp"

#include "chapters/05_categorisation/experiments/label_marks.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <limits>

namespace enduring::chapter05 {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// How deep a point lies below the obstacle's surface [m]; not positive outside, and beyond its far side.
double depth_below(const IntrusionScene& scene, const Vec3& point)
{
    const double depth = -point.dot(scene.outwards);
    return depth < scene.thickness ? depth : 0;
}

bool inside_convex(const Body& body, const Vec3& point)
{
    const SurfaceMoment surface = surface_at(body, 0);
    for (int face = 0; face < static_cast<int>(body.surface().faces().size()); ++face)
        if (surface.face_normal(face).dot(point - surface.position(surface.step.face(face)[0])) >= 0)
            return false;
    return true;
}

bool in_a_pair(const World& world, const Contacts& contacts, const Body& body, int vertex)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.kind == ContactKind::vertex_face && contact.feature_a == vertex &&
               world.bodies[contact.body_a].get() == &body;
    });
}

long lost_vertices(const IntrusionScene& scene, const World& world, const Contacts& contacts)
{
    const Body &body = body_named(world, scene.body), &obstacle = body_named(world, scene.obstacle);
    const auto lost_of = [&](const Body& owner, const auto& inside) {
        long lost = 0;
        for (int vertex = 0; vertex < owner.surface().vertex_count(); ++vertex)
            lost += inside(owner.positions_t0()[vertex]) && !in_a_pair(world, contacts, owner, vertex);
        return lost;
    };
    return lost_of(body, [&](const Vec3& x) { return depth_below(scene, x) > 0; }) +
           lost_of(obstacle, [&](const Vec3& x) { return inside_convex(body, x); });
}

}  // namespace

std::vector<IntrusionScene> intrusion_scenes()
{
    return {
        {"cube slides", "", "cube", "floor", Vec3::UnitY(), unbounded},
        {"ball falls on soft contacts", R"({"duration": 0.6, "contact": {"stiffness": 200}, "bodies": [
            {"name": "floor", "type": "static", "shape": {"plane_grid": {"size": [2, 2], "cells": [5, 5]}}, "look": {"color": [0.45, 0.43, 0.38]}},
            {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25, "subdivisions": 2}}, "mass": 20,
             "position": [0.03, 0.6, 0.02]}]})",
         "ball", "floor", Vec3::UnitY(), unbounded},
        {"plate runs into a wall",
         R"({"duration": 0.3, "gravity": [0, 0, 0], "contact": {"stiffness": 100}, "bodies": [
            {"name": "wall", "type": "static", "shape": {"box": {"size": [0.18, 0.7, 0.9], "cells": [2, 5, 6]}}, "position": [0.09, 0.05, 0.03],
             "look": {"color": [0.45, 0.43, 0.38]}},
            {"name": "plate", "type": "rigid", "shape": {"box": {"size": [1, 0.1, 0.5], "cells": [20, 1, 10]}}, "mass": 20, "velocity": [4, 0, 0],
             "position": [-0.6, 0.03, 0.02], "look": {"color": [0.5, 0.16, 0.08]}}],
            "camera": {"eye": [1.5, 1.5, 2.2], "target": [-0.1, 0, 0], "field_of_view_deg": 30}})",
         "plate", "wall", -Vec3::UnitX(), 0.18},
    };
}

Intrusion intrude(const IntrusionScene& one, HookedPairs treatment)
{
    Scene scene = load_scene(scene_file("hooked"), one.patch);
    Intrusion found;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double) {
        const Body& body = body_named(world, one.body);
        double foremost = -unbounded;
        for (const Vec3& x : body.positions_t0())
            foremost = std::max(foremost, -x.dot(one.outwards));
        if (foremost > found.deepest) {
            found.deepest = foremost;
            found.deepest_at = world.time;
        }
        found.lost_vertices = std::max(found.lost_vertices, lost_vertices(one, world, contacts));
        found.last_speed = body.linear_momentum().x() / body.mass();
        found.depths.add(
            {std::string(treatment == HookedPairs::pushed ? "pushed" : "dropped"), world.time, foremost});
    });
    run(scene, solver_that(treatment, EdgeRule::either, scene.contact), {&watch}, failure_on_purpose());
    return found;
}

Picture picture_of_intrusion(const IntrusionScene& one, HookedPairs treatment, double time)
{
    Scene scene = load_scene(scene_file("hooked"), one.patch);
    RunLimits limits;
    limits.steps = static_cast<int>(time / scene.dt + 0.5);
    const RunResult result = run(scene, solver_that(treatment, EdgeRule::either, scene.contact), {},
                                 failure_on_purpose(limits));
    Stage stage = stage_of(scene.world, scene);
    stage.bodies.front().opacity = 0.4;
    mark_by_label(stage, scene.world, result.contacts);
    Renderer renderer(640, 420);
    return renderer.draw(stage);
}

}  // namespace enduring::chapter05
