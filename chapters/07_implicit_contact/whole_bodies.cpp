#include "chapters/07_implicit_contact/whole_bodies.hpp"

#include "common/simulation/deformable_body.hpp"

namespace enduring {
namespace {

const DeformableBody& soft_body(const World& world, const StepProblem& step, std::size_t place)
{
    return dynamic_cast<const DeformableBody&>(*world.bodies[static_cast<std::size_t>(step.bodies[place])]);
}

std::shared_ptr<const WholeMatrix> matrix_now(const DeformableBody& body, const StepProblem& step)
{
    return std::make_shared<WholeMatrix>(body.elastic().whole_matrix(step.problem.step.dt));
}

}  // namespace

//! [enters_whole]
std::vector<int> nodes_if_whole(const Body& body, std::span<const int> vertices, double sparse_operation)
{
    const auto* const soft = dynamic_cast<const DeformableBody*>(&body);
    const double size = 3 * static_cast<double>(vertices.size());
    if (!soft || !(soft->elastic().factor_operations() > 0) ||
        size * size * size / 3 <= sparse_operation * soft->elastic().factor_operations())
        return {};
    std::vector<int> nodes;
    for (const int vertex : vertices) {
        const int own = soft->embedding().own_node(vertex);
        const bool is_held = soft->elastic().is_fixed(own);
        for (const int node : soft->embedding().node_numbers_of(vertex))
            if (is_held && !soft->elastic().is_fixed(node))
                return {};
        nodes.push_back(is_held ? -1 : own);
    }
    return nodes;
}
//! [enters_whole]

std::shared_ptr<const WholeMatrix> whole_of(const World& world, const StepProblem& step, std::size_t place)
{
    const DeformableBody& soft = soft_body(world, step, place);
    soft.learn_responses(step.vertices[place]);
    return matrix_now(soft, step);
}

Mat3 response_of_whole(const World& world, std::span<const VertexShare> shares, const StepProblem& step)
{
    Mat3 sum = Mat3::Zero();
    for (const VertexShare& one : shares) {
        const auto place = place_of(step, one.body);
        if (!place || !step.problem.blocks[*place].whole)
            continue;
        const DeformableBody& soft = soft_body(world, step, *place);
        for (const VertexShare& other : shares)
            if (other.body == one.body)
                sum += one.weight * other.weight * soft.learned_response(one.vertex, other.vertex);
    }
    return sum;
}

Eigen::VectorXd velocities_at_nodes(const World& world, const StepProblem& step, std::size_t place)
{
    return soft_body(world, step, place).elastic().velocities_at_nodes().reshaped();
}

bool follow_elements(const World& world, StepProblem& step)
{
    bool any = false;
    for (std::size_t place = 0; place < step.bodies.size(); ++place)
        if (BodyBlock& block = step.problem.blocks[place]; block.whole) {
            block.whole = matrix_now(soft_body(world, step, place), step);
            any = true;
        }
    return any;
}

Eigen::VectorXd at_nodes(const Eigen::VectorXd& momentum, int first, const std::vector<int>& nodes)
{
    Eigen::VectorXd own = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(nodes.size()));
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i] >= 0)
            own.segment<3>(static_cast<Eigen::Index>(3 * i)) = momentum.segment<3>(first + 3 * nodes[i]);
    return own;
}

}  // namespace enduring
