#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>

using namespace enduring;

namespace {

class RandomProblem {
public:
    explicit RandomProblem(unsigned seed) : random_(seed) { problem_.step = {1, 0.01}; }

    /// A body of so many coordinates with a full mass matrix.
    void add_body(int size)
    {
        const Eigen::MatrixXd root = matrix(size, size);
        const Eigen::MatrixXd mass = root * root.transpose() + Eigen::MatrixXd::Identity(size, size);
        const BodyBlock body{problem_.size, mass, mass.inverse()};
        problem_.blocks.push_back(body);
        problem_.size += size;
    }

    /// A soft body with all its nodes: each is coupled with the next two, and K holds nothing against a turn.
    void add_whole_body(int nodes)
    {
        Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        for (int node = 0; node < nodes; ++node)
            for (int other = node; other < std::min(node + 3, nodes); ++other)
                lower.block<3, 3>(3 * other, 3 * node) = other > node ? matrix(3, 3)
                                                                      : 30 * Eigen::MatrixXd::Identity(3, 3);
        WholeMatrix whole;
        whole.elastic = Eigen::MatrixXd(lower.triangularView<Eigen::Lower>()).sparseView(1, 1e-300);
        for (int node = 0; node < nodes;
             ++node)  // entries of a diagonal block that are zero stand there, too
            for (const auto& [row, column] : {std::pair{1, 0}, {2, 0}, {2, 1}})
                whole.elastic.coeffRef(3 * node + row, 3 * node + column) = 0.1;
        whole.elastic.makeCompressed();
        whole.turn = 0.5 * matrix(3 * nodes, 6);
        whole.stiffness_scale = 0.3;
        BodyBlock body{problem_.size, {}, {}};
        body.whole = std::make_shared<WholeMatrix>(whole);
        problem_.blocks.push_back(body);
        problem_.size += 3 * nodes;
    }

    /// A pair of rigid bodies, or of one with a static body.
    void add_rigid_pair(std::initializer_list<std::size_t> bodies)
    {
        PairRow& row = add_row();
        for (const std::size_t body : bodies)
            add_part(row, problem_.blocks[body].first, 6);
    }

    /// A rigid body's vertex against three vertices of a soft one.
    void add_soft_pair(std::size_t rigid, std::size_t soft)
    {
        PairRow& row = add_row();
        add_part(row, problem_.blocks[rigid].first, 6);
        const auto vertices = static_cast<int>(problem_.blocks[soft].size() / 3);
        for (int i = 0; i < 3; ++i)
            add_part(row, problem_.blocks[soft].first + 3 * ((5 * i + 1) % vertices), 3);
    }

    /// A soft body's vertex against three vertices of another one, or a static body's.
    void add_vertex_pair(std::size_t upper, int vertex, std::optional<std::size_t> lower)
    {
        PairRow& row = add_row();
        add_part(row, problem_.blocks[upper].first + 3 * vertex, 3);
        for (int i = 0; lower && i < 3; ++i)
            add_part(row,
                     problem_.blocks[*lower].first + problem_.blocks[*lower].size() - 3 * (vertex + i + 1),
                     3);
    }

    const ContactProblem& problem() const { return problem_; }

    std::vector<Mat3> hessians()
    {
        std::vector<Mat3> all;
        for (std::size_t i = 0; i < problem_.rows.size(); ++i) {
            const Mat3 root = matrix(3, 3);
            all.push_back(i % 4 == 3 ? Mat3(Mat3::Zero()) : Mat3(100 * root * root.transpose()));
        }
        return all;
    }

private:
    Eigen::MatrixXd matrix(int rows, int columns)
    {
        std::normal_distribution<double> normal;
        return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random_); });
    }
    PairRow& add_row() { return problem_.rows.emplace_back(); }
    void add_part(PairRow& row, int first, int columns)
    {
        row.parts[static_cast<std::size_t>(row.part_count++)] = {first, matrix(3, columns)};
    }

    std::mt19937 random_;
    ContactProblem problem_;
};

