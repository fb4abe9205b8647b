#pragma once

#include "common/geometry/vector.hpp"

#include <optional>
#include <vector>

namespace enduring {

/// A vector that is the same at all times, or given at some times and linear between them; zero before the first of these
/// and after the last.
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

/// A force and a torque on a rigid body from outside.
struct OutsideLoad {
    TimedVector force{};   ///< [N]
    TimedVector torque{};  ///< [N m]
    /// of the body, on which the force acts, in the world as the body is when the load is added [m]; else its centre of mass
    std::optional<Vec3> point{};
    bool turns_along = false;  ///< with the body: both are in world axes only when the load is added
};

}  // namespace enduring
