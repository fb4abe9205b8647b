#pragma once

#include "common/input/json_value.hpp"
#include "common/input/mistakes.hpp"
#include "common/simulation/material_friction.hpp"
#include "common/simulation/material_restitution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace enduring {

/// One entry of a scene's "materials".
struct SceneMaterial {
    std::string name;
    std::optional<double> density{};  ///< [kg/m^3]
    FrictionCoefficients friction{};  ///< against the same material
    double restitution = 0;           ///< the same
};

using SceneMaterials = std::vector<SceneMaterial>;

/// What a scene's contact says, for what a material leaves out and for what has none.
struct ContactOfAll {
    FrictionCoefficients friction;
    double restitution = 0;
};

/// The list "materials" of a scene; empty if there is none.
SceneMaterials read_materials(const JsonValue& root, const ContactOfAll& of_scene, Mistakes& mistakes);

/// Coefficients between each two of the materials, and with what has none.
struct MaterialTables {
    MaterialFriction friction;
    MaterialRestitution restitution;
};

/// Those of the list "material_pairs", else the geometric mean of what both have.
MaterialTables read_material_tables(const JsonValue& root, const SceneMaterials& materials,
                                    const ContactOfAll& of_scene, Mistakes& mistakes);

/// The material that a body or plane names, or MaterialFriction::none.
/// @throws InputError  there is no such material
int material_of(const JsonValue& entry, const SceneMaterials& materials);

}  // namespace enduring
