#pragma once

#include "common/render/clip.hpp"
#include "common/render/renderer.hpp"
#include "common/render/strip.hpp"
#include "common/simulation/probes.hpp"
#include "common/simulation/scene.hpp"

#include <optional>

namespace enduring::chapter03 {

/// Pictures of a run: a strip of some moments with the contacts marked, and a clip of the whole if a place for it is given.
class Moments final : public Probe {
public:
    /// @param scene  looks and camera
    /// @param times  of the strip's pictures [s], ascending
    Moments(const Scene& scene, std::vector<double> times, std::optional<std::filesystem::path> clip = std::nullopt);
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// Writes the strip, three pictures in a row, and ends the clip.
    void finish(const std::filesystem::path& strip_file);

private:
    const Scene& scene_;
    std::vector<double> times_;
    Renderer large_, small_;
    std::optional<Clip> clip_;
    int frames_ = 0;
    std::vector<StripPicture> pictures_;
};

/// Frames of a clip [1/s]; a second of the run takes a second.
constexpr int clip_pace = 20;

}  // namespace enduring::chapter03
