#pragma once

#include "common/experiments/render/clip.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/run/probes.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

namespace enduring {

/// Draws on a stage what a chapter wants to show of the contacts.
using MarkContacts = std::function<void(Stage&, const World&, const Contacts&)>;

/// Watches a run and takes a picture at some moments, the contacts marked.
class StripProbe final : public Probe {
public:
    /// @param scene  looks and camera; outlives the probe
    /// @param times  of the pictures [s], ascending; each is taken at the step next to it
    StripProbe(const Scene& scene, std::vector<double> times, MarkContacts mark = mark_contacts,
               int width = 640, int height = 420);
    void observe(const World& world, const Contacts& contacts, double dt) override;
    /// The pictures so far, `columns` in a row, each with its time.
    Picture all(int columns) const { return strip(pictures_, columns); }

private:
    const Scene& scene_;
    std::vector<double> times_;
    MarkContacts mark_;
    Renderer renderer_;
    std::vector<StripPicture> pictures_;
};

/// What a film shows of a run, and how fast.
struct FilmStyle {
    double slow_motion = 1;                                  ///< seconds of the clip for one of the run
    double until = std::numeric_limits<double>::infinity();  ///< the clip ends at this moment of the run [s]
    MarkContacts mark{};                                     ///< none: bodies and planes only
};

/// Watches a run and films it; a second of the run takes a second of the clip if the style does not say
/// otherwise.
class ClipProbe final : public Probe {
public:
    /// @param scene              looks and camera; outlives the probe
    /// @param file               as for Clip
    /// @param frames_per_second  1 to 60
    ClipProbe(const Scene& scene, const std::filesystem::path& file, int frames_per_second = 20,
              int width = 480, int height = 344, FilmStyle style = {});
    void observe(const World& world, const Contacts& contacts, double dt) override;
    int frames() const { return frames_; }
    /// Without it no clip is written.
    void finish() { clip_.finish(); }

private:
    const Scene& scene_;
    Renderer renderer_;
    double frames_per_second_;  ///< of the run
    FilmStyle style_;
    int frames_ = 0;
    Clip clip_;
};

}  // namespace enduring
