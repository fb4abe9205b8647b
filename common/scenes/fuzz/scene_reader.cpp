#include "common/scenes/scene_reader.hpp"
#include "common/input/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <string>

/// Whatever the bytes are: a scene comes back whose positions are numbers, or an InputError; never a crash or
/// a hang. The first zero byte, if there is one, parts the scene from a change to it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string all(reinterpret_cast<const char*>(data), size);
    const std::size_t zero = all.find('\0');
    const std::string text = all.substr(0, zero),
                      patch = zero == std::string::npos ? "" : all.substr(zero + 1);
    const enduring::SceneLimits small{2000, 200, 8};
    try {
        const enduring::Scene scene = enduring::read_scene(text, patch, "fuzz.json", {{}, small});
        for (const auto& body : scene.world.bodies)
            for (const enduring::Vec3& position : body->positions_t0())
                if (!position.allFinite())
                    __builtin_trap();
    } catch (const enduring::InputError&) {}
    return 0;
}
