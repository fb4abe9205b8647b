#include "chapters/11_exact_contact/springs_of_problem.hpp"

#include "chapters/07_implicit_contact/block_matrix.hpp"
#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/11_exact_contact/natural_map.hpp"

#include <Eigen/Cholesky>

#include <algorithm>

namespace enduring {
namespace {

using Eigen::MatrixXd;
using Matrix = Eigen::SparseMatrix<double>;

/// Of units of some coordinates each, those that a matrix couples; each set ascending, the sets by their first.
std::vector<std::vector<int>> coupled_units(const Matrix& matrix, int unit)
{
    const auto count = static_cast<std::size_t>(matrix.rows() / unit);
    JoinedSets joined(count);
    for (int column = 0; column < matrix.outerSize(); ++column)
        for (Matrix::InnerIterator entry(matrix, column); entry; ++entry)
            joined.join(static_cast<int>(entry.row()) / unit, column / unit);
    std::vector<std::vector<int>> sets(count);
    for (int i = 0; i < static_cast<int>(count); ++i)
        sets[static_cast<std::size_t>(joined.least_of(i))].push_back(i);
    std::erase_if(sets, [](const std::vector<int>& set) { return set.empty(); });
    return sets;
}

/// Some coordinates of a matrix, as its symmetric part.
MatrixXd among(const Matrix& matrix, const std::vector<int>& coordinates)
{
    std::vector<int> place(static_cast<std::size_t>(matrix.rows()), -1);
    for (std::size_t i = 0; i < coordinates.size(); ++i)
        place[static_cast<std::size_t>(coordinates[i])] = static_cast<int>(i);
    const auto size = static_cast<Eigen::Index>(coordinates.size());
    MatrixXd part = MatrixXd::Zero(size, size);
    for (int column = 0; column < size; ++column)
        for (Matrix::InnerIterator entry(matrix, coordinates[static_cast<std::size_t>(column)]); entry;
             ++entry)
            if (const int row = place[static_cast<std::size_t>(entry.row())]; row >= 0)
                part(row, column) = entry.value();
    return 0.5 * (part + part.transpose());
}

/// The coordinates of a set of units, and where each stands in the problem.
std::vector<int> coordinates_of(const std::vector<int>& units, int unit, int first, std::vector<int>& place)
{
    std::vector<int> coordinates;
    for (const int one : units)
        for (int i = 0; i < unit; ++i) {
            const int coordinate = unit * one + i;
            place[static_cast<std::size_t>(coordinate)] = first + static_cast<int>(coordinates.size());
            coordinates.push_back(coordinate);
        }
    return coordinates;
}

//! [contacts_move]
/// Blocks of contacts that W couples; the coordinates are three velocities of each contact, whatever the dimension.
void add_contact_blocks(const FrictionProblem& problem, ContactProblem& springs)
{
    const int dimension = problem.dimension;
    const double shift = response_shift * std::max(1e-100, problem.response.diagonal().mean());
    for (const std::vector<int>& contacts : coupled_units(problem.response, dimension)) {
        std::vector<int> unused(static_cast<std::size_t>(problem.response.rows()));
        const MatrixXd given = among(problem.response, coordinates_of(contacts, dimension, 0, unused));
        const auto size = static_cast<Eigen::Index>(3 * contacts.size());
        MatrixXd response = MatrixXd::Zero(size, size);
        for (Eigen::Index i = 0; i < given.rows(); ++i)
            for (Eigen::Index j = 0; j < given.cols(); ++j)
                response(i / dimension * 3 + i % dimension, j / dimension * 3 + j % dimension) = given(i, j);
        BodyBlock block{springs.size, {}, {}};
        const MatrixXd one = MatrixXd::Identity(size, size);
        double more = shift;
        Eigen::LLT<MatrixXd> factor(response + more * one);
        while (factor.info() != Eigen::Success)  // W is not quite positive: rounded, or not symmetric
            factor.compute(response + (more *= 10) * one);
        block.response = response + more * one;
        block.mass = factor.solve(one);
        block.mass = (0.5 * (block.mass + block.mass.transpose())).eval();
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            PairRow& row = springs.rows[static_cast<std::size_t>(contacts[i])];
            row.parts[0] = {springs.size + 3 * static_cast<int>(i), Mat3::Identity()};
            row.part_count = 1;
        }
        springs.size += static_cast<int>(size);
        springs.blocks.push_back(std::move(block));
    }
}
//! [contacts_move]

//! [bodies_move]
/// Blocks of bodies that M couples, of three or six coordinates or several of these.
/// @return  whether chapter 7's pairs can hold the contacts: each moves four such parts at most
bool add_body_blocks(const FrictionProblem& problem, ContactProblem& springs)
{
    const BodyEquations& bodies = *problem.bodies;
    const auto coordinates = static_cast<int>(bodies.mass.rows());
    const int unit = coordinates % 6 == 0 ? 6 : 3;
    if (coordinates % unit != 0)
        return false;
    std::vector<int> place(static_cast<std::size_t>(coordinates)), together(place.size());
    for (const std::vector<int>& units : coupled_units(bodies.mass, unit)) {
        const std::vector<int> of_block = coordinates_of(units, unit, springs.size, place);
        const MatrixXd mass = among(bodies.mass, of_block);
        const auto size = mass.rows();
        springs.blocks.push_back({springs.size, mass, mass.llt().solve(MatrixXd::Identity(size, size))});
        for (const int coordinate :
             of_block)  // bodies that M couples stand in the matrix as vertices of a soft one
            together[static_cast<std::size_t>(coordinate)] = std::min(
                unit, coordinates_together(springs.blocks.back()));
        springs.size += static_cast<int>(size);
    }
    for (int number = 0; number < bodies.levers.cols(); ++number) {
        PairRow& row = springs.rows[static_cast<std::size_t>(number / problem.dimension)];
        for (Matrix::InnerIterator entry(bodies.levers, number); entry; ++entry) {
            const int width = together[static_cast<std::size_t>(entry.row())],
                      at = static_cast<int>(entry.row()) % width,
                      first = place[static_cast<std::size_t>(entry.row())] - at;
            const auto end = row.parts.begin() + row.part_count;
            const auto part = std::find_if(row.parts.begin(), end,
                                           [&](const VertexMotion& known) { return known.first == first; });
            if (part == row.parts.end())
                return false;
            if (part == end) {
                *part = {first, Eigen::MatrixXd::Zero(3, width)};
                ++row.part_count;
            }
            part->rate(number % problem.dimension, at) = entry.value();
        }
    }
    return true;
}
//! [bodies_move]

std::vector<PairRow> rows_of(const FrictionProblem& problem)
{
    std::vector<PairRow> rows(static_cast<std::size_t>(problem.contacts()));
    for (int i = 0; i < problem.contacts(); ++i) {
        PairRow& row = rows[static_cast<std::size_t>(i)];
        row.law.normal = Vec3::UnitX();
        row.law.mu = problem.mu[i];
        row.velocity = numbers_of(problem, problem.free_velocity, i);
    }
    return rows;
}

}  // namespace

//! [springs_of]
ContactProblem springs_of(const FrictionProblem& problem, double h)
{
    ContactProblem springs;
    springs.step = {.centre = 1, .dt = 1};
    springs.rows = rows_of(problem);
    if (!problem.bodies || !add_body_blocks(problem, springs)) {
        springs.blocks.clear();
        springs.size = 0;
        springs.rows = rows_of(problem);
        add_contact_blocks(problem, springs);
    }
    double heaviest = 0;
    for (const PairRow& row : springs.rows)
        heaviest = std::max(heaviest, mass_of(row, springs));
    for (PairRow& row : springs.rows) {
        const double mass = mass_of(row, springs);
        row.law.stiffness = h * (mass > 0 ? mass : heaviest);
    }
    return springs;
}
//! [springs_of]

}  // namespace enduring
