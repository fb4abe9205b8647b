#include "common/experiments/own_scene/replay.hpp"

#include "common/experiments/report/report.hpp"
#include "common/scenes/drawn_body.hpp"
#include "common/scenes/shown_scene.hpp"
#include "common/simulation/rigid_body.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

namespace enduring {
namespace {

using Floats = std::vector<float>;

void append(Floats& list, const Vec3& v)
{
    for (const double coordinate : v)
        list.push_back(static_cast<float>(coordinate));
}

/// Zeros follow up to a multiple of three numbers: 12 bytes are 16 letters, so no letter stands for a part of
/// a byte.
std::string base64(Floats numbers)
{
    using namespace boost::archive::iterators;
    using Letters = base64_from_binary<transform_width<const char*, 6, 8>>;
    numbers.resize((numbers.size() + 2) / 3 * 3);
    const auto* const bytes = reinterpret_cast<const char*>(numbers.data());
    return {Letters(bytes), Letters(bytes + numbers.size() * sizeof(float))};
}

/// In its own coordinates, if it is rigid.
std::string points_of(const Body& body)
{
    Floats points;
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    for (const Vec3& point : drawn_points(body))
        append(points, rigid ? rigid->motion().pose().to_body(point) : point);
    return base64(std::move(points));
}

std::string motion_of(const World& world)
{
    Floats list;
    for (const auto& body : world.bodies) {
        if (rests(*body))
            continue;
        if (const auto* const rigid = dynamic_cast<const RigidBody*>(body.get())) {
            const Pose pose = rigid->motion().pose();
            append(list, pose.position);
            append(list, pose.orientation.vec());
            list.push_back(static_cast<float>(pose.orientation.w()));
        } else {
            for (const Vec3& x : drawn_points(*body))
                append(list, x);
        }
    }
    return base64(std::move(list));
}

std::string pairs_of(const World& world, const Contacts& contacts)
{
    Floats list;
    list.reserve(contacts.size() * std::tuple_size_v<PairNumbers>);
    for (const Contact& contact : contacts)
        for (const double number : pair_numbers(world, contact))
            list.push_back(static_cast<float>(number));
    return base64(std::move(list));
}

std::string joints_of(const World& world)
{
    const std::vector<double> numbers = joint_numbers(world);
    return base64(Floats(numbers.begin(), numbers.end()));
}

}  // namespace

Replay::Replay(const Scene& scene, std::string solver, std::size_t most)
    : scene_(scene), solver_(std::move(solver)), most_(most)
{}

void Replay::begin(const World& world)
{
    nlohmann::json shown = shown_scene(scene_, world, solver_);
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        shown["bodies"][i]["points"] = points_of(*world.bodies[i]);
    described_ = line_of(shown);
}

void Replay::observe(const World& world, const Contacts& contacts, double)
{
    if (frames_.empty())
        begin(world);
    const auto size_of = [](const Frame& frame) {
        return frame.motion.size() + frame.pairs.size() + frame.joints.size();
    };
    if (newest_ % stride_ != 0) {  // only the run's last frame may lie between the others
        bytes_ -= size_of(frames_.back());
        frames_.pop_back();
    }
    newest_ = seen_++;
    frames_.push_back({line_of(shown_numbers(step_numbers(world, contacts))), motion_of(world),
                       pairs_of(world, contacts), joints_of(world)});
    bytes_ += size_of(frames_.back());
    while (bytes_ > most_ && frames_.size() > 2) {
        thin_out();
        bytes_ = 0;
        for (const Frame& frame : frames_)
            bytes_ += size_of(frame);
    }
}

/// Every other frame goes, but never the newest one.
void Replay::thin_out()
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < frames_.size(); ++i)
        if (i % 2 == 0 || i + 1 == frames_.size())
            std::swap(frames_[kept++], frames_[i]);
    frames_.resize(kept);
    stride_ *= 2;
}

void Replay::write(const std::filesystem::path& file) const
{
    std::string text = "{\"replay\": 1, \"scene\": " + described_ + ",\n\"frames\": [";
    const char* between = "\n";
    for (const Frame& frame : frames_) {
        text += between + ("{\"numbers\": " + frame.numbers) + ", \"motion\": \"" + frame.motion +
                "\", \"pairs\": \"" + frame.pairs + "\"" +
                (frame.joints.empty() ? "" : ", \"joints\": \"" + frame.joints + "\"") + "}";
        between = ",\n";
    }
    write_file(file, text + "]}\n");
}

}  // namespace enduring
