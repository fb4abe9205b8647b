#include "common/scenes/material_reader.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

constexpr std::size_t max_materials = 100, max_pairs = 5000;
const NumberRange coefficient_range{0, 10};

/// With one of the two given, mu_d follows where it must.
FrictionCoefficients read_coefficients(const JsonValue& value, const FrictionCoefficients& otherwise)
{
    FrictionCoefficients friction;
    friction.mu_s = value.number_or("mu_s", coefficient_range, otherwise.mu_s);
    friction.mu_d = value.number_or("mu_d", coefficient_range, std::min(otherwise.mu_d, friction.mu_s));
    if (friction.mu_d > friction.mu_s)
        value.complain(
            "\"mu_d\" is above \"mu_s\"; a body that slides is never held better than one at rest");
    return friction;
}

SceneMaterial read_material(const JsonValue& value, const SceneMaterials& before,
                            const FrictionCoefficients& of_scene)
{
    value.require_keys({"name", "density", "mu_s", "mu_d"});
    SceneMaterial material{value.at("name").text()};
    if (std::any_of(before.begin(), before.end(),
                    [&](const SceneMaterial& one) { return one.name == material.name; }))
        value.at("name").complain("another material is already called \"" + material.name + "\"");
    if (const std::optional<JsonValue> density = value.find("density"))
        material.density = density->number({1e-3, 1e6, true, true, "kg/m^3"});
    material.friction = read_coefficients(value, of_scene);
    return material;
}

int index_of(const JsonValue& name, const SceneMaterials& materials)
{
    const std::string wanted = name.text();
    const auto found = std::find_if(materials.begin(), materials.end(),
                                    [&](const SceneMaterial& one) { return one.name == wanted; });
    if (found == materials.end())
        name.complain("there is no material \"" + wanted + "\" in \"materials\"");
    return static_cast<int>(found - materials.begin());
}

//! [combined]
/// Of two materials that no pair names: the geometric mean of what each has against itself.
FrictionCoefficients combined(const FrictionCoefficients& one, const FrictionCoefficients& other)
{
    return {std::sqrt(one.mu_s * other.mu_s), std::sqrt(one.mu_d * other.mu_d)};
}
//! [combined]

FrictionCoefficients& place_in(MaterialFriction& friction, int one, int other)
{
    return friction.between[static_cast<std::size_t>(friction.place_of(one, other))];
}

void read_pair(const JsonValue& value, const SceneMaterials& materials, MaterialFriction& friction,
               std::vector<std::pair<int, int>>& known)
{
    value.require_keys({"between", "mu_s", "mu_d"});
    const std::vector<JsonValue> names = value.at("between").items(2, 2);
    const auto [one, other] = std::minmax({index_of(names[0], materials), index_of(names[1], materials)});
    if (std::find(known.begin(), known.end(), std::pair(one, other)) != known.end())
        value.at("between").complain("another entry has the same two materials");
    known.emplace_back(one, other);
    const FrictionCoefficients given = read_coefficients(value, friction.of(one, other));
    place_in(friction, one, other) = place_in(friction, other, one) = given;
}

}  // namespace

SceneMaterials read_materials(const JsonValue& root, const FrictionCoefficients& of_scene, Mistakes& mistakes)
{
    SceneMaterials materials;
    if (const std::optional<JsonValue> list = root.find("materials"))
        for (const JsonValue& entry : list->items(0, max_materials))
            mistakes.gather([&] { materials.push_back(read_material(entry, materials, of_scene)); });
    return materials;
}

MaterialFriction read_material_friction(const JsonValue& root, const SceneMaterials& materials,
                                        const FrictionCoefficients& of_scene, Mistakes& mistakes)
{
    MaterialFriction friction;
    friction.materials = static_cast<int>(materials.size());
    const int first = MaterialFriction::none;
    const auto of = [&](int material) {
        return material == first ? of_scene : materials[static_cast<std::size_t>(material)].friction;
    };
    for (int one = first; one < friction.materials; ++one)
        for (int other = first; other < friction.materials; ++other)
            friction.between.push_back(one == other ? of(one) : combined(of(one), of(other)));
    std::vector<std::pair<int, int>> known;
    if (const std::optional<JsonValue> list = root.find("material_pairs"))
        for (const JsonValue& entry : list->items(0, max_pairs))
            mistakes.gather([&] { read_pair(entry, materials, friction, known); });
    return friction;
}

int material_of(const JsonValue& entry, const SceneMaterials& materials)
{
    const std::optional<JsonValue> name = entry.find("material");
    return name ? index_of(*name, materials) : MaterialFriction::none;
}

}  // namespace enduring
