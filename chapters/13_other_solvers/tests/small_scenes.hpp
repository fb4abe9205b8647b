#pragma once

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/13_other_solvers/solver.hpp"

#include <cmath>

namespace enduring {

/// A cube of 1 m and 10 kg on the ground, at a height above it and on a slope.
inline Scene one_cube(double height = 0, double slope_deg = 0, double mu = 0.5, double dt = 0.01)
{
    return chapter07::scene_of({{10, Vec3(0, 0.5 + height, 0), 0}}, dt, slope_deg, mu, mu);
}

inline void run(Scene& scene, const Solver& solver, double seconds, Contacts& contacts)
{
    for (int step = 0; step < std::lround(seconds / scene.dt); ++step)
        advance(scene.world, contacts, solver, scene.dt);
}
inline void run(Scene& scene, const Solver& solver, double seconds)
{
    Contacts contacts;
    run(scene, solver, seconds, contacts);
}

/// Sum of the impulses on body A of all contacts [N s].
inline Vec3 sum_of(const Contacts& contacts)
{
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts)
        sum += contact.impulse + contact.friction;
    return sum;
}

}  // namespace enduring
