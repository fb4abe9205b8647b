#include "moments.hpp"

#include "common/render/scene_view.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace enduring::chapter03 {

Moments::Moments(const Scene& scene, std::vector<double> times, const ClipPlan& plan)
    : scene_(scene), times_(std::move(times)), large_(560, 400), small_(480, 344), pace_(plan.pace), clip_(plan.file, plan.pace)
{
}

void Moments::observe(const World& world, const Contacts& contacts, double dt)
{
    if (pictures_.size() < times_.size() && world.time >= times_[pictures_.size()] - dt / 2) {
        Stage stage = stage_of(world, scene_);
        Contacts pairs;  // a body's vertices in the ground would hide what this chapter is about
        std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(pairs),
                     [](const Contact& contact) { return contact.kind != ContactKind::vertex_plane; });
        mark_contacts(stage, world, pairs);
        char caption[32];
        std::snprintf(caption, sizeof caption, "%.2f s", world.time);
        pictures_.push_back({large_.draw(stage), caption});
    }
    if (world.time >= static_cast<double>(frames_) / pace_ - dt / 2) {
        clip_.add(small_.draw(stage_of(world, scene_)));
        ++frames_;
    }
}

void Moments::finish(const std::filesystem::path& strip_file)
{
    write_png(strip(pictures_, 3), strip_file);
    clip_.finish();
}

}  // namespace enduring::chapter03
