#pragma once

#include <limits>
#include <span>

namespace enduring {

/// A surface vertex and the share of an impulse that it receives.
struct Push {
    int vertex;
    double weight;  ///< not negative
};

/// The parts of a body, each moved as one by an impulse on it within a step: pairs that push on the same part
/// share its mass. A rigid body is one part, as here, and so is a deformable one that answers implicitly;
/// else every node is its own.
class MassParts {
public:
    MassParts() = default;
    virtual ~MassParts() = default;
    MassParts(const MassParts&) = delete;
    MassParts& operator=(const MassParts&) = delete;

    virtual int count() const { return 1; }
    /// Those that an impulse at a surface vertex moves.
    virtual std::span<const int> moved_by(int /*vertex*/) const { return {&whole, 1}; }

    /// The same question answered better by a body whose parts hang together, if it can: a bound on what all
    /// `pushes` change at a vertex together, each weight's worth of impulse in its own worst direction
    /// [1/kg]; infinite where it knows none.
    virtual double response_bound(int /*vertex*/, std::span<const Push> /*pushes*/) const
    {
        return std::numeric_limits<double>::infinity();
    }

private:
    static constexpr int whole = 0;
};

}  // namespace enduring
