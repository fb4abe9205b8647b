#include "common/experiments/render/film_probes.hpp"

#include <cstdio>
#include <utility>

namespace enduring {

StripProbe::StripProbe(const Scene& scene, std::vector<double> times, MarkContacts mark, int width,
                       int height)
    : scene_(scene), times_(std::move(times)), mark_(std::move(mark)), renderer_(width, height)
{}

void StripProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    if (pictures_.size() == times_.size() || world.time < times_[pictures_.size()] - dt / 2)
        return;
    Stage stage = stage_of(world, scene_);
    mark_(stage, world, contacts);
    char caption[32];
    std::snprintf(caption, sizeof caption, "%.2f s", world.time);
    pictures_.push_back({renderer_.draw(stage), caption});
}

ClipProbe::ClipProbe(const Scene& scene, const std::filesystem::path& file, int frames_per_second, int width,
                     int height, FilmStyle style)
    : scene_(scene), renderer_(width, height), frames_per_second_(frames_per_second * style.slow_motion),
      style_(std::move(style)), clip_(file, frames_per_second)
{}

void ClipProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    if (world.time < frames_ / frames_per_second_ - dt / 2 || world.time > style_.until + dt / 2)
        return;
    Stage stage = stage_of(world, scene_);
    if (style_.mark)
        style_.mark(stage, world, contacts);
    clip_.add(renderer_.draw(stage));
    ++frames_;
}

}  // namespace enduring
