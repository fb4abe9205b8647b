#include "common/experiments/render/clip.hpp"

#include "common/experiments/report/pictures_wanted.hpp"
#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/warn_once.hpp"
#include "common/input/input_error.hpp"
#include "common/input/pending_file.hpp"

#include <string_view>
#include <vector>

namespace enduring {
namespace {

/// How ffmpeg encodes for a suffix; empty for one we do not know.
std::vector<std::string> encoding(const std::string& suffix)
{
    if (suffix == ".webp")
        return {"-c:v", "libwebp_anim", "-quality", "82", "-compression_level",
                "2",    "-loop",        "0",        "-f", "webp"};
    if (suffix == ".mp4")
        return {"-c:v",    "libx264",   "-crf",       "20", "-pix_fmt",
                "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
    return {};
}

}  // namespace

/// ffmpeg at work, and where it writes.
struct Clip::Encoder {
    Encoder(const std::filesystem::path& path, int width, int height, int pace)
        : file(path), frame_width(width), frame_height(height),
          ffmpeg(command(path, width, height, pace, file.neighbour()), "ffmpeg")
    {}

    static std::vector<std::string> command(const std::filesystem::path& path, int width, int height,
                                            int pace, const std::filesystem::path& place)
    {
        std::vector<std::string> words{"ffmpeg",    "-loglevel",
                                       "error",     "-y",
                                       "-f",        "rawvideo",
                                       "-pix_fmt",  "rgb24",
                                       "-s",        std::to_string(width) + 'x' + std::to_string(height),
                                       "-r",        std::to_string(pace),
                                       "-i",        "-",
                                       "-an",       "-fflags",
                                       "+bitexact", "-flags:v",
                                       "+bitexact"};
        for (const std::string& word : encoding(path.extension().string()))
            words.push_back(word);
        words.push_back(place.string());
        return words;
    }

    PendingFile file;
    int frame_width, frame_height;
    Subprocess ffmpeg;
};

Clip::Clip(std::filesystem::path path, int frames_per_second)
    : path_(std::move(path)), frames_per_second_(frames_per_second)
{
    if (encoding(path_.extension().string()).empty())
        throw InputError(path_.string() + ": a clip ends in .webp or .mp4");
    if (frames_per_second < 1 || frames_per_second > 60)
        throw InputError(path_.string() + ": " + std::to_string(frames_per_second) +
                         " frames a second; allowed are 1 to 60");
}

Clip::~Clip() = default;

void Clip::add(const Picture& frame)
{
    if (frame.empty())
        return;
    if (frame.width % 2 != 0 || frame.height % 2 != 0)
        throw InputError(path_.string() + ": frames must be even in both directions");
    if (!encoder_ && !is_installed("ffmpeg")) {
        warn_once("films are left out: ffmpeg is not installed. On Debian: apt-get install ffmpeg");
        std::filesystem::remove(path_);
        return;
    }
    if (!encoder_)
        encoder_ = std::make_unique<Encoder>(path_, frame.width, frame.height, frames_per_second_);
    if (frame.width != encoder_->frame_width || frame.height != encoder_->frame_height)
        throw InputError(path_.string() + ": frames of different size");
    encoder_->ffmpeg.write({reinterpret_cast<const char*>(frame.rgb.data()), frame.rgb.size()});
}

void Clip::finish()
{
    if (!pictures_wanted())
        std::filesystem::remove(path_);
    if (!encoder_)
        return;
    encoder_->ffmpeg.finish();
    encoder_->file.publish();
    encoder_.reset();
}

}  // namespace enduring
