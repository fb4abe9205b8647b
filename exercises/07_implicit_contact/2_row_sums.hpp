#pragma once

#include <Eigen/Core>

#include <vector>

namespace enduring {

/// The Delassus operator W of a pile [1/kg]: W(i, j) is how much an impulse of 1 N s in joint j changes the
/// velocity with which joint i opens. Cube 0 lies on the ground, cube i on cube i - 1; they move up and down
/// only. Joint i is the one below cube i, and an impulse in it pushes this cube up and what is below down.
///
/// @param masses  of the cubes, from the lowest to the highest [kg], positive
Eigen::MatrixXd delassus_of_pile(const std::vector<double>& masses);

/// The same for a block that cannot turn, with pairs side by side under it: each of them moves all of it.
inline Eigen::MatrixXd delassus_of_sole(int pairs, double mass)
{
    return Eigen::MatrixXd::Constant(pairs, pairs, 1 / mass);
}

/// Of each row of a Delassus operator the sum of its entries' absolute values [1/kg]. As a diagonal matrix
/// they are D, for which I^T W I <= I^T D I whatever the impulses I.
Eigen::VectorXd row_sums(const Eigen::MatrixXd& delassus);

/// One round in which all pairs answer at once: each changes its impulse by what would stop it if its entry
/// of `divisors` were all there is to move, and none pulls.
///
/// @param free      velocity with which each pair opens when no impulse acts [m/s]
/// @param divisors  [1/kg], positive
/// @param impulses  of the round before [N s]
/// @return          the new impulses [N s]
Eigen::VectorXd answered_at_once(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                                 const Eigen::VectorXd& divisors, const Eigen::VectorXd& impulses);

/// From no impulses on: the rounds until every pair that pushes opens or closes by less than `tolerance`
/// [m/s], and none of the others closes faster. At most `most`.
int rounds_until_answered(const Eigen::MatrixXd& delassus, const Eigen::VectorXd& free,
                          const Eigen::VectorXd& divisors, double tolerance, int most);

}  // namespace enduring
