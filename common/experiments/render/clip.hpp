#pragma once

#include "common/experiments/render/picture.hpp"

#include <filesystem>
#include <memory>

namespace enduring {

/// A short looping film of a run, written by ffmpeg beside its place and renamed at the end. Without ffmpeg
/// there is no film, not an old one either, and stderr says so once.
class Clip {
public:
    /// @param path               .webp loops by itself wherever a picture
    ///     may stand; .mp4 is smaller for long clips
    /// @param frames_per_second  pace of playing, 1 to 60
    /// @throws InputError  another suffix, pace out of range, or the place cannot be written
    Clip(std::filesystem::path path, int frames_per_second = 25);
    ~Clip();

    /// All frames have the size of the first, even in both directions.
    /// @throws std::runtime_error  ffmpeg failed
    void add(const Picture& frame);
    /// Without frames nothing is written; without finish() neither.
    void finish();

private:
    struct Encoder;
    std::filesystem::path path_;
    int frames_per_second_;
    std::unique_ptr<Encoder> encoder_;
};

}  // namespace enduring
