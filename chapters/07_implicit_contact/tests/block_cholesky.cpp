#include "chapters/07_implicit_contact/block_cholesky.hpp"

#include <doctest/doctest.h>

#include <Eigen/Cholesky>

#include <random>

using namespace enduring;

namespace {

constexpr int side = BlockCholesky::side;

/// A random matrix that is positive definite, with a block for each two neighbours and for a part of all
/// other pairs: its lower triangle in blocks, full on the diagonal.
Eigen::SparseMatrix<double> random_blocks(int count, double part, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Eigen::Triplet<double>> entries;
    for (int column = 0; column < count; ++column)
        for (int row = column; row < count; ++row) {
            if (row > column + 1 && std::abs(number(random)) > part)
                continue;
            Eigen::MatrixXd block = Eigen::MatrixXd::NullaryExpr(side, side, [&] { return number(random); });
            if (row == column)
                block =
                    (block * block.transpose() + side * count * Eigen::MatrixXd::Identity(side, side)).eval();
            for (int j = 0; j < side; ++j)
                for (int i = 0; i < side; ++i)
                    entries.emplace_back(side * row + i, side * column + j, block(i, j));
        }
    Eigen::SparseMatrix<double> matrix(side * count, side * count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& lower)
{
    return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

}  // namespace

TEST_CASE("block cholesky: it solves as a dense factor does, whatever is coupled with what")
{
    for (const int count : {1, 2, 7, 30})
        for (const double part : {0.0, 0.1, 0.5, 1.0}) {
            const auto seed = static_cast<unsigned>(count);
            const Eigen::SparseMatrix<double> first = random_blocks(count, part, seed);
            CAPTURE(count);
            CAPTURE(part);
            BlockCholesky blocks(first);
            // the same pattern with other entries, as from one step of Newton's method to the next
            for (const Eigen::SparseMatrix<double>& matrix :
                 {first, Eigen::SparseMatrix<double>(3 * first)}) {
                REQUIRE(blocks.factor(matrix));
                const Eigen::MatrixXd b = Eigen::MatrixXd::Random(side * count, 3),
                                      exact = dense(matrix).llt().solve(b);
                Eigen::MatrixXd x = b;
                blocks.solve(x);
                CHECK((x - exact).norm() <= 1e-13 * exact.norm());
                Eigen::VectorXd one = b.col(1);
                blocks.solve(one);
                CHECK((one - exact.col(1)).norm() <= 1e-13 * exact.norm());
            }
        }
}

TEST_CASE("block cholesky: a matrix that is not positive definite is refused, and the next one is solved")
{
    const Eigen::SparseMatrix<double> matrix = random_blocks(9, 0.3, 1);
    Eigen::SparseMatrix<double> indefinite = matrix;
    indefinite.coeffRef(side * 5 + 2, side * 5 + 2) = -1;
    BlockCholesky blocks(matrix);
    CHECK_FALSE(blocks.factor(indefinite));
    REQUIRE(blocks.factor(matrix));
    Eigen::VectorXd x = Eigen::VectorXd::Ones(matrix.rows());
    blocks.solve(x);
    CHECK((dense(matrix) * x - Eigen::VectorXd::Ones(matrix.rows())).norm() <= 1e-13);
}

TEST_CASE("block cholesky: its operations are those of a dense factor where everything is coupled")
{
    for (const int count : {10, 30}) {
        const double size = side * count;
        CHECK(BlockCholesky(random_blocks(count, 1, 2)).operations() ==
              doctest::Approx(size * size * size / 3).epsilon(0.02));
    }
}
