#pragma once

#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/report.hpp"

#include <string>
#include <vector>

namespace enduring::chapter03 {

/// Pictures of a run: NAME.png, some moments with the pairs of features marked, and NAME.mp4, the whole.
class PairFilm {
public:
    /// @param times  of the strip's pictures [s], ascending
    /// @param quick  few frames: they are most of a quick run's time
    PairFilm(const Scene& scene, std::vector<double> times, Report& report, const std::string& name,
             bool quick);
    std::vector<Probe*> probes() { return {&strip_, &clip_}; }
    /// Writes the strip, three pictures in a row, and ends the clip.
    void finish();

private:
    std::filesystem::path strip_file_;
    StripProbe strip_;
    ClipProbe clip_;
};

}  // namespace enduring::chapter03
