#pragma once

#include "chapters/07_implicit_contact/step_problem.hpp"

namespace enduring {

// Soft bodies that enter a step's problem with all their nodes; `place` is that among the problem's bodies.

/// The nodes at which these vertices of a soft body are, if it enters with all its nodes: where a sparse
/// factor of them takes fewer operations than a dense one of the vertices. None of a body that is not soft,
/// or where a free vertex has a held node of its own.
std::vector<int> nodes_if_whole(const Body& body, std::span<const int> vertices, double sparse_operation);

/// A such body's matrix; it learns what impulses at its vertices in touch do.
std::shared_ptr<const WholeMatrix> whole_of(const World& world, const StepProblem& step, std::size_t place);

/// What these bodies add to PairRow::response() of a row that is the sum of these shares: it is learned, as
/// that of other soft bodies is.
Mat3 response_of_whole(const World& world, std::span<const VertexShare> shares, const StepProblem& step);

/// Brings A of these bodies to where their elements are now.
/// @return  whether there is any; then what was factored does not hold
bool follow_elements(const World& world, StepProblem& step);

/// Predicted, of all nodes [m/s].
Eigen::VectorXd velocities_at_nodes(const World& world, const StepProblem& step, std::size_t place);

/// What stands at these nodes of a body with all its nodes: only they are pushed. Zero for those that are
/// held.
Eigen::VectorXd at_nodes(const Eigen::VectorXd& momentum, int first, const std::vector<int>& nodes);

}  // namespace enduring
