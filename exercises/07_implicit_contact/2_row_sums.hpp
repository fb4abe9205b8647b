#pragma once

#include <Eigen/Core>

#include <vector>

namespace enduring {

/// The Delassus operator W of a pile [1/kg]: an impulse of 1 N s in joint j changes the velocity with which
/// joint i opens by W(i, j). Cube 0 lies on the ground, cube i on cube i - 1; all move only up and down.
/// Joint i is below cube i. An impulse in it pushes this cube up and the body below down.
///
/// @param masses  of the cubes, from the lowest to the highest [kg], positive
Eigen::MatrixXd delassus_of_pile(const std::vector<double>& masses);

/// The same for a block that cannot turn, with pairs side by side under it: each pair moves the whole block.
inline Eigen::MatrixXd delassus_of_sole(int pairs, double mass)
{
    return Eigen::MatrixXd::Constant(pairs, pairs, 1 / mass);
}

/// The sum of the absolute values in each row of a Delassus operator [1/kg]. As a diagonal matrix D, these
/// sums satisfy I^T W I <= I^T D I for all impulses I.
Eigen::VectorXd row_sums(const Eigen::MatrixXd& delassus);

/// One round for all pairs at once: the impulse of pair i changes by -v_i / divisors_i, with its velocity v_i
/// before the round. No pair pulls.
///
/// @param free      velocity with which each pair opens when no impulse acts [m/s]
/// @param divisors  [1/kg], positive
/// @param impulses  of the round before [N s]
/// @return          the new impulses [N s]
Eigen::VectorXd answered_at_once(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& divisors, const Eigen::VectorXd& impulses);

/// The number of rounds, from zero impulses on, until every pair that pushes opens or closes more slowly than
/// `tolerance` [m/s], and no other pair closes faster. At most `most`.
int rounds_until_answered(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                          const Eigen::VectorXd& divisors, double tolerance, int most);

}  // namespace enduring
