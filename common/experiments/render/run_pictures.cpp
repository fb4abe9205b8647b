#include "common/experiments/render/run_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace enduring {
namespace {

struct Size {
    int width, height;  ///< [px]
    double aspect() const { return static_cast<double>(width) / height; }
};
constexpr Size of_picture{560, 400}, of_film{480, 344};

/// A static body is part of the picture unless it is so many times larger than all that moves: then it is
/// ground.
constexpr double largest_part = 3;

Eigen::AlignedBox3d box_around(const std::vector<Vec3>& points)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    return box;
}

void add_finite(std::vector<Vec3>& points, const std::vector<Vec3>& more)
{
    std::copy_if(more.begin(), more.end(), std::back_inserter(points),
                 [](const Vec3& point) { return point.allFinite(); });
}

}  // namespace

RunPictures::RunPictures(const Scene& scene, Shown shown)
    : scene_(scene), shown_(std::move(shown)), begin_(scene.world.time),
      frame_time_(std::max({1.0 / frames_per_second, scene.dt, (scene.duration - begin_) / (max_frames - 1)}))
{}

void RunPictures::observe(const World& world, const Contacts& contacts, double dt)
{
    const double next_picture = begin_ + (scene_.duration - begin_) * static_cast<double>(moments_.size()) /
                                             std::max(1, shown_.pictures - 1),
                 next_frame = begin_ + frame_time_ * static_cast<double>(frames_.size());
    if (static_cast<int>(moments_.size()) < shown_.pictures && world.time >= next_picture - dt / 2) {
        moments_.push_back({world.time, stage_of(world, scene_)});
        shown_.mark(moments_.back().stage, world, contacts);
    }
    if (shown_.filmed && world.time >= next_frame - dt / 2) {
        Positions now;
        for (const auto& body : world.bodies)
            now.emplace_back(body->positions_t0().begin(), body->positions_t0().end());
        frames_.push_back(std::move(now));
    }
}

Camera RunPictures::camera() const
{
    const Camera of_scene = stage_of(scene_.world, scene_).camera;
    if (scene_.camera_given || moments_.empty())
        return of_scene;
    std::vector<Vec3> moving, standing;
    for (std::size_t i = 0; i < scene_.world.bodies.size(); ++i) {
        std::vector<Vec3>& points = scene_.world.bodies[i]->is_static() ? standing : moving;
        for (const Moment& moment : moments_)
            add_finite(points, moment.stage.bodies[i].positions);
        for (const Positions& frame : frames_)
            add_finite(points, frame[i]);
    }
    const double reach = largest_part * box_around(moving).diagonal().norm();
    if (moving.empty() || box_around(standing).diagonal().norm() <= reach)
        moving.insert(moving.end(), standing.begin(), standing.end());
    const double aspect = std::min(of_picture.aspect(), of_film.aspect());
    return frame(moving, of_scene.eye - of_scene.target, aspect, 0.08, of_scene.field_of_view_deg);
}

Picture RunPictures::strip_of_all(int columns) const
{
    Renderer renderer(of_picture.width, of_picture.height);
    const Camera from = camera();
    std::vector<StripPicture> pictures;
    for (const auto& [time, stage] : moments_) {
        Stage shown = stage;
        shown.camera = from;
        char caption[32];
        std::snprintf(caption, sizeof caption, "%.2f s", time);
        pictures.push_back({renderer.draw(shown), caption});
    }
    return strip(pictures, columns);
}

void RunPictures::write_film(const std::filesystem::path& file) const
{
    const bool faster = frame_time_ > std::max(1.0 / frames_per_second, scene_.dt);
    const double pace = faster ? frames_per_second : std::round(1 / frame_time_);
    Clip clip(file, std::clamp(static_cast<int>(pace), 1, frames_per_second));
    Renderer renderer(of_film.width, of_film.height);
    Stage stage = stage_of(scene_.world, scene_);
    stage.camera = camera();
    for (const Positions& frame : frames_) {
        for (std::size_t i = 0; i < frame.size(); ++i)
            stage.bodies[i].positions = frame[i];
        clip.add(renderer.draw(stage));
    }
    clip.finish();
}

}  // namespace enduring
