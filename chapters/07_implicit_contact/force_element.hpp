#pragma once

#include "common/geometry/vector.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <vector>

namespace enduring {

struct World;
struct StepProblem;

/// An impulse along one direction that falls with the velocity in this direction, between two bounds:
///   p(u) = clamp(-(bias + slope u), low, high)
/// It is minus the slope of a convex potential, whatever its four numbers are. With `low` = 0 it only pushes,
/// as contact's normal does; without bounds it is two-sided, as a joint is; with both it is a motor or dry
/// friction.
struct LineLaw {
    double bias = 0;   ///< minus the impulse at rest [N s]
    double slope = 0;  ///< never negative [kg]
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

    double impulse(double u) const { return std::clamp(-(bias + slope * u), low, high); }
    double slope_at(double u) const
    {
        const double free = -(bias + slope * u);
        return free > low && free < high ? slope : 0;
    }
};

/// What a row answers that is no pair: three lines at most, each along one column of `axes`. For a row of
/// turns, velocities are angular ones, and impulses those of torques.
struct ElementLaw {
    int element = -1;                ///< whose row it is, by its number among all elements
    int part = 0;                    ///< which of that element's rows
    Mat3 axes = Mat3::Identity();    ///< in the columns; zero where there is no line
    std::array<LineLaw, 3> lines{};  ///< a line without slope and bias is free
    Vec3 begin = Vec3::Zero();       ///< impulse with which the step begins
    /// Whether the first two lines are one plane: they have the same slope and no bias, and what both push
    /// together is within the first one's bounds.
    bool is_round = false;
    int pair = -1;              ///< row of the pair whose load bounds it, if it belongs to one
    Vec3 given = Vec3::Zero();  ///< part of its velocity that belongs to what moves as given [m/s, rad/s]
    double rounding = 0;        ///< what rounding of coordinates makes of it [sqrt(kg) m/s]

    Vec3 impulse(const Vec3& velocity) const;
    /// Minus the derivative of the impulse by the velocity [kg]; symmetric, never negative.
    Mat3 hessian(const Vec3& velocity) const;
};

/// A body's surface vertex, and how much of it counts in a point.
struct VertexShare {
    int body = -1, vertex = -1;
    double weight = 0;
};

/// Which bodies an element joins to one problem: -1 for the world, and for what does not move.
struct ElementBodies {
    int a = -1, b = -1;
    double force = 0;  ///< the most that it brings upon them by itself, as a motor does [N]
    std::vector<VertexShare> vertices{};  ///< of those that are soft, what it reads and pushes
};

//! [force_elements]
/// What is solved together with the pairs of an island: any number of elements, each known by its number. The
/// lists that an element needs are those of its owner; here stand the four questions that the solve asks.
/// None is asked for one element and round.
struct ForceElements {
    /// Once a response: all elements.
    std::function<std::vector<ElementBodies>(const World&)> bodies;
    /// Once a response: appends the rows and laws of StepProblem::elements, behind all rows of pairs.
    std::function<void(const World&, StepProblem&)> add_rows;
    /// Once a round: velocities of these rows, and laws that go through what acts, from the motion found.
    std::function<void(const World&, StepProblem&)> follow;
    /// At the end of a response: what its rows have pushed, for the next response and the next step.
    std::function<void(World&, const StepProblem&)> remember;

    bool any() const { return static_cast<bool>(bodies); }
};
//! [force_elements]

}  // namespace enduring
