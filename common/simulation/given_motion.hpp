#pragma once

#include "common/geometry/vector.hpp"

#include <limits>
#include <optional>
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
        Vec3 velocity = Vec3::Zero(),
             turn_rate = Vec3::Zero();  ///< of the two, where they are given [m/s], [rad/s]
        bool gives_velocity = false, gives_turn_rate = false;
    };

    /// The same velocities for ever, and where the body was placed at time 0.
    /// @param velocity          of the centre [m/s]
    /// @param angular_velocity  in world axes [rad/s]
    static GivenMotion steady(const Vec3& velocity, const Vec3& angular_velocity);

    /// Through the rows of a table, at rest before the first and after the last of them.
    ///
    /// Each coordinate of displacement and turn is a cubic between two rows (Hermite). Its slope at a row is
    /// the one given there. If none is, it is that of the parabola through the row and its neighbours, no
    /// steeper than keeps the cubic between the values of its rows; at both ends it is zero. So velocities
    /// jump only at an end, and there only if one is given. The turn is interpolated as one vector, axis
    /// times angle: about one axis the angle follows the cubic.
    /// @throws std::invalid_argument  fewer than two rows, or times that do not ascend
    /// @see Hyman 1983, Accurate monotonicity preserving cubic interpolation; Fritsch and Carlson 1980
    static GivenMotion through(std::vector<Row> rows);

    /// At rest from this time on, where it has come to then [s].
    void end_at(double until) { until_ = until; }

    /// Where the velocity jumps, it is the one that follows.
    GivenPlace at(double time) const;

private:
    struct Slope {
        Vec3 displacement = Vec3::Zero(), turn = Vec3::Zero();
    };
    static std::vector<Slope> slopes_of(const std::vector<Row>& rows);

    GivenMotion() = default;
    GivenPlace moving_at(double time) const;

    Vec3 velocity_ = Vec3::Zero(), angular_velocity_ = Vec3::Zero();
    std::vector<Row> rows_;      ///< none: steady
    std::vector<Slope> slopes_;  ///< at each row, over time
    double until_ = std::numeric_limits<double>::infinity();
};

/// Of the parabola through three values, at the middle one, and for each coordinate no steeper than three
/// times the rise to either neighbour: the cubics through such rows go one way from row to row.
/// @param before, after  from one value to the next [s]
/// @return               over time [1/s]
Vec3 slope_between(const Vec3& first, const Vec3& middle, const Vec3& last, double before, double after);

struct ValueAndSlope {
    Vec3 value, slope;
};
/// The cubic with these values and slopes at the ends of an interval.
/// @param length  of the interval [s]
/// @param s       where on it, in [0, 1]
ValueAndSlope hermite(const Vec3& from, const Vec3& slope_from, const Vec3& to, const Vec3& slope_to,
                      double length, double s);

/// How fast the vector axis times angle of a body changes that has turned by it and has an angular velocity
/// [rad/s].
/// @return  none after about a whole turn, or several, for a body that turns about another axis: the vector
///     cannot follow
std::optional<Vec3> turn_rate(const Vec3& turn, const Vec3& angular_velocity);

}  // namespace enduring
