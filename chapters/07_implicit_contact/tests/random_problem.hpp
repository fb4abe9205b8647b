#pragma once

#include "chapters/07_implicit_contact/contact_problem.hpp"
#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <cmath>
#include <random>

namespace enduring::chapter07 {

/// Bodies of three coordinates each, and pairs between random ones of
/// them, one of three against nothing that moves.
inline ContactProblem random_problem(unsigned seed, int bodies, int pairs, double stiffness)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
    ContactProblem problem;
    problem.step = {0.5 + 0.5 * (seed % 3) / 2, 0.01};
    for (int i = 0; i < bodies; ++i) {
        BodyBlock block{problem.size, std::exp(3 * normal(random)) * Mat3::Identity(), {}};
        block.response = block.mass.inverse();
        problem.blocks.push_back(block);
        problem.size += 3;
    }
    for (int i = 0; i < pairs; ++i) {
        PairRow row;
        row.law.normal = vector().normalized();
        row.law.depth_t0 = 0.01 * normal(random);
        row.law.stiffness = stiffness * std::exp(normal(random));
        row.law.mu = 0.5;
        row.law.lagged_normal_impulse = std::abs(normal(random));
        row.velocity = vector();
        const int one = static_cast<int>(random() % static_cast<unsigned>(bodies)),
                  other = (one + 1) % bodies;
        row.parts[0] = {3 * one, Mat3::Identity()};
        row.parts[1] = {3 * other, -Mat3::Identity()};
        row.part_count = i % 3 == 0 ? 1 : 2;
        problem.rows.push_back(row);
    }
    return problem;
}

/// With limits of friction that are lagged.
inline ProblemSolution solved(const ContactProblem& problem, double tolerance)
{
    NewtonMatrix matrix;
    return solve_convex(problem, matrix, unchanged(problem), tolerance, 1e-9);
}

}  // namespace enduring::chapter07
