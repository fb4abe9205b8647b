#include "chapters/11_exact_contact/spring_pass.hpp"

#include "chapters/11_exact_contact/active_contacts.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace enduring {
namespace {

using Eigen::VectorXd;

/// How Newton's method of a pass ends. None of these has a unit.
struct NewtonSettings {
    /// of the energy that all momentum without contact has: an error of 1e-12. A thousand times: passes stop
    /// at 1e-8.
    double tolerance = 1e-24;
    /// of a pass' first error, squared: less than this is an answer from which the next pass goes on. One: a
    /// pass that brought nothing counts as solved, and its springs become stiffer.
    double enough = 1e-8;
    /// Steps within which the squared error has to halve. Three: rho changes where the line search would have
    /// come through.
    int patience = 15;
    /// of a line search: half a step, and so on down to 1 / 2048
    int halvings = 12;
    /// Part of the predicted fall that counts as one.
    double least_fall = 1e-3;
};
constexpr NewtonSettings newton;

/// rho of the first Newton and of those that follow it. With 1 alone, half of the problems with mass ratios
/// of 1e6 are not solved.
constexpr std::array reaches{1.0, 10.0, 0.1, 100.0, 0.01, 1000.0, 0.001};

/// Where Newton's method stands: what springs wish, the error of the equation, and its square as an energy.
struct State {
    VectorXd impulses, wish, error;
    double energy = 0;
};

//! [error]
State state_at(const SpringPass& pass, double rho, VectorXd impulses)
{
    const int dimension = pass.problem.dimension;
    const VectorXd velocities = contact_velocities(pass.problem, impulses);
    State state{std::move(impulses), {}, {}};
    state.wish = state.impulses - rho * pass.masses.cwiseProduct(velocities) -
                 rho / pass.h * (state.impulses - pass.begin);
    state.error = state.impulses;
    for (int i = 0; i < pass.problem.contacts(); ++i)
        state.error.segment(dimension * i, dimension) -=
            push(numbers_of(pass.problem, state.wish, i), pass.problem.mu[i]).head(dimension);
    state.energy = state.error.cwiseAbs2().cwiseQuotient(pass.masses).sum();
    return state;
}
//! [error]

/// The energy of errors that rounding makes in r.
double rounding_of(const SpringPass& pass, const VectorXd& impulses)
{
    constexpr double one = 4 * std::numeric_limits<double>::epsilon();
    return (one * impulses).cwiseAbs2().cwiseQuotient(pass.masses).sum();
}

/// Goes along a direction as far as the error falls.
bool find_fall(const SpringPass& pass, double rho, const VectorXd& direction, State& state)
{
    double part = 1;
    for (int i = 0; i < newton.halvings; ++i, part *= 0.5) {
        State next = state_at(pass, rho, state.impulses + part * direction);
        if (next.energy < (1 - newton.least_fall * part) * state.energy) {
            state = std::move(next);
            return true;
        }
    }
    return false;
}

}  // namespace

VectorXd felt_masses(const FrictionProblem& problem)
{
    const VectorXd response = problem.response.diagonal();
    const double largest = response.size() > 0 ? response.maxCoeff() : 0, any = largest > 0 ? largest : 1;
    VectorXd masses(response.size());
    for (int i = 0; i < problem.contacts(); ++i) {
        const int first = problem.dimension * i, along = problem.dimension - 1;
        double normal = response[first], surface = response.segment(first + 1, along).mean();
        // where nothing moves along one of both, the other; where nothing moves at all, as the lightest
        // contact
        normal = normal > 0 ? normal : (surface > 0 ? surface : any);
        surface = surface > 0 ? surface : normal;
        masses[first] = 1 / normal;
        masses.segment(first + 1, along).setConstant(1 / surface);
    }
    return masses;
}

//! [push]
Vec3 push(const Vec3& wish, double mu)
{
    const double normal = std::max(0.0, wish.x()), along = std::hypot(wish.y(), wish.z()),
                 limit = mu * normal;
    const double part = along > limit ? limit / along : 1;
    return {normal, part * wish.y(), part * wish.z()};
}

Mat3 push_slope(const Vec3& wish, double mu)
{
    if (wish.x() <= 0)
        return Mat3::Zero();
    const double along = std::hypot(wish.y(), wish.z()), limit = mu * wish.x();
    Mat3 slope = Mat3::Identity();
    if (along <= limit)
        return slope;
    const Vec3 direction(0, wish.y() / along, wish.z() / along);
    slope -= direction * direction.transpose();
    slope.bottomRightCorner<2, 2>() *= limit / along;
    slope.col(0) += mu * direction;  // the limit grows with the normal impulse
    return slope;
}
//! [push]

//! [solve_pass]
PassAnswer solve_pass(const SpringPass& pass, int max_steps)
{
    const double least = newton.tolerance *
                         pass.problem.free_velocity.cwiseAbs2().cwiseProduct(pass.masses).sum();
    PassAnswer answer{pass.begin};
    for (const double rho : reaches) {
        State state = state_at(pass, rho, answer.impulses);
        const double enough = newton.enough * state_at(pass, rho, pass.begin).energy;
        double halved = state.energy;  // where it was `patience` steps ago
        for (int since = 0; since < newton.patience; ++since) {
            answer.reached = state.energy <= std::max(least, rounding_of(pass, state.impulses));
            if (answer.reached || answer.newton_steps == max_steps)
                break;
            ++answer.newton_steps;
            const VectorXd direction = newton_direction(pass, rho, state.wish, state.error);
            if (!direction.allFinite() || !find_fall(pass, rho, direction, state))
                break;
            if (state.energy <= 0.5 * halved) {
                halved = state.energy;
                since = -1;
            }
        }
        answer.impulses = state.impulses;
        answer.reached = answer.reached || state.energy <= enough;
        if (answer.reached || answer.newton_steps == max_steps)
            break;
    }
    return answer;
}
//! [solve_pass]

}  // namespace enduring
