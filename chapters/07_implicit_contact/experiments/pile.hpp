#pragma once

#include "chapters/07_implicit_contact/implicit_contact.hpp"
#include "common/experiments/run/probes.hpp"
#include "common/scenes/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace enduring::chapter07 {

/// What one box of a pile is, and where.
struct Box {
    double mass = 10;  ///< [kg]
    Vec3 centre = Vec3::Zero();
    double turn_deg = 0;  ///< about the axis
    Vec3 axis = Vec3::UnitY();
    Vec3 size = Vec3::Ones();  ///< before it is turned [m]
    Vec3 spin = Vec3::Zero();  ///< angular velocity [rad/s]
};

/// Rigid cubes of 1 m on the plane y = 0 or on a slope: gravity is turned, not
/// the plane. Friction 0.5 and 0.4, and no stiffness.
/// @param slope_deg  the plane falls towards -x
Scene scene_of(const std::vector<Box>& boxes, double dt, double slope_deg = 0, double mu_s = 0.5,
               double mu_d = 0.4);

/// n cubes on one another, each turned by 7 degrees against the one below,
/// the first and the last of other masses if asked.
std::vector<Box> stack_of(int n, double first_mass = 10, double last_mass = 10, double turn_deg = 7);

/// Stacks of five cubes, side by side without touching: ten times the cubes should be ten times the work.
/// @param n  of all cubes, a multiple of five
std::vector<Box> many_stacks(int n);

/// n cubes of 10 kg in square layers above the ground, each turned at random, far enough from one another
/// not to touch.
/// @param side  cubes along each side of a layer
std::vector<Box> loose_cubes(int n, int side, unsigned seed);

/// The middles of all bodies [m].
std::vector<Vec3> centres_of(const World& world);
/// Of the body that is now farthest from where it was [m].
/// @param from  centres_of() of the same world
double longest_displacement(const World& world, const std::vector<Vec3>& from);

/// How well the steps of a run were solved.
struct SolveStatistics {
    long solves = 0, unconverged = 0;
    int max_newton_steps = 0;
    double worst_residual = 0;

    void add(const SolveRecord& record);
};

/// The solver of a chapter that answers all pairs together, this one's or a later one's.
using MakeSolver = Solver (*)(const ContactParameters&, ImplicitSettings);

/// A solver with nothing told on stderr: its solves are counted instead.
/// @param solves  has to outlive the solver
std::function<Solver(const ContactParameters&)> counting_solver(MakeSolver make, SolveStatistics& solves);

/// What is left of a pile when it has come to rest.
struct PileOutcome {
    double deepest_mm = 0;          ///< deepest pair at the end
    double deepest_ever_mm = 0;     ///< and in any step
    double drift_um_per_s = 0;      ///< fastest body, by where it is at half time and at the end
    double moved_mm = 0;            ///< body that ends farthest from its start
    double energy_gain_j = 0;       ///< most that the energy rose above the first
    long newton_steps_at_rest = 0;  ///< of the last step
    long pairs = 0;                 ///< in the list after it
    SolveStatistics solves;
};

/// Runs a scene; the observer, if any, sees the first state and each step.
/// @param duration  [s]
PileOutcome watch(Scene& scene, double duration, MakeSolver make, Probe* observer = nullptr);

}  // namespace enduring::chapter07
