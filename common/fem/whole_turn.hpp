#pragma once

#include "common/fem/elastic_mesh.hpp"
#include "common/geometry/vector.hpp"

#include <Eigen/SparseCore>

namespace enduring {

/// The turns of a whole body as it is now, v = omega x r with r from its centre of mass: what is to be kept
/// apart from deformation. In the mass matrix's product a field of velocities is the sum of its turn and a
/// rest without angular momentum.
class WholeTurn {
public:
    WholeTurn(const NodalVectors& positions, const Eigen::SparseMatrix<double>& mass_matrix);

    /// Angular momentum of velocities about the centre [kg m^2/s].
    Vec3 angular_momentum(const NodalVectors& v) const;
    /// Of forces (or impulses) about it [N m].
    Vec3 torque(const NodalVectors& forces) const;
    /// v += the turn that has this angular momentum.
    void add_turn(const Vec3& angular_momentum, NodalVectors& v) const;
    /// v without its turn.
    void remove_turn(NodalVectors& v) const { add_turn(-angular_momentum(v), v); }
    /// Without what turns the body: the transpose of remove_turn().
    void remove_torque(NodalVectors& forces) const;
    /// Velocities of a turn about an axis of the world [m], and the field whose product with velocities is
    /// how fast they turn about it [1/m].
    NodalVectors turn_about(int axis) const;
    NodalVectors share_of_turn(int axis) const;

private:
    NodalVectors levers_;       ///< r [m]
    NodalVectors mass_levers_;  ///< r M [kg m]
    Mat3 inverse_inertia_;      ///< zero about what has none
};

}  // namespace enduring
