#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"

#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/input/number_text.hpp"
#include "common/scenes/scene_reader.hpp"

#include <algorithm>
#include <map>

namespace enduring::chapter09 {
namespace {

const std::string soft = R"("basis": "linear", "impulse_response": "implicit", "poisson": 0.3,
    "rayleigh": {"mass": 0.5, "stiffness": 0.02})";

//! [bodies]
const std::map<std::string, std::string>& bodies()
{
    static const std::map<std::string, std::string> all{
        {"block", R"("type": "rigid", "shape": {"box": {"size": [0.4, 0.4, 0.4], "cells": [2, 2, 2]}})"},
        {"leaning block",
         R"("type": "rigid", "shape": {"box": {"size": [0.4, 0.4, 0.4], "cells": [2, 2, 2]}},
            "rotation": {"axis": [1, 0.2, 0.7], "angle_deg": 17})"},
        {"block on a corner",
         R"("type": "rigid", "shape": {"box": {"size": [0.4, 0.4, 0.4], "cells": [5, 5, 5]}},
            "rotation": {"axis": [1, 0, -1], "angle_deg": 54.7})"},
        {"fine block", R"("type": "rigid", "shape": {"box": {"size": [0.4, 0.4, 0.4], "cells": [5, 5, 5]}})"},
        {"plate", R"("type": "rigid", "shape": {"box": {"size": [0.6, 0.05, 0.6], "cells": [3, 1, 3]}})"},
        {"ball", R"("type": "rigid", "shape": {"sphere": {"radius": 0.2}})"},
        {"soft block", R"("type": "deformable", "young": 1e5,
            "shape": {"bar": {"size": [0.4, 0.4, 0.4], "cells": [2, 2, 2]}}, )" +
                           soft}};
    return all;
}
//! [bodies]

Scene scene_at(const Surroundings& surroundings, const std::string& body, double height, double dt)
{
    return read_scene(R"({"name": "inside", "duration": 3, "dt": )" + shortest(dt) + surroundings.planes +
                          R"(, "contact": {"friction": {"model": "mass_splitting", "mu_s": 0.5, "mu_d": 0.4}},
        "camera": {"eye": [1.6, 0.7, 2.4], "target": [0, -0.05, 0], "field_of_view_deg": 30},
        "bodies": [)" + surroundings.bodies +
                          R"({"name": "body", "mass": 20, "look": {"color": [0.5, 0.16, 0.08]}, )" +
                          bodies().at(body) + R"(, "position": [0.013, )" + shortest(height) + ", 0.021]}]}",
                      "", "inside.json", {});
}

const Body& body_of(const World& world) { return *world.bodies.back(); }

}  // namespace

const std::vector<Surroundings>& all_surroundings()
{
    static const std::vector<Surroundings> all{
        {"floor",
         "",
         R"({"name": "floor", "type": "static", "position": [0, -0.5, 0],
             "shape": {"box": {"size": [2, 1, 2], "cells": [7, 3, 7]}}}, )",
         {"block", "leaning block", "plate", "ball", "soft block"}},
        {"plane",
         R"(, "planes": [{"name": "floor"}])",
         "",
         {"block", "leaning block", "plate", "ball", "soft block"}},
        {"bowl",
         "",
         R"({"name": "bowl", "type": "static", "position": [0, 0.8, 0],
             "shape": {"bowl": {"inner_radius": 0.8, "thickness": 0.8, "rim_angle_deg": 70,
                                "segments_around": 24, "segments_along": 10}}}, )",
         {"ball"}},
        {"cushion",
         "",
         R"({"name": "cushion", "type": "deformable", "position": [0, -0.4, 0], "mass": 200, "young": 2e5,
             "shape": {"bar": {"size": [1.2, 0.8, 1.2], "cells": [4, 3, 4]}},
             "fixed": {"max": [9, -0.39, 9]}, )" +
             soft + "}, ",
         {"block", "ball"}}};
    return all;
}

Scene scene_inside(const Surroundings& surroundings, const std::string& body, double depth, double dt)
{
    const Scene trial = scene_at(surroundings, body, 0, dt);
    return scene_at(surroundings, body, -lowest_vertex(trial.world) - depth, dt);
}

Scene bunny_in_wall()
{
    return load_scene(scene_file("bunny_bowl"), R"({"/bodies/bunny/position": [0.3, 0.12, 0.1]})");
}

double height_of(const Surroundings& surroundings, const std::string& body)
{
    const Scene trial = scene_at(surroundings, body, 0, 0.01);
    double highest = -1e9;
    for (const Vec3& x : body_of(trial.world).positions_t0())
        highest = std::max(highest, x.y());
    return highest - lowest_vertex(trial.world);
}

double lowest_vertex(const World& world)
{
    double height = 1e9;
    for (const Vec3& x : body_of(world).positions_t0())
        height = std::min(height, x.y());
    return height;
}

double deepest_inside(const World& world)
{
    double deepest = 0;
    for (const Vec3& x : body_of(world).positions_t0()) {
        for (const Plane& plane : world.planes)
            deepest = std::max(deepest, plane.normal.dot(plane.point - x));
        for (std::size_t i = 0; i + 1 < world.bodies.size(); ++i)
            deepest = std::max(deepest, motivating::depth_inside(*world.bodies[i], x));
    }
    return deepest;
}

}  // namespace enduring::chapter09
