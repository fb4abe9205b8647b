#pragma once

#include "common/scenes/scene.hpp"

#include <string>
#include <vector>

namespace enduring::chapter08 {

/// One body comes down on another one that is held, from a centimetre above it, and with nothing below: what
/// does not stay falls out of reach.
struct RidgePlan {
    enum class Kind { ridges, box_edges, tetrahedron, border };
    std::string name;
    Kind kind;
    /// Of ridges and edges, the angle between them [deg]; of a tetrahedron what is below: 0 a side, 1 an
    /// edge, 2 a corner.
    double which = 0;
    double aside = 0;  ///< by which its middle lies beside; of a border, beyond it [m]
};
/// Ridge on ridge at several angles, box edges, a tetrahedron's corner on a side, an edge and a corner, and
/// boxes over the border of an open sheet of two triangles.
std::vector<RidgePlan> ridge_plans();

/// The held body, then the other one; friction 0.5.
Scene ridge_scene(const RidgePlan& plan, double dt);

/// Whether the body is still on the other one: it has not fallen by its size.
bool is_held(const Scene& scene);

}  // namespace enduring::chapter08
