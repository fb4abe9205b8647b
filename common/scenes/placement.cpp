#include "common/scenes/placement.hpp"

namespace enduring {

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
        rotation->require_keys({"axis", "angle_deg"});
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
        return mass->number({1e-9, 1e9, true, true, "kg"});
    const int material = material_of(body, materials);
    if (!density && material != MaterialFriction::none)
        if (const auto of_material = materials[static_cast<std::size_t>(material)].density)
            return *of_material * volume;
    if (!density)
        body.complain("one of the keys \"density\" and \"mass\" is missing");
    return density->number({1e-3, 1e6, true, true, "kg/m^3"}) * volume;
}

}  // namespace enduring