/// Neighbours of a ring share two pairs, and every other one stands on a static body.
RandomProblem ring_of_rigid_bodies(unsigned seed, std::size_t count)
{
    RandomProblem ring(seed);
    for (std::size_t i = 0; i < count; ++i)
        ring.add_body(6);
    for (std::size_t i = 0; i < count; ++i) {
        ring.add_rigid_pair({i, (i + 1) % count});
        ring.add_rigid_pair({(i + 1) % count, i});
        if (i % 2 == 0)
            ring.add_rigid_pair({i});
    }
    return ring;
}

RandomProblem soft_among_rigid(unsigned seed, int vertices)
{
    RandomProblem mixed(seed);
    for (const int size : {6, 3 * vertices, 6})
        mixed.add_body(size);
    for (int i = 0; i < 6; ++i)
        mixed.add_soft_pair(i % 2 == 0 ? 0 : 2, 1);
    mixed.add_rigid_pair({0, 2});
    mixed.add_rigid_pair({2});
    return mixed;
}

/// Two soft bodies with all their nodes on each other, and a rigid body on the upper one.
RandomProblem whole_bodies(unsigned seed, int nodes)
{
    RandomProblem mixed(seed);
    mixed.add_whole_body(nodes);
    mixed.add_whole_body(nodes + 2);
    mixed.add_body(6);
    for (int i = 0; i < nodes / 3; ++i)
        mixed.add_vertex_pair(1, i, 0);
    mixed.add_soft_pair(2, 1);
    mixed.add_soft_pair(2, 1);
    return mixed;
}

/// Each lies on the one before, and the first one on a static body: vertices on three vertices each.
RandomProblem stack_of_soft_bodies(unsigned seed, std::size_t count, int vertices)
{
    RandomProblem stack(seed);
    for (std::size_t i = 0; i < count; ++i)
        stack.add_body(3 * vertices);
    for (std::size_t upper = 0; upper < count; ++upper)
        for (int i = 0; i < vertices / 2; ++i)
            stack.add_vertex_pair(upper, i, upper == 0 ? std::nullopt : std::optional(upper - 1));
    return stack;
}

/// A + J^T S J by the matrices that the formula names.
Eigen::MatrixXd reference(const ContactProblem& problem, const std::vector<Mat3>& hessians)
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(problem.size, problem.size);
    for (const BodyBlock& body : problem.blocks)
        for (int i = 0; body.whole && i < body.size(); ++i)
            sum.col(body.first + i).segment(body.first, body.size()) +=
                body.whole->times(Eigen::VectorXd::Unit(body.size(), i));
    for (const BodyBlock& body : problem.blocks)
        sum.block(body.first, body.first, body.mass.rows(), body.mass.cols()) += body.mass;
    for (std::size_t pair = 0; pair < problem.rows.size(); ++pair) {
        Eigen::MatrixXd j = Eigen::MatrixXd::Zero(3, problem.size);
        for (const VertexMotion& part : problem.rows[pair].moving())
            j.middleCols(part.first, part.rate.cols()) += part.rate;
        sum += j.transpose() * hessians[pair] * j;
    }
    return sum;
}

void check_solution(NewtonMatrix& matrix, RandomProblem& of)
{
    const ContactProblem& problem = of.problem();
    const std::vector<Mat3> hessians = of.hessians();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(problem.size, -1, 1),
                          x = matrix.solve(problem, hessians, b);
    CAPTURE(problem.size);
    CHECK((reference(problem, hessians) * x - b).norm() <= 1e-9 * b.norm());
}

}  // namespace

TEST_CASE("newton matrix: of rigid bodies or soft ones, it solves with A + J^T S J of the present stiffening")
{
    for (unsigned seed = 0; seed < 5; ++seed)
        for (RandomProblem problem :
             {ring_of_rigid_bodies(seed, 4), ring_of_rigid_bodies(seed, 30), soft_among_rigid(seed, 20),
              stack_of_soft_bodies(seed, 3, 8), whole_bodies(seed, 12), whole_bodies(seed, 40)}) {
            NewtonMatrix matrix;
            for (int again = 0; again < 3; ++again)
                check_solution(matrix, problem);
        }
}

