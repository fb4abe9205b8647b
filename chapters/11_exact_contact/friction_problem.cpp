#include "chapters/11_exact_contact/friction_problem.hpp"

#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace enduring {
namespace {

using Eigen::VectorXd;

void require_size(Eigen::Index found, Eigen::Index wanted, const char* what, const std::string& file)
{
    if (found != wanted)
        throw InputError(file + ": " + what + ": expected " + std::to_string(wanted) + ", found " +
                         std::to_string(found));
}

/// What is larger has a square that is no number any more.
constexpr double largest_number = 1e100;
/// Friction of more holds everything, and tells of a wrong file.
constexpr double largest_mu = 1e6;

void require_numbers(const VectorXd& numbers, const char* what, const std::string& file)
{
    for (Eigen::Index i = 0; i < numbers.size(); ++i)
        if (!(std::abs(numbers[i]) <= largest_number))
            throw InputError(file + ": number " + std::to_string(i + 1) + " of " + what +
                             ": expected at most 1e100, found " + shortest(numbers[i]));
}

void require_entries(const Eigen::SparseMatrix<double>& matrix, const char* what, const std::string& file)
{
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
            if (!(std::abs(entry.value()) <= largest_number))
                throw InputError(file + ": " + what + ", row " + std::to_string(entry.row() + 1) +
                                 ", column " + std::to_string(column + 1) +
                                 ": expected at most 1e100, found " + shortest(entry.value()));
}

/// More numbers of W take more than a gigabyte, and minutes to multiply.
constexpr double most_of_response = 1e8;

/// W has a number for each two columns of H that move one coordinate, so at least as many as the fullest row
/// of H has, squared.
void require_sparse_response(const Eigen::SparseMatrix<double>& levers, const std::string& file)
{
    std::vector<double> of_coordinate(static_cast<std::size_t>(levers.rows()), 0);
    for (int column = 0; column < levers.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator entry(levers, column); entry; ++entry)
            ++of_coordinate[static_cast<std::size_t>(entry.row())];
    const double fullest = of_coordinate.empty()
                               ? 0
                               : *std::max_element(of_coordinate.begin(), of_coordinate.end());
    if (fullest * fullest > most_of_response)
        throw InputError(file + ": one coordinate is moved by " + readable(fullest, 6) +
                         " numbers of r, so W has more than 100,000,000 numbers; at most these are taken");
}

void fill_from_bodies(FrictionProblem& problem, const std::string& file)
{
    const BodyEquations& bodies = *problem.bodies;
    const Eigen::Index numbers = problem.dimension * problem.mu.size(), coordinates = bodies.mass.rows();
    require_size(bodies.mass.cols(), coordinates, "columns of the matrix M", file);
    require_size(bodies.levers.rows(), coordinates, "rows of the matrix H", file);
    require_size(bodies.levers.cols(), numbers, "columns of the matrix H", file);
    require_size(bodies.force.size(), coordinates, "numbers of the vector f", file);
    require_size(bodies.given_velocity.size(), numbers, "numbers of the vector w", file);
    require_entries(bodies.mass, "the matrix M", file);
    require_entries(bodies.levers, "the matrix H", file);
    require_sparse_response(bodies.levers, file);
    require_numbers(bodies.force, "the vector f", file);
    require_numbers(bodies.given_velocity, "the vector w", file);
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> mass(bodies.mass);
    if (mass.info() != Eigen::Success)
        throw InputError(file + ": the matrix M is not positive definite");
    problem.response = bodies.levers.transpose() * Eigen::SparseMatrix<double>(mass.solve(bodies.levers));
    problem.free_velocity = bodies.levers.transpose() * VectorXd(mass.solve(bodies.force)) +
                            bodies.given_velocity;
}

}  // namespace

VectorXd contact_velocities(const FrictionProblem& problem, const VectorXd& impulses)
{
    return problem.response * impulses + problem.free_velocity;
}

void complete(FrictionProblem& problem, const std::filesystem::path& path)
{
    const std::string file = path.string();
    if (problem.dimension != 2 && problem.dimension != 3)
        throw InputError(file + ": expected dimension 2 or 3, found " + std::to_string(problem.dimension));
    if (problem.bodies)
        fill_from_bodies(problem, file);
    const Eigen::Index numbers = problem.dimension * problem.mu.size();
    require_size(problem.response.rows(), numbers, "rows of the matrix W", file);
    require_size(problem.response.cols(), numbers, "columns of the matrix W", file);
    require_size(problem.free_velocity.size(), numbers, "numbers of the vector q", file);
    for (Eigen::Index i = 0; i < problem.mu.size(); ++i)
        if (!(problem.mu[i] >= 0 && problem.mu[i] <= largest_mu))
            throw InputError(file + ": mu of contact " + std::to_string(i + 1) +
                             ": expected a number from 0 to 1e6, found " + shortest(problem.mu[i]));
    for (Eigen::Index i = 0; i < problem.mu.size(); ++i)
        if (problem.response.coeff(problem.dimension * i, problem.dimension * i) < 0)
            throw InputError(file + ": the matrix W is negative along the normal of contact " +
                             std::to_string(i + 1));
    require_numbers(problem.free_velocity, "the vector q", file);
    require_entries(problem.response, "the matrix W", file);
}

}  // namespace enduring
