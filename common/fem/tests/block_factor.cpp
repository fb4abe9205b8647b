#include "common/fem/block_factor.hpp"

#include <Eigen/Cholesky>
#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace enduring;

namespace {

/// Positive definite by its diagonal; `density` is the share of the other entries that are not zero.
Eigen::SparseMatrix<double> random_matrix(int size, double density, unsigned seed)
{
    std::mt19937 generator(seed);
    const auto unit = [&] { return static_cast<double>(generator()) / 4294967295.0; };
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> diagonal(static_cast<std::size_t>(size), 0.5);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < row; ++column)
            if (unit() < density) {
                const double value = 2 * unit() - 1;
                entries.emplace_back(row, column, value);
                diagonal[static_cast<std::size_t>(row)] += std::abs(value);
                diagonal[static_cast<std::size_t>(column)] += std::abs(value);
            }
    for (int i = 0; i < size; ++i)
        entries.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::VectorXd direct_solution(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b)
{
    const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    return dense.llt().solve(b);
}

}  // namespace

TEST_CASE("block factor: it solves like a dense factorisation, to single precision, be the matrix diagonal, sparse or full")
{
    for (const double density : {0.0, 0.02, 0.1, 0.5, 1.0})
        for (const int size : {1, 2, 50}) {
            CAPTURE(density);
            CAPTURE(size);
            const Eigen::SparseMatrix<double> matrix = random_matrix(size, density, 7);
            BlockFactor factor;
            factor.analyze(matrix);
            REQUIRE(factor.factor(matrix));
            const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1, 2), expected = direct_solution(matrix, b);
            Eigen::VectorXd x = b;
            factor.solve(x);
            CHECK((x - expected).norm() <= 1e-5 * expected.norm());
        }
}

TEST_CASE("block factor: a second matrix of the same pattern takes the place of the first")
{
    const Eigen::SparseMatrix<double> first = random_matrix(40, 0.1, 1);
    const Eigen::SparseMatrix<double> second = 3 * first;
    BlockFactor factor;
    factor.analyze(first);
    REQUIRE(factor.factor(first));
    REQUIRE(factor.factor(second));
    Eigen::VectorXd x = Eigen::VectorXd::Ones(40);
    factor.solve(x);
    const Eigen::VectorXd expected = direct_solution(second, Eigen::VectorXd::Ones(40));
    CHECK((x - expected).norm() <= 1e-5 * expected.norm());
}

TEST_CASE("block factor: a matrix that is not positive definite is refused")
{
    Eigen::SparseMatrix<double> matrix = random_matrix(20, 0.2, 3);
    BlockFactor factor;
    factor.analyze(matrix);
    matrix.coeffRef(11, 11) = -1;
    CHECK_FALSE(factor.factor(matrix));
}