TEST_CASE("newton matrix: a factor is kept while its hessians change by a thousandth, and no longer")
{
    RandomProblem ring = ring_of_rigid_bodies(3, 20);
    const ContactProblem& problem = ring.problem();
    const std::vector<Mat3> hessians = ring.hessians();
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(problem.size, -1, 1);
    for (const double change : {5e-4, 2e-3, 0.03, 0.3}) {
        NewtonMatrix matrix;
        const Eigen::VectorXd first = matrix.solve(problem, hessians, b);
        std::vector<Mat3> changed = hessians;
        for (Mat3& hessian : changed)
            hessian *= 1 + change;
        const Eigen::VectorXd x = matrix.solve(problem, changed, b);
        CAPTURE(change);
        if (change < 1e-3)
            CHECK(x == first);
        else
            CHECK((reference(problem, changed) * x - b).norm() <= 1e-9 * b.norm());
    }
}

TEST_CASE("newton matrix: in a new step other bodies may touch, or the same ones with other masses")
{
    NewtonMatrix matrix;
    for (const std::size_t bodies : {20u, 30u, 30u, 25u})
        for (const bool one_more : {true, false}) {
            RandomProblem ring = ring_of_rigid_bodies(static_cast<unsigned>(bodies), bodies);
            if (one_more)
                ring.add_rigid_pair({0, bodies / 2});
            matrix.begin_response(0);
            check_solution(matrix, ring);
        }
    RandomProblem mixed = soft_among_rigid(1, 12);
    matrix.begin_response(0);
    check_solution(matrix, mixed);
}

TEST_CASE(
    "newton matrix: a large one of soft bodies is solved in blocks, also where other vertices or fewer bodies touch")
{
    NewtonMatrix matrix;
    for (const int vertices : {60, 60, 50, 4}) {
        RandomProblem stack = stack_of_soft_bodies(static_cast<unsigned>(vertices), 3, vertices);
        CHECK((estimated_operations(stack.problem()) > 1e6) == (vertices > 4));
        matrix.begin_response(0);
        check_solution(matrix, stack);
        stack.add_vertex_pair(2, 0, 0);
        matrix.begin_response(0);
        check_solution(matrix, stack);
    }
}

TEST_CASE(
    "newton matrix: the estimate of its operations is that of Cholesky's factor where each body touches the next one only")
{
    for (const int vertices : {20, 40}) {
        // all of the first body, then all that it touches of the second one, which is filled with its rest
        // anyway
        const RandomProblem stack = stack_of_soft_bodies(1, 2, vertices);
        const double n = 3 * vertices, touching = 3 * (vertices / 2);
        double exact = 0;
        for (int column = 0; column < 2 * n; ++column)
            exact += std::pow(column < n ? n - column + touching : 2 * n - column, 2);
        CHECK(estimated_operations(stack.problem()) == doctest::Approx(exact).epsilon(0.05));
    }
}

TEST_CASE("newton matrix: that of all pairs pressed is A + J^T k dt^2 J, with steps of any length")
{
    for (const double dt : {0.001, 0.03}) {
        ContactProblem problem = soft_among_rigid(2, 10).problem();
        problem.step.dt = dt;
        std::vector<Mat3> hessians;
        hessians.reserve(problem.rows.size());
        for (PairRow& row : problem.rows) {
            row.law.stiffness = 1e4 * static_cast<double>(hessians.size() + 1);
            hessians.emplace_back(row.law.stiffness * dt * dt * Mat3::Identity());
        }
        const Eigen::MatrixXd lower = pressed_matrix(problem);
        const Eigen::MatrixXd whole = lower.selfadjointView<Eigen::Lower>();
        const Eigen::MatrixXd expected = reference(problem, hessians);
        CAPTURE(dt);
        CHECK((whole - expected).norm() <= 1e-12 * expected.norm());
    }
}
