#pragma once

#include "common/geometry/vector.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// A vector that is the same at all times, or given at some times and linear between them; zero before the
/// first of these and after the last.
class TimedVector {
public:
    struct Row {
        double time;  ///< [s]
        Vec3 value;
    };

    TimedVector() = default;  ///< zero
    explicit TimedVector(const Vec3& constant) : constant_(constant) {}
    /// @throws std::invalid_argument  fewer than two rows, or times that do not ascend
    explicit TimedVector(std::vector<Row> rows);

    /// Over a time, exact: parts of a step have together what the whole one has.
    Vec3 integral(double from, double to) const;
    /// Each of its values turned.
    TimedVector turned(const Quaternion& turn) const;

private:
    Vec3 constant_ = Vec3::Zero();
    std::vector<Row> rows_;
};

/// A spring between a point that stands in the world and a point of a body; its force lies along the line
/// between both.
struct AnchoredSpring {
    Vec3 anchor;             ///< that stands [m]
    double stiffness;        ///< [N/m]
    double rest_length = 0;  ///< [m]

    /// [N]
    Vec3 force_on(const Vec3& point) const;
};

/// A force and a torque on a rigid body from outside.
struct OutsideLoad {
    TimedVector force{};   ///< [N]
    TimedVector torque{};  ///< [N m]
    /// of the body, on which the force acts, in the world as the body is when the load is added [m]; else its
    /// centre of mass
    std::optional<Vec3> point{};
    bool turns_along = false;  ///< with the body: both are in world axes only when the load is added
    /// between its anchor and the point; its force is that of the start of the step
    std::optional<AnchoredSpring> spring{};
};

}  // namespace enduring
