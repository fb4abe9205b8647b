#include "chapters/07_implicit_contact/newton_matrix.hpp"

#include <doctest/doctest.h>

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

/// A + J^T S J by the matrices that the formula names.
Eigen::MatrixXd reference(const ContactProblem& problem, const std::vector<Mat3>& hessians)
{
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(problem.size, problem.size);
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

TEST_CASE("newton matrix: dense or sparse, it solves with A + J^T S J of the present stiffening")
{
    for (unsigned seed = 0; seed < 5; ++seed)
        for (RandomProblem problem :
             {ring_of_rigid_bodies(seed, 4), ring_of_rigid_bodies(seed, 30), soft_among_rigid(seed, 20)}) {
            NewtonMatrix matrix;
            for (int again = 0; again < 3; ++again)
                check_solution(matrix, problem);
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
