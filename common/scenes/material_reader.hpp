#pragma once

#include "common/input/json_value.hpp"
#include "common/input/mistakes.hpp"
#include "common/simulation/material_friction.hpp"

#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// One entry of a scene's "materials".
struct SceneMaterial {
    std::string name;
    std::optional<double> density{};  ///< [kg/m^3]
    FrictionCoefficients friction{};  ///< against the same material
};

using SceneMaterials = std::vector<SceneMaterial>;

/// The list "materials" of a scene; empty if there is none.
/// @param of_scene  coefficients of contact, for what a material leaves out
SceneMaterials read_materials(const JsonValue& root, const FrictionCoefficients& of_scene,
                              Mistakes& mistakes);

/// Coefficients between each two of the materials, and with what has none: those of the list "material_pairs", else the geometric
/// mean of what both have.
MaterialFriction read_material_friction(const JsonValue& root, const SceneMaterials& materials,
                                        const FrictionCoefficients& of_scene, Mistakes& mistakes);

/// The material that a body or plane names, or MaterialFriction::none.
/// @throws InputError  there is no such material
int material_of(const JsonValue& entry, const SceneMaterials& materials);

}  // namespace enduring
