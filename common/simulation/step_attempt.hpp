#pragma once

#include "common/simulation/step.hpp"

namespace enduring {

//! [attempt_limits]
/// When a step does not end well. Only solvers that take such a step in halves look (Solver::max_halvings).
struct AttemptLimits {
    /// Of the kinetic energy and that of the springs at the start: what a step may gain. The equation of a
    /// step with normals that stand still gains nothing; normals that turn with their bodies gain by the
    /// square of the turn. A tenth: sound steps of bodies that tumble are halved. Ten times: a hundred such
    /// steps double the energy.
    double gain = 1e-3;
    /// Of M g^2 dt^2, what gravity itself gives to all bodies from rest in a step: the same where hardly
    /// anything moves. Without gravity scale_parts.trembling alone is left, else the rounding of an elastic
    /// energy is a gain.
    double gain_at_rest = 0.01;
    /// Of the size of the total energy, which depends on where its zero is: rounding.
    double rounding = 1e-12;
};
inline constexpr AttemptLimits attempt_limits;
//! [attempt_limits]

/// The world and its pairs as they are between two steps, to be brought back.
class SavedState {
public:
    SavedState(World& world, const Contacts& contacts);
    void restore(World& world, Contacts& contacts) const;

private:
    std::vector<std::vector<double>> bodies_;
    Contacts contacts_;
    std::vector<Joint> joints_;
    double time_, driven_;
};

/// What bodies and springs hold between two steps [J].
struct HeldEnergy {
    double total = 0;   ///< of all kinds, springs included
    double moving = 0;  ///< kinetic, and of springs
    double springs = 0;
};
HeldEnergy held_energy(const World& world, const Contacts& contacts);

/// The work that bodies which move as given, and surfaces that run, do through their pairs in this step, and
/// that forces and impulses from outside do; before the step is committed [J].
double driven_work(const World& world, const Contacts& contacts, double dt);

/// What gravity gives to bodies that turn about pins since its levers turn in the step
/// (Body::turned_lever_work()) [J]. At the end of a swing's step the body is half a step ahead of its
/// velocity, so it seems to gain and to lose. Booked by nobody, a pendulum of 1 m with steps of 10 ms would
/// be taken in halves.
double turned_lever_work(const World& world, double dt);

/// Whether a step of length dt [s] has ended with more energy than it began with, less what was put in on
/// purpose (StepAttempt::added_energy).
bool has_gained(const World& world, const HeldEnergy& before, const HeldEnergy& after, double dt);

}  // namespace enduring
