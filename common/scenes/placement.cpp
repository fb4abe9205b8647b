#include "common/scenes/placement.hpp"

#include <algorithm>
#include <array>

namespace enduring {
namespace {

/// [w, x, y, z], of any length.
Quaternion read_quaternion(const JsonValue& rotation, const JsonValue& value)
{
    if (rotation.find("axis") || rotation.find("angle_deg"))
        value.complain("stands beside \"axis\" or \"angle_deg\"; one of the two ways is enough");
    std::array<double, 4> q{};
    const std::vector<JsonValue> items = value.items(4, 4);
    std::transform(items.begin(), items.end(), q.begin(), [](const JsonValue& item) {
        return item.number({-1e4, 1e4});
    });
    const Quaternion quaternion(q[0], q[1], q[2], q[3]);
    if (!(quaternion.norm() > 1e-9))
        value.fail("four numbers that are not all zero");
    return quaternion.normalized();
}

}  // namespace

std::vector<Vec3> Placement::place(const std::vector<Vec3>& points) const
{
    std::vector<Vec3> placed;
    placed.reserve(points.size());
    for (const Vec3& point : points)
        placed.push_back(place(point));
    return placed;
}

Placement read_placement(const JsonValue& body)
{
    Placement placement;
    placement.position = body.vector_or("position", {-1e4, 1e4, true, true, "m"}, Vec3::Zero());
    if (const std::optional<JsonValue> rotation = body.find("rotation")) {
        rotation->require_keys({"axis", "angle_deg", "quaternion"});
        if (const std::optional<JsonValue> quaternion = rotation->find("quaternion")) {
            placement.rotation = read_quaternion(*rotation, *quaternion);
            return placement;
        }
        placement.rotation = Eigen::AngleAxisd(rotation->at("angle_deg").angle({-360, 360}),
                                               rotation->at("axis").direction());
    }
    return placement;
}

InitialMotion read_motion(const JsonValue& body)
{
    InitialMotion motion;
    motion.velocity = body.vector_or("velocity", {-1e4, 1e4, true, true, "m/s"}, Vec3::Zero());
    motion.angular_velocity = body.vector_or("angular_velocity", {-1e4, 1e4, true, true, "rad/s"},
                                             Vec3::Zero());
    return motion;
}

double read_mass(const JsonValue& body, double volume, const SceneMaterials& materials)
{
    const std::optional<JsonValue> density = body.find("density"), mass = body.find("mass");
    if (density && mass)
        mass->complain("stands beside \"density\"; one of the two is enough");
    if (mass)
        return mass->number(mass_range);
    const int material = material_of(body, materials);
    if (!density && material != MaterialFriction::none)
        if (const auto of_material = materials[static_cast<std::size_t>(material)].density)
            return *of_material * volume;
    if (!density)
        body.complain("one of the keys \"density\" and \"mass\" is missing");
    return density->number({1e-3, 1e6, true, true, "kg/m^3"}) * volume;
}

}  // namespace enduring
