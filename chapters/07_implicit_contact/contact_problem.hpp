#pragma once

#include "chapters/07_implicit_contact/force_element.hpp"
#include "chapters/07_implicit_contact/pair_law.hpp"
#include "common/fem/whole_matrix.hpp"
#include "common/simulation/body.hpp"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace enduring {

/// A body's coordinates among those of all.
struct BodyBlock {
    int first = 0;
    Eigen::MatrixXd mass;      ///< A
    Eigen::MatrixXd response;  ///< A^-1
    std::shared_ptr<const WholeMatrix> whole =
        nullptr;  ///< in place of both, of a soft body with all its nodes

    int size() const { return whole ? whole->size() : static_cast<int>(mass.rows()); }
};

/// A pair as the problem sees it, or what else answers the motion of its bodies in three numbers.
struct PairRow {
    PairLaw law;
    int element =
        -1;  ///< index into ContactProblem::elements, whose law is in the place of a pair's; -1 for a pair
    /// weight times the motion of each vertex of a body that moves, `first` counted among all; six between
    /// two faces of soft bodies
    std::array<VertexMotion, 6> parts;
    int part_count = 0;
    /// of p against q as predicted, all that acts already included [m/s]
    Vec3 velocity = Vec3::Zero();
    Vec3 acting = Vec3::Zero();  ///< impulse on p that the prediction contains already [N s]

    std::span<const VertexMotion> moving() const
    {
        return {parts.data(), static_cast<std::size_t>(part_count)};
    }
    Vec3 velocity_after(const Eigen::VectorXd& change) const;  ///< if the coordinates change by this
    Vec3 rate_of(const Eigen::VectorXd& change) const;         ///< change of its velocity
    /// what an impulse on p does to the coordinates
    void add_impulse(const Vec3& impulse, Eigen::VectorXd& sum) const;
    /// change of its velocity per impulse on p [1/kg]; without what bodies with all their nodes add
    Mat3 response(const std::vector<BodyBlock>& blocks) const;
};

/// Calls visit(first, rate) with a part's rate as a matrix of 3 or 6 columns, which the compiler can unroll:
/// three of a soft body's vertex, six of a rigid body.
template <class Visit>
void with_fixed_size(const VertexMotion& part, const Visit& visit)
{
    if (part.rate.cols() == 6)
        visit(part.first, Eigen::Map<const Eigen::Matrix<double, 3, 6>>(part.rate.data()));
    else
        visit(part.first, Eigen::Map<const Mat3>(part.rate.data()));
}

class NewtonMatrix;

/// One step of all bodies in touch as one convex problem, with limits of friction that are known: find the
/// change x of their predicted velocities that makes
///   1/2 x^T A x  +  sum over pairs of (potential(velocity + J x) + acting . J x)
/// least. Where it is least, A x is what the pairs answer to the
/// motion that they make, less what acts already.
struct ContactProblem {
    StepLaw step;
    std::vector<BodyBlock> blocks;
    std::vector<PairRow> rows;         ///< those of pairs first
    std::vector<ElementLaw> elements;  ///< of all other rows, in their order
    int size = 0;                      ///< of x

    /// What a row pushes at a velocity, and minus its derivative [kg].
    PairPush pushed_by(const PairRow& row, const Vec3& row_velocity) const;
    Mat3 hessian_by(const PairRow& row, const PairPush& push, const Vec3& row_velocity) const;
    const ElementLaw& element_of(const PairRow& row) const
    {
        return elements[static_cast<std::size_t>(row.element)];
    }
};

/// How well and with how much work a problem is solved.
struct ProblemSolution {
    Eigen::VectorXd change;  ///< x
    /// that make this change, three numbers for each pair: A x = J^T (impulses - acting) [N s]. Where the
    /// problem is solved they are what the pairs answer; before, they are Newton's tangent to it.
    Eigen::VectorXd impulses;
    int newton_steps = 0;
    double residual = 0;  ///< see residual_of()
    bool converged = false;
};

/// A x.
Eigen::VectorXd times_mass(const ContactProblem& problem, const Eigen::VectorXd& x);
/// A^-1 times a momentum.
Eigen::VectorXd times_response(const ContactProblem& problem, const Eigen::VectorXd& momentum);

/// The length of a momentum in the norm of A^-1 [sqrt(kg) m/s]; of a body with all its nodes that of its
/// masses, which costs no passage through a factor.
double speed_of(const ContactProblem& problem, const Eigen::VectorXd& momentum);

/// Of each pair, the velocity after a change.
std::vector<Vec3> velocities_after(const ContactProblem& problem, const Eigen::VectorXd& change);
/// Of each pair, how a change changes it.
std::vector<Vec3> rates_of(const ContactProblem& problem, const Eigen::VectorXd& change);

/// What the pairs answer to a change.
struct Answers {
    std::vector<PairPush> pushes;
    Eigen::VectorXd impulses;           ///< three numbers for each pair
    Eigen::VectorXd total, unbalanced;  ///< all as momentum of the coordinates; without what acts already
};
Answers answers_to(const ContactProblem& problem, const Eigen::VectorXd& change);
/// The same from velocities_after() it.
Answers answers_at(const ContactProblem& problem, const std::vector<Vec3>& velocities);

/// The part of the pairs' momentum that a change of the velocities does
/// not account for: |A x - J^T (I - acting)| over
/// |J^T I|, both measured by the speed that they would give (by A^-1), and
///   `least_speed` as the least of the latter.
double residual_of(const ContactProblem& problem, const Eigen::VectorXd& change, double least_speed);

/// The same from A x - J^T (I - acting) and J^T I.
double residual_from(const ContactProblem& problem, const Eigen::VectorXd& gradient,
                     const Eigen::VectorXd& total, double least_speed);

/// The same with the limits of friction that the same motion makes, whatever those of the problem.
double true_residual(const ContactProblem& problem, const Eigen::VectorXd& change, double least_speed);

/// The impulses of all pairs as they act, three numbers each [N s].
Eigen::VectorXd impulses_acting(const ContactProblem& problem);
/// No change, by the impulses that act already.
ProblemSolution unchanged(const ContactProblem& problem);

/// A convex problem that takes more of Newton's steps is stuck by rounding; a hundred random ones take 25.
constexpr int max_convex_steps = 100;

/// Newton's method with a line search, with limits of friction that are lagged.
/// @param begin        the change and the impulses with which it begins
/// @param matrix       of the step's problems, kept from one to the next
/// @param tolerance    of the residual
/// @param least_speed  sqrt(kg) m/s: what counts as a momentum at all
ProblemSolution solve_convex(const ContactProblem& problem, NewtonMatrix& matrix,
                             const ProblemSolution& begin, double tolerance, double least_speed,
                             int max_steps = max_convex_steps);

}  // namespace enduring
