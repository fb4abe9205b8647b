#pragma once

namespace enduring {

/// What a body's own elements do within a step, for a solver that answers contact at the end of the step. A
/// body without elements has no such forces, as here.
class InnerForces {
public:
    InnerForces() = default;
    virtual ~InnerForces() = default;
    InnerForces(const InnerForces&) = delete;
    InnerForces& operator=(const InnerForces&) = delete;

    /// Brings them to where the step ends as it is predicted: contact is answered there.
    /// @return  the imbalance that is left [1]
    virtual double reach_end(double /*dt*/) { return 0; }
    /// Whether they have reached the end in this step (reach_end()), and so can follow what contact changes.
    virtual bool approaches_end() const { return false; }
    /// Brings them nearer to where the step ends now.
    /// @return  the imbalance that there was [1]
    virtual double approach_end(double /*dt*/) { return 0; }
};

}  // namespace enduring
