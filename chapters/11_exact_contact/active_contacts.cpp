#include "chapters/11_exact_contact/active_contacts.hpp"

#include "chapters/11_exact_contact/natural_map.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>

#include <limits>
#include <vector>

namespace enduring {
namespace {

using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// So many unknowns, and a matrix of which less than this part is not zero, and it is factored sparse: at
/// 1,000 unknowns of which each knows 50, both take the same time.
constexpr int fewest_for_sparse = 500;
constexpr double densest_for_sparse = 0.05;

/// Of each number of r its place among those of contacts that push, or -1.
struct Active {
    std::vector<int> place, number;

    Active(const FrictionProblem& problem, const VectorXd& wish)
        : place(static_cast<std::size_t>(wish.size()), -1)
    {
        for (int i = 0; i < problem.contacts(); ++i)
            if (wish[problem.dimension * i] > 0)
                for (int j = 0; j < problem.dimension; ++j) {
                    place[static_cast<std::size_t>(problem.dimension * i + j)] =
                        static_cast<int>(number.size());
                    number.push_back(problem.dimension * i + j);
                }
    }
    VectorXd of(const VectorXd& all) const
    {
        VectorXd some(static_cast<Eigen::Index>(number.size()));
        for (std::size_t i = 0; i < number.size(); ++i)
            some[static_cast<Eigen::Index>(i)] = all[number[i]];
        return some;
    }
};

//! [entries]
/// Calls add(row, column, entry) for the matrix  1 - slope (1 - rho m (W + C))  among contacts that push,
/// with r counted in sqrt(m).
template <class Add>
void visit_entries(const SpringPass& pass, double rho, const std::vector<Mat3>& slopes, const Active& active,
                   const VectorXd& roots, const Add& add)
{
    const int dimension = pass.problem.dimension;
    const auto place = [&](int number) { return active.place[static_cast<std::size_t>(number)]; };
    const auto column_of = [&](int row, int column, double factor) {
        const Mat3& slope = slopes[static_cast<std::size_t>(row / dimension)];
        const int first = row - row % dimension;
        for (int k = 0; k < dimension; ++k)
            if (const double part = slope(k, row % dimension); part != 0)
                add(place(first + k), place(column), part * factor * roots[column] / roots[first + k]);
    };
    for (const int column : active.number) {
        for (Matrix::InnerIterator entry(pass.problem.response, column); entry; ++entry)
            if (const int row = static_cast<int>(entry.row()); place(row) >= 0)
                column_of(row, column, rho * pass.masses[row] * entry.value());
        column_of(column, column, rho / pass.h - 1);
        add(place(column), place(column), 1.0);
    }
}
//! [entries]

VectorXd solve_dense(const SpringPass& pass, double rho, const std::vector<Mat3>& slopes,
                     const Active& active, const VectorXd& roots, const VectorXd& b)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(b.size(), b.size());
    visit_entries(pass, rho, slopes, active, roots,
                  [&](int row, int column, double entry) { matrix(row, column) += entry; });
    return matrix.partialPivLu().solve(b);
}

VectorXd solve_sparse(const SpringPass& pass, double rho, const std::vector<Mat3>& slopes,
                      const Active& active, const VectorXd& roots, const VectorXd& b)
{
    std::vector<Eigen::Triplet<double>> entries;
    visit_entries(pass, rho, slopes, active, roots,
                  [&](int row, int column, double entry) { entries.emplace_back(row, column, entry); });
    Matrix matrix(b.size(), b.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SparseLU<Matrix> factor(matrix);
    if (factor.info() != Eigen::Success)
        return VectorXd::Constant(b.size(), std::numeric_limits<double>::quiet_NaN());
    return factor.solve(b);
}

bool is_sparse(const FrictionProblem& problem, Eigen::Index unknowns)
{
    const auto rows = static_cast<double>(problem.response.rows());
    return unknowns >= fewest_for_sparse &&
           static_cast<double>(problem.response.nonZeros()) < densest_for_sparse * rows * rows;
}

}  // namespace

//! [newton_direction]
VectorXd newton_direction(const SpringPass& pass, double rho, const VectorXd& wish, const VectorXd& error)
{
    const FrictionProblem& problem = pass.problem;
    const int dimension = problem.dimension;
    const Active active(problem, wish);
    VectorXd direction = -error;  // of contacts that do not push it is this
    if (active.number.empty())
        return direction;
    for (const int number : active.number)
        direction[number] = 0;
    const VectorXd rates = problem.response * direction, roots = pass.masses.cwiseSqrt();
    std::vector<Mat3> slopes(static_cast<std::size_t>(problem.contacts()));
    VectorXd right = -error;
    for (int i = 0; i < problem.contacts(); ++i) {
        Mat3& slope = slopes[static_cast<std::size_t>(i)];
        slope = push_slope(numbers_of(problem, wish, i), problem.mu[i]);
        const Vec3 change = numbers_of(problem, rates, i).cwiseProduct(numbers_of(problem, pass.masses, i));
        right.segment(dimension * i, dimension) -= rho * (slope * change).head(dimension);
    }
    const VectorXd b = active.of(right.cwiseQuotient(roots));
    const VectorXd found = is_sparse(problem, b.size()) ? solve_sparse(pass, rho, slopes, active, roots, b)
                                                        : solve_dense(pass, rho, slopes, active, roots, b);
    for (std::size_t i = 0; i < active.number.size(); ++i)
        direction[active.number[i]] = roots[active.number[i]] * found[static_cast<Eigen::Index>(i)];
    return direction;
}
//! [newton_direction]

}  // namespace enduring
