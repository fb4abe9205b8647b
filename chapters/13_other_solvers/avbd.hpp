#pragma once

#include "chapters/13_other_solvers/avbd_rows.hpp"
#include "chapters/13_other_solvers/method_solver.hpp"
#include "chapters/13_other_solvers/soft_elements.hpp"

#include <map>
#include <vector>

namespace enduring {

/// Augmented vertex block descent: one rigid body after the other goes to the minimum of its own energy, six
/// coordinates at a time, and one node of a soft body after the other, three at a time, as if all others
/// stayed; behind each sweep the multipliers of all contacts follow.
/// @see Giles, Diaz, Yuksel 2025; Chen et al. 2024, "Vertex block descent", for soft bodies
class Avbd {
public:
    explicit Avbd(const AvbdSettings& settings) : settings_(settings) {}
    /// @param step  changed in place
    void operator()(MethodStep& step);

private:
    /// What pulls at a coordinate block: the rows, and the elements of a node.
    struct Around;
    std::vector<AvbdRow> rows_of(const MethodStep& step) const;
    void guess(MethodStep& step);
    static void solve_body(MethodStep& step, std::size_t body, const Pose& inertial,
                           const std::vector<const AvbdRow*>& rows);
    static void solve_node(MethodStep& step, std::size_t node, const Vec3& inertial, const Around& around);
    void keep(MethodStep& step, const std::vector<AvbdRow>& rows);

    /// Of a pair, from step to step.
    struct Kept {
        Vec3 stiffness;  ///< of its three rows [N/m]
        Vec3 slip;       ///< from where friction holds it, along the surface, in the axes of A [m]
    };

    AvbdSettings settings_;
    std::map<PairKey, Kept> kept_;
    std::vector<Vec3> velocities_;       ///< when the last step began [m/s]
    std::vector<Vec3> node_velocities_;  ///< the same of nodes
};

Solver chapter13_avbd_solver(const ContactParameters& parameters, const AvbdSettings& settings = {});

}  // namespace enduring
