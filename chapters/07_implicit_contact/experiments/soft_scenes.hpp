#pragma once

#include "common/scenes/scene.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace enduring::chapter07 {

/// A rigid cube of a ton and 80 cm lies on a soft cube of 1 m.
struct LoadedBlock {
    double mass = 100;   ///< of the soft cube [kg]
    double young = 1e6;  ///< [Pa]
    int cells = 3;       ///< along each edge
};
Scene ton_on_block(const LoadedBlock& block, double dt);

/// Rayleigh's damping of a soft cube, of its stiffness [s].
inline constexpr double soft_damping = 0.01;

/// A soft cube of 1 m.
struct SoftCube {
    int cells;  ///< along each edge
    double young, dt, mass;
};
/// It lies on triangles that fall by 10 degrees towards -x.
/// @param mu  of its friction; the stiffness is nobody's choice
Scene soft_cube_on_triangles(const SoftCube& cube, double mu);

/// A thin mat of quadratic elements above the ground, 4 cm thick.
/// @param width   of its sides [m]
/// @param cells   along each side
/// @param change  of its body, in JSON
Scene falling_mat(double width, int cells, const nlohmann::json& change);

/// Soft bunnies fall into the bowl of common/scenes/bunny_at_rest.json, one after the other.
struct Bunnies {
    int count = 1;
    int elements = 363;            ///< of each, as in common/meshes
    std::string basis = "linear";  ///< or "quadratic"
    double young = 1e6;            ///< [Pa]
};
Scene bunnies_in_bowl(const Bunnies& bunnies, double dt);

}  // namespace enduring::chapter07
