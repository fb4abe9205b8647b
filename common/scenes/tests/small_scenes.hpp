#pragma once

#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"

#include <string>

namespace enduring::tests {

inline const std::string ball_text = R"({
  "name": "ball", "gravity": [0, -10, 0], "dt": 0.01, "duration": 0.5,
  "contact": {"method": "dpf", "stiffness": 500, "max_depenetration_velocity": 0.2, "wanted_depth": 1e-4},
  "planes": [{"name": "ground", "point": [0, -1, 0], "normal": [0, 2, 0], "stiffness": 9000}],
  "bodies": [
    {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.5}}, "mass": 2,
     "position": [0, 3, 0], "velocity": [1, 0, 0], "look": {"color": [1, 0.5, 0], "smooth": true}},
    {"name": "floor", "type": "static", "shape": {"plane_grid": {"size": [4, 6], "cells": [2, 3]}}}
  ],
  "camera": {"eye": [1, 2, 3], "target": [0, 1, 0], "field_of_view_deg": 40}
})";

inline Scene ball(const std::string& patch = "")
{
    return read_scene(ball_text, patch, "ball.json", {{"/nowhere"}});
}

inline std::string complaint(const std::string& patch)
{
    return complaint_of([&] { ball(patch); });
}

inline const std::string jelly_text = R"({
  "name": "jelly", "dt": 0.01, "duration": 1,
  "bodies": [{"name": "bar", "type": "deformable", "shape": {"bar": {"size": [1, 0.5, 0.5], "cells": [2, 1, 1]}},
              "density": 400, "young": 1e5, "poisson": 0.3}]
})";

inline Scene jelly(const std::string& patch)
{
    return read_scene(jelly_text, patch, "jelly.json", {{"/nowhere"}});
}

}  // namespace enduring::tests
