#pragma once

#include "common/scenes/scene_reader.hpp"
#include "common/scenes/start_overlap.hpp"

#include <string>
#include <vector>

/// Scenes of a few bodies, as the text of trial.json.
namespace enduring::tests {

inline Scene read(const std::string& rest)
{
    return read_scene(R"({"name": "trial", "dt": 0.01, "duration": 1, )" + rest + "}", "", "trial.json", {});
}

inline std::string body(const std::string& name, const std::string& type, const std::string& shape,
                        const std::string& place, const std::string& more = "")
{
    return R"({"name": ")" + name + R"(", "type": ")" + type + R"(", "shape": )" + shape +
           R"(, "position": )" + place + more + "}";
}

inline std::string cube(const std::string& name, const std::string& place,
                        const std::string& more = R"(, "mass": 10)")
{
    return body(name, "rigid", R"({"box": {"size": [1, 1, 1]}})", place, more);
}

inline std::vector<StartOverlap> overlaps(const std::string& rest)
{
    const Scene scene = read(rest);
    return start_overlaps(scene.world, scene.contact);
}

inline const std::string soft = R"(, "mass": 10, "young": 1e5, "poisson": 0.3)";

}  // namespace enduring::tests
