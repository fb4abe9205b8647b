#pragma once

#include "common/geometry/vector.hpp"

namespace enduring {

/// Impulses tried out on a copy of one body's predicted velocities, before any is applied: friction is worth
/// no more than what all its pairs do together. A body begins it (Body::begin_trial), and has to outlive it;
/// it holds until the body's velocities change.
class Trial {
public:
    Trial() = default;
    virtual ~Trial() = default;
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// An impulse at a surface vertex [N s].
    virtual void push(int vertex, const Vec3& impulse) = 0;
    /// Of a surface vertex, after all pushes [m/s].
    virtual Vec3 velocity(int vertex) = 0;
};

}  // namespace enduring
