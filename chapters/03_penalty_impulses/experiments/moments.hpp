#pragma once

#include "common/render/clip.hpp"
#include "common/render/renderer.hpp"
#include "common/render/strip.hpp"
#include "common/simulation/probes.hpp"
#include "common/simulation/scene.hpp"

#include <filesystem>

namespace enduring::chapter03 {

/// Where a clip goes, and its frames a second; a second of the run takes a second.
struct ClipPlan {
    std::filesystem::path file;
    int pace = 20;  ///< [1/s]
};

/// Frames are most of a quick run's time, so it takes few.
inline ClipPlan clip_plan(const std::filesystem::path& file, bool quick) { return {file, quick ? 3 : 20}; }

/// Pictures of a run: a strip of some moments with the contacts marked, and a clip of the whole.
class Moments final : public Probe {
public:
    /// @param scene  looks and camera
    /// @param times  of the strip's pictures [s], ascending
    Moments(const Scene& scene, std::vector<double> times, const ClipPlan& plan);
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// Writes the strip, three pictures in a row, and ends the clip.
    void finish(const std::filesystem::path& strip_file);

private:
    const Scene& scene_;
    std::vector<double> times_;
    Renderer large_, small_;
    int pace_, frames_ = 0;
    Clip clip_;
    std::vector<StripPicture> pictures_;
};

}  // namespace enduring::chapter03
