#pragma once

#include "chapters/11_exact_contact/friction_problem.hpp"
#include "common/geometry/vector.hpp"

#include <Eigen/SparseCore>

#include <vector>

namespace enduring::tests {

/// Blocks side by side, each on the ground, that pull their neighbours along.
inline FrictionProblem row_of_blocks(int contacts)
{
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 3 * contacts; ++i) {
        entries.emplace_back(i, i, 2.0);
        if (i >= 3) {
            entries.emplace_back(i, i - 3, -0.5);
            entries.emplace_back(i - 3, i, -0.5);
        }
    }
    FrictionProblem problem;
    problem.response.resize(3 * contacts, 3 * contacts);
    problem.response.setFromTriplets(entries.begin(), entries.end());
    problem.free_velocity = Vec3(-1, 0.2, 0.4).replicate(contacts, 1);
    problem.mu = Eigen::VectorXd::Constant(contacts, 0.3);
    return problem;
}

}  // namespace enduring::tests
