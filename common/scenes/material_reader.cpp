#include "common/scenes/material_reader.hpp"

#include "common/scenes/friction_reader.hpp"

#include <algorithm>
#include <cmath>

namespace enduring {
namespace {

constexpr std::size_t max_materials = 100, max_pairs = 5000;
const NumberRange coefficient_range{0, 10}, restitution_range{0, 1};

/// With one of the two given, mu_d follows where it must.
FrictionCoefficients read_coefficients(const JsonValue& value, const FrictionCoefficients& otherwise)
{
    FrictionCoefficients friction;
    friction.mu_s = value.number_or("mu_s", coefficient_range, otherwise.mu_s);
    friction.mu_d = value.number_or("mu_d", coefficient_range, std::min(otherwise.mu_d, friction.mu_s));
    if (friction.mu_d > friction.mu_s)
        value.complain(
            "\"mu_d\" is above \"mu_s\"; a body that slides is never held better than one at rest");
    friction.laws = read_surface_laws(value, otherwise.laws);
    return friction;
}

SceneMaterial read_material(const JsonValue& value, const SceneMaterials& before,
                            const ContactOfAll& of_scene)
{
    value.require_keys({"name", "density", "mu_s", "mu_d", "restitution", "viscous", "rolling", "patch"});
    SceneMaterial material{value.at("name").text()};
    if (std::any_of(before.begin(), before.end(),
                    [&](const SceneMaterial& one) { return one.name == material.name; }))
        value.at("name").complain("another material is already called \"" + material.name + "\"");
    if (const std::optional<JsonValue> density = value.find("density"))
        material.density = density->number({1e-3, 1e6, true, true, "kg/m^3"});
    material.friction = read_coefficients(value, of_scene.friction);
    material.restitution = value.number_or("restitution", restitution_range, of_scene.restitution);
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
double combined(double one, double other) { return std::sqrt(one * other); }
/// A film lies between both, and a patch or a torque against rolling comes from the one that gives more.
SurfaceLaws combined(const SurfaceLaws& one, const SurfaceLaws& other)
{
    return {std::max(one.viscous, other.viscous), std::max(one.rolling, other.rolling),
            std::max(one.patch, other.patch)};
}
//! [combined]

/// The tables where no pair is named.
MaterialTables combined_tables(const SceneMaterials& materials, const ContactOfAll& of_scene)
{
    MaterialTables tables;
    tables.friction.materials = tables.restitution.materials = static_cast<int>(materials.size());
    tables.restitution.between.clear();
    std::vector<ContactOfAll> all{of_scene};
    for (const SceneMaterial& material : materials)
        all.push_back({material.friction, material.restitution});
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < all.size(); ++j) {
            const ContactOfAll &one = all[i], &other = all[j];
            tables.friction.between.push_back(
                i == j ? one.friction
                       : FrictionCoefficients{combined(one.friction.mu_s, other.friction.mu_s),
                                              combined(one.friction.mu_d, other.friction.mu_d),
                                              combined(one.friction.laws, other.friction.laws)});
            tables.restitution.between.push_back(i == j ? one.restitution
                                                        : combined(one.restitution, other.restitution));
        }
    return tables;
}

void read_pair(const JsonValue& value, const SceneMaterials& materials, MaterialTables& tables,
               std::vector<std::pair<int, int>>& known)
{
    value.require_keys({"between", "mu_s", "mu_d", "restitution", "viscous", "rolling", "patch"});
    const std::vector<JsonValue> names = value.at("between").items(2, 2);
    const auto [one, other] = std::minmax({index_of(names[0], materials), index_of(names[1], materials)});
    if (std::find(known.begin(), known.end(), std::pair(one, other)) != known.end())
        value.at("between").complain("another entry has the same two materials");
    known.emplace_back(one, other);
    const FrictionCoefficients friction = read_coefficients(value, tables.friction.of(one, other));
    const double restitution = value.number_or("restitution", restitution_range,
                                               tables.restitution.of(one, other));
    for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
        tables.friction.between[static_cast<std::size_t>(tables.friction.place_of(from, to))] = friction;
        tables.restitution.between[tables.restitution.place_of(from, to)] = restitution;
    }
}

}  // namespace

SceneMaterials read_materials(const JsonValue& root, const ContactOfAll& of_scene, Mistakes& mistakes)
{
    SceneMaterials materials;
    if (const std::optional<JsonValue> list = root.find("materials"))
        for (const JsonValue& entry : list->items(0, max_materials))
            mistakes.gather([&] { materials.push_back(read_material(entry, materials, of_scene)); });
    return materials;
}

MaterialTables read_material_tables(const JsonValue& root, const SceneMaterials& materials,
                                    const ContactOfAll& of_scene, Mistakes& mistakes)
{
    MaterialTables tables = combined_tables(materials, of_scene);
    std::vector<std::pair<int, int>> known;
    if (const std::optional<JsonValue> list = root.find("material_pairs"))
        for (const JsonValue& entry : list->items(0, max_pairs))
            mistakes.gather([&] { read_pair(entry, materials, tables, known); });
    return tables;
}

int material_of(const JsonValue& entry, const SceneMaterials& materials)
{
    const std::optional<JsonValue> name = entry.find("material");
    return name ? index_of(*name, materials) : MaterialFriction::none;
}

}  // namespace enduring
