#include "common/scenes/shown_scene.hpp"

#include "common/scenes/drawn_body.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/joint.hpp"
#include "common/simulation/rigid_body.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace enduring {
namespace {

nlohmann::json coordinates(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

nlohmann::json shown_body(const Scene& scene, const Body& body)
{
    const auto look = scene.looks.find(body.name());
    const BodyLook shown = look == scene.looks.end() ? BodyLook{} : look->second;
    nlohmann::json faces = nlohmann::json::array();
    for (const Face& face : drawn_faces(body))
        for (const int corner : face)
            faces.push_back(corner);
    const bool rigid = dynamic_cast<const RigidBody*>(&body) != nullptr;
    return {{"name", body.name()},
            {"kind", rests(body) ? "rests"
                     : rigid     ? "rigid"
                                 : "free"},
            {"still", body.is_static()},
            {"mass", body.mass()},
            {"faces", faces},
            {"vertices", drawn_points(body).size()},
            {"colour", coordinates(shown.color)},
            {"smooth", shown.smooth}};
}

}  // namespace

bool rests(const Body& body) { return body.is_static() && !body.is_driven(); }

StepNumbers step_numbers(const World& world, const Contacts& contacts)
{
    const Energy energy = total_energy(world);
    StepNumbers numbers{world.time,           world.step,     energy.kinetic,
                        energy.gravitational, energy.elastic, spring_energy(contacts)};
    for (const Contact& contact : contacts)
        if (contact.is_spring()) {
            numbers.depth = std::max(numbers.depth, -contact_geometry(world, contact, 1).depth);
            numbers.pairs += contact.impulse.isZero() ? 0 : 1;
        }
    numbers.thrown_away = world.thrown_away;
    numbers.ended_badly = world.ended_badly;
    numbers.work = world.work;
    return numbers;
}

nlohmann::json shown_numbers(const StepNumbers& numbers)
{
    nlohmann::json work;
    visit_work(numbers.work, [&](const char* name, auto value) { work[name] = value; });
    return {{"time", numbers.time},
            {"step", numbers.step},
            {"kinetic", numbers.kinetic},
            {"gravitational", numbers.gravitational},
            {"elastic", numbers.elastic},
            {"springs", numbers.springs},
            {"depth", numbers.depth},
            {"pairs", numbers.pairs},
            {"thrown_away", numbers.thrown_away},
            {"ended_badly", numbers.ended_badly},
            {"work", std::move(work)}};
}

PairNumbers pair_numbers(const World& world, const Contact& contact, int since)
{
    const ContactGeometry at = contact_geometry(world, contact, 1);
    const Vec3 &p = at.p, &n = at.normal, &i = contact.impulse, &f = contact.friction;
    const auto number = [](auto value) { return static_cast<double>(value); };
    // clang-format off
    return {number(contact.kind), number(contact.body_a), number(contact.body_b), number(contact.feature_a), number(contact.feature_b),
            p.x(), p.y(), p.z(), n.x(), n.y(), n.z(), at.depth,
            i.x(), i.y(), i.z(), f.x(), f.y(), f.z(),
            contact.spring.stiffness, contact.spring.rest_offset, contact.spring.load, contact.spring.slip, number(contact.is_spring()), number(since)};
    // clang-format on
}

std::vector<double> joint_numbers(const World& world)
{
    std::vector<double> numbers;
    for (const Joint& joint : world.joints) {
        if (joint.broken || joint.kind == JointKind::gear)
            continue;
        const JointPose pose = committed_pose(world, joint);
        const bool has_axis = joint.kind == JointKind::hinge || joint.kind == JointKind::slider ||
                              joint.kind == JointKind::cylinder;
        const Vec3 axis = has_axis ? Vec3(pose.axes_b.col(2)) : Vec3(Vec3::Zero());
        for (const Vec3& v : {pose.point_a, pose.point_b, axis})
            numbers.insert(numbers.end(), v.begin(), v.end());
    }
    return numbers;
}

nlohmann::json shown_scene(const Scene& scene, const World& world, const std::string& solver)
{
    nlohmann::json bodies = nlohmann::json::array(), planes = nlohmann::json::array();
    for (const auto& body : world.bodies)
        bodies.push_back(shown_body(scene, *body));
    for (const Plane& plane : world.planes)
        planes.push_back({{"name", plane.name},
                          {"point", coordinates(plane.point)},
                          {"normal", coordinates(plane.normal)}});
    return {{"name", scene.name},
            {"description", scene.description},
            {"dt", scene.dt},
            {"duration", scene.duration},
            {"bodies", bodies},
            {"planes", planes},
            {"warnings", scene.warnings},
            {"camera_given", scene.camera_given},
            {"eye", coordinates(scene.camera.eye)},
            {"target", coordinates(scene.camera.target)},
            {"field_of_view", scene.camera.field_of_view_deg},
            {"solver", solver}};
}

std::string line_of(const nlohmann::json& shown)
{
    return shown.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace enduring
