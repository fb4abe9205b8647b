#include "common/experiments/gltf/animation.hpp"

#include "common/experiments/gltf/gltf_file.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/input/input_error.hpp"
#include "common/input/pending_file.hpp"
#include "common/scenes/drawn_body.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/deforming_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace enduring {
namespace {

/// What takes a body from where its vertices were to where it is: a rigid body's own pose, else the turn and
/// shift that fit best.
Pose pose_of(const Body& body, const std::vector<Vec3>& vertices)
{
    if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body))
        return rigid->motion().pose();
    const auto count = static_cast<Eigen::Index>(vertices.size());
    const Eigen::Map<const Eigen::Matrix3Xd> from(vertices.front().data(), 3, count),
        to(body.positions_t0().front().data(), 3, count);
    const Eigen::Matrix4d found = Eigen::umeyama(from, to, false);
    return {found.topRightCorner<3, 1>(), Quaternion(Mat3(found.topLeftCorner<3, 3>()))};
}

/// q and -q are one turn; a viewer interpolates numbers, so neighbours have to be near each other.
void append_pose(std::vector<Pose>& poses, Pose pose)
{
    pose.orientation.normalize();
    if (!poses.empty() && poses.back().orientation.dot(pose.orientation) < 0)
        pose.orientation.coeffs() *= -1;
    poses.push_back(pose);
}

/// Every other frame goes, but never the last one.
template <class Frame>
void thin_out(std::vector<Frame>& frames)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (i % 2 == 0 || i + 1 == frames.size())
            std::swap(frames[kept++], frames[i]);
    frames.resize(kept);
}

void append_surface(GltfAnimation::Track& track, const Body& body, double time, int frame, std::size_t most)
{
    if (track.newest % track.stride != 0) {
        track.surfaces.pop_back();
        track.times.pop_back();
    }
    track.newest = frame;
    track.surfaces.push_back(drawn_points(body));
    track.times.push_back(time);
    if (track.surfaces.size() > most) {
        thin_out(track.surfaces);
        thin_out(track.times);
        track.stride *= 2;
    }
}

}  // namespace

GltfAnimation::GltfAnimation(const Scene& scene, std::filesystem::path file, const AnimationLimits& limits)
    : scene_(scene), file_(std::move(file)), limits_(limits)
{
    if (file_.extension() != ".glb")
        throw InputError("--gltf: '" + file_.string() + "' should end with .glb");
    require_gltf();
    require_writable(file_, "--gltf");
}

void GltfAnimation::begin(const World& world)
{
    const Stage stage = stage_of(world, scene_);
    planes_ = world.planes;
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
        const Body& body = *world.bodies[b];
        Track track{.faces = stage.bodies[b].faces, .color = stage.bodies[b].color, .name = body.name()};
        track.points = drawn_points(body);
        track.vertices.assign(body.positions_t0().begin(), body.positions_t0().end());
        track.closed = body.surface().is_closed() || body.surface().faces().empty();
        track.soft = dynamic_cast<const DeformableBody*>(&body) != nullptr ||
                     dynamic_cast<const DeformingBody*>(&body) != nullptr;
        track.moves = !body.is_static() || body.is_driven();
        if (const auto* const rigid = dynamic_cast<const RigidBody*>(&body))
            for (Vec3& point : track.points)
                point = rigid->motion().pose().to_body(point);
        tracks_.push_back(std::move(track));
    }
}

void GltfAnimation::observe(const World& world, const Contacts&, double dt)
{
    if (tracks_.empty())
        begin(world);
    if (frames_ > 0 && world.time + dt / 2 < tracks_.front().times.front() + frames_ * limits_.frame)
        return;
    for (std::size_t b = 0; b < tracks_.size(); ++b) {
        Track& track = tracks_[b];
        const Body& body = *world.bodies[b];
        if (track.soft) {
            append_surface(track, body, world.time, frames_, limits_.soft_frames);
        } else {
            track.times.push_back(world.time);
            append_pose(track.poses, pose_of(body, track.vertices));
        }
    }
    ++frames_;
}

void GltfAnimation::finish() const
{
    if (frames_ > 0)
        write_gltf(file_, tracks_, planes_);
}

}  // namespace enduring
