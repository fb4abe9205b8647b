#pragma once

#include "common/geometry/vector.hpp"

#include <vector>

namespace enduring {

/// How far a body has come by a given motion, and how fast it goes on.
struct GivenPlace {
    Vec3 displacement = Vec3::Zero();      ///< of the centre, from where it was placed [m]
    Vec3 turn = Vec3::Zero();              ///< about the centre: axis times angle [rad]
    Vec3 velocity = Vec3::Zero();          ///< of the centre [m/s]
    Vec3 angular_velocity = Vec3::Zero();  ///< in world axes [rad/s]

    Quaternion rotation() const
    {
        return Quaternion(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()));
    }
};

/// Where a body is at a time at which nothing asks what pushes it.
class GivenMotion {
public:
    struct Row {
        double time;        ///< [s]
        Vec3 displacement;  ///< [m]
        Vec3 turn;          ///< axis times angle, which may be more than a whole turn [rad]
    };

    /// The same velocities for ever, and where the body was placed at time 0.
    /// @param velocity          of the centre [m/s]
    /// @param angular_velocity  in world axes [rad/s]
    static GivenMotion steady(const Vec3& velocity, const Vec3& angular_velocity);

    /// Through the rows of a table, at rest before the first and after the last of them.
    ///
    /// Displacement and turn are cubic between two rows (Hermite): they have the rows' values, and as slope at an inner row
    /// that of the parabola through it and its neighbours; at both ends it is zero. So all velocities are continuous. The turn
    /// is interpolated as one vector, axis times angle: about one axis the angle follows the cubic.
    /// @throws std::invalid_argument  fewer than two rows, or times that do not ascend
    static GivenMotion through(std::vector<Row> rows);

    GivenPlace at(double time) const;

private:
    GivenMotion() = default;

    Vec3 velocity_ = Vec3::Zero(), angular_velocity_ = Vec3::Zero();
    std::vector<Row> rows_;    ///< none: steady
    std::vector<Row> slopes_;  ///< of displacement and turn at each row, over time
};

}  // namespace enduring
