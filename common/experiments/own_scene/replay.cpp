#include "common/experiments/own_scene/replay.hpp"

#include "common/experiments/report/report.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <utility>

namespace enduring {
namespace {

using nlohmann::json;
using Floats = std::vector<float>;

void append(Floats& list, std::initializer_list<double> numbers)
{
    for (const double number : numbers)
        list.push_back(static_cast<float>(number));
}

void append(Floats& list, const Vec3& v) { append(list, {v.x(), v.y(), v.z()}); }

/// https://datatracker.ietf.org/doc/html/rfc4648#section-4
std::string base64(const Floats& numbers)
{
    constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes(numbers.size() * sizeof(float));
    if (!bytes.empty())
        std::memcpy(bytes.data(), numbers.data(), bytes.size());
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8U | (i + k < bytes.size() ? bytes[i + k] : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

bool rests(const Body& body) { return body.is_static() && !body.is_driven(); }

json triple(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

json described(const Scene& scene, const Body& body)
{
    Floats points, faces;
    const auto* const rigid = dynamic_cast<const RigidBody*>(&body);
    for (const Vec3& point : body.positions_t0())
        append(points, rigid ? rigid->motion().pose().to_body(point) : point);
    for (const Face& face : body.surface().faces())
        for (const int corner : face)
            append(faces, {static_cast<double>(corner)});
    const auto look = scene.looks.find(body.name());
    const BodyLook shown = look == scene.looks.end() ? BodyLook{} : look->second;
    return {{"name", body.name()},    {"kind", rests(body) ? "rests" : rigid ? "rigid" : "free"},
            {"mass", body.mass()},    {"points", base64(points)},
            {"faces", base64(faces)}, {"colour", triple(shown.color)},
            {"smooth", shown.smooth}};
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
            append(list,
                   {pose.orientation.x(), pose.orientation.y(), pose.orientation.z(), pose.orientation.w()});
        } else {
            for (const Vec3& x : body->positions_t0())
                append(list, x);
        }
    }
    return base64(list);
}

/// What live/lab/pairs.js reads; -1 where the laboratory has the step in which a pair's features met.
std::string pairs_of(const World& world, const Contacts& contacts)
{
    Floats list;
    for (const Contact& contact : contacts) {
        const ContactGeometry at = contact_geometry(world, contact, 1);
        append(list, {static_cast<double>(contact.kind), static_cast<double>(contact.body_a),
                      static_cast<double>(contact.body_b), static_cast<double>(contact.feature_a),
                      static_cast<double>(contact.feature_b)});
        append(list, at.p);
        append(list, at.normal);
        append(list, {at.depth});
        append(list, contact.impulse);
        append(list, contact.friction);
        append(list, {contact.stiffness, contact.rest_offset, contact.load, contact.slip,
                      contact.is_spring() ? 1.0 : 0.0, -1.0});
    }
    return base64(list);
}

std::string numbers_of(const World& world, const Contacts& contacts)
{
    const Energy energy = total_energy(world);
    double depth = 0;
    int pushing = 0;
    for (const Contact& contact : contacts)
        if (contact.is_spring()) {
            depth = std::max(depth, -contact_geometry(world, contact, 1).depth);
            pushing += contact.impulse.isZero() ? 0 : 1;
        }
    return json{{"time", world.time},
                {"step", world.step},
                {"kinetic", energy.kinetic},
                {"gravitational", energy.gravitational},
                {"elastic", energy.elastic},
                {"springs", spring_energy(contacts)},
                {"depth", depth},
                {"pairs", pushing},
                {"thrown_away", world.thrown_away},
                {"ended_badly", world.ended_badly}}
        .dump();
}

}  // namespace

Replay::Replay(const Scene& scene, std::string solver, std::size_t most)
    : scene_(scene), solver_(std::move(solver)), most_(most)
{}

void Replay::begin(const World& world)
{
    json bodies = json::array(), planes = json::array();
    for (const auto& body : world.bodies)
        bodies.push_back(described(scene_, *body));
    for (const Plane& plane : world.planes)
        planes.push_back(
            {{"name", plane.name}, {"point", triple(plane.point)}, {"normal", triple(plane.normal)}});
    described_ = json{
        {"name", scene_.name},
        {"description", scene_.description},
        {"dt", scene_.dt},
        {"duration", scene_.duration},
        {"bodies", bodies},
        {"planes", planes},
        {"camera_given", scene_.camera_given},
        {"eye", triple(scene_.camera.eye)},
        {"target", triple(scene_.camera.target)},
        {"field_of_view", scene_.camera.field_of_view_deg},
        {"solver",
         solver_}}.dump(-1, ' ', false, json::error_handler_t::replace);
}

void Replay::observe(const World& world, const Contacts& contacts, double)
{
    if (frames_.empty())
        begin(world);
    const auto size_of = [](const Frame& frame) { return frame.motion.size() + frame.pairs.size(); };
    if (newest_ % stride_ != 0) {  // only the run's last frame may lie between the others
        bytes_ -= size_of(frames_.back());
        frames_.pop_back();
    }
    newest_ = seen_++;
    frames_.push_back({numbers_of(world, contacts), motion_of(world), pairs_of(world, contacts)});
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
                "\", \"pairs\": \"" + frame.pairs + "\"}";
        between = ",\n";
    }
    write_file(file, text + "]}\n");
}

}  // namespace enduring
