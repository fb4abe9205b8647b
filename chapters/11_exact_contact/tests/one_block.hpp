#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"

#include <string>
#include <vector>

namespace enduring {

/// A block of mass 2 kg on the ground, one contact below its centre; first number along the normal.
inline FrictionProblem one_block(const Eigen::Vector3d& free_velocity, double mu)
{
    FrictionProblem problem;
    problem.response.resize(3, 3);
    problem.response.setIdentity();
    problem.response *= 0.5;
    problem.free_velocity = free_velocity;
    problem.mu = Eigen::VectorXd::Constant(1, mu);
    return problem;
}

struct HandSolved {
    std::string name;
    FrictionProblem problem;
    Eigen::Vector3d impulse, velocity;  ///< r and u
};

/// Found with pencil and paper: the normal impulse stops 1 m/s of 2 kg; friction can take 0.5 of it.
inline std::vector<HandSolved> hand_solved_blocks()
{
    return {
        {"holds", one_block({-1, 0.3, 0.4}, 0.6), {2, -0.6, -0.8}, {0, 0, 0}},
        {"slides", one_block({-1, 1.2, 1.6}, 0.5), {2, -0.6, -0.8}, {0, 0.9, 1.2}},
        {"flies", one_block({1, 1.2, 1.6}, 0.5), {0, 0, 0}, {1, 1.2, 1.6}},
    };
}

}  // namespace enduring
