#include "common/experiments/render/moments.hpp"

#include <cstdio>
#include <utility>

namespace enduring {
namespace {

constexpr double margin = 0.05;  ///< free share of a picture on each side

}  // namespace

MomentsProbe::MomentsProbe(const Scene& scene, std::vector<double> times, MarkContacts mark,
                           std::string caption)
    : scene_(scene), times_(std::move(times)), mark_(std::move(mark)), caption_(std::move(caption))
{}

void MomentsProbe::observe(const World& world, const Contacts& contacts, double dt)
{
    if (moments_.size() == times_.size() || world.time < times_[moments_.size()] - dt / 2)
        return;
    Stage stage = stage_of(world, scene_);
    if (mark_)
        mark_(stage, world, contacts);
    char time[32];
    std::snprintf(time, sizeof time, "%.2f s", world.time);
    moments_.push_back({std::move(stage), caption_ + time});
}

void frame_together(std::vector<Moment>& moments, const Vec3& towards, double aspect)
{
    std::vector<Vec3> points;
    for (const Moment& moment : moments)
        for (const Vec3& point : points_of(moment.stage))
            points.push_back(point);
    const Camera camera = frame(points, towards, aspect, margin);
    for (Moment& moment : moments)
        moment.stage.camera = camera;
}

void frame_each(std::vector<Moment>& moments, const Vec3& towards, double aspect)
{
    for (Moment& moment : moments)
        moment.stage.camera = frame(points_of(moment.stage), towards, aspect, margin);
}

Picture draw_moments(const std::vector<Moment>& moments, int columns, int width, int height)
{
    Renderer renderer(width, height);
    std::vector<StripPicture> pictures;
    for (const Moment& moment : moments)
        pictures.push_back({renderer.draw(moment.stage), moment.caption});
    return strip(pictures, columns);
}

}  // namespace enduring
