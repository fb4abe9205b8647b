#include "chapters/11_exact_contact/problem_of_step.hpp"

#include "chapters/07_implicit_contact/step_problem.hpp"
#include "chapters/11_exact_contact/force_memory.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"
#include "common/input/number_text.hpp"
#include "common/input/pending_file.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace enduring {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;
using Matrix = Eigen::SparseMatrix<double>;

Matrix matrix_of(Eigen::Index rows, Eigen::Index columns, const Triplets& entries)
{
    Matrix matrix(rows, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Entries of a dense part, the zeros left out.
void add_part(const Eigen::MatrixXd& part, Eigen::Index row, Eigen::Index column, Triplets& entries)
{
    for (Eigen::Index j = 0; j < part.cols(); ++j)
        for (Eigen::Index i = 0; i < part.rows(); ++i)
            if (part(i, j) != 0)
                entries.emplace_back(static_cast<int>(row + i), static_cast<int>(column + j), part(i, j));
}

/// All islands together, one after the other.
struct Assembly {
    Triplets mass, levers;
    std::vector<double> given_velocity, mu;
    Eigen::Index coordinates = 0;

    void add(const ContactProblem& island)
    {
        for (const BodyBlock& block : island.blocks)
            add_part(block.mass, coordinates + block.first, coordinates + block.first, mass);
        for (const PairRow& row : island.rows) {
            const Mat3 frame = contact_frame(row.law.normal);
            const auto column = static_cast<Eigen::Index>(given_velocity.size());
            for (const VertexMotion& part : row.moving())
                add_part((frame * part.rate).transpose(), coordinates + part.first, column, levers);
            Vec3 velocity = frame * row.velocity;
            velocity.x() += row.law.depth_t0 / island.step.dt;
            given_velocity.insert(given_velocity.end(), velocity.begin(), velocity.end());
            mu.push_back(row.law.mu);
        }
        coordinates += island.size;
    }
};

/// As triplets: Siconos takes a 1 before "CSparse" for these, and reads no other number there.
void write_matrix(std::ostream& out, const Matrix& matrix)
{
    out << "2\n"
        << matrix.rows() << ' ' << matrix.cols() << "\n1\nCSparse Version 3\ntriplet: " << matrix.rows()
        << "-by-" << matrix.cols() << ", nzmax: " << matrix.nonZeros() << " nnz: " << matrix.nonZeros()
        << '\n';
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
        for (Matrix::InnerIterator entry(matrix, column); entry; ++entry)
            out << entry.row() << ' ' << entry.col() << " : " << shortest(entry.value()) << '\n';
}

void write_vector(std::ostream& out, const Eigen::VectorXd& numbers)
{
    for (const double x : numbers)
        out << shortest(x) << '\n';
}

}  // namespace

Mat3 contact_frame(const Vec3& normal)
{
    Mat3 frame;
    frame.row(0) = normal;
    frame.row(1) = normal.unitOrthogonal();
    frame.row(2) = normal.cross(Vec3(frame.row(1)));
    return frame;
}

//! [problem_of_step]
FrictionProblem problem_of_step(const World& world, const Contacts& contacts,
                                const FrictionCoefficients& friction, double dt)
{
    Contacts copy = contacts;  // the set-up gives them a stiffness
    Assembly all;
    for (const Island& island : find_islands(world, copy)) {
        StepProblem step = set_up(world, island, {}, friction, {1, dt}, true);
        update_kinematics(world, step);
        all.add(step.problem);
    }
    const auto numbers = static_cast<Eigen::Index>(all.given_velocity.size());
    FrictionProblem problem;
    problem.mu = Eigen::Map<const Eigen::VectorXd>(all.mu.data(), static_cast<Eigen::Index>(all.mu.size()));
    problem.bodies = {matrix_of(all.coordinates, all.coordinates, all.mass),
                      matrix_of(all.coordinates, numbers, all.levers), Eigen::VectorXd::Zero(all.coordinates),
                      Eigen::Map<const Eigen::VectorXd>(all.given_velocity.data(), numbers)};
    if (numbers > 0)
        complete(problem, "step " + std::to_string(world.step + 1));
    return problem;
}
//! [problem_of_step]

std::string siconos_text(const FrictionProblem& problem)
{
    std::ostringstream out;
    out << problem.dimension << '\n' << problem.contacts() << '\n';
    if (problem.bodies) {
        write_matrix(out, problem.bodies->mass);
        write_matrix(out, problem.bodies->levers);
        write_vector(out, problem.bodies->force);
        write_vector(out, problem.bodies->given_velocity);
    } else {
        write_matrix(out, problem.response);
        write_vector(out, problem.free_velocity);
    }
    write_vector(out, problem.mu);
    return out.str();
}

std::string answer_text(const Eigen::VectorXd& impulses)
{
    std::ostringstream out;
    write_vector(out, impulses);
    return out.str();
}

void take_problems(Solver& solver, const ContactParameters& parameters,
                   std::function<void(int step, const FrictionProblem&)> take)
{
    solver.insert_before("solve contacts in passes", "hand on problem",
                         [friction = coefficients_of(parameters.friction), take = std::move(take)](
                             World& world, Contacts& contacts, double dt) {
                             if (std::any_of(contacts.begin(), contacts.end(),
                                             [](const Contact& contact) { return contact.answered(); }))
                                 return;
                             const FrictionProblem problem = problem_of_step(world, contacts, friction, dt);
                             if (problem.contacts() > 0)
                                 take(world.step + 1, problem);
                         });
}

void write_problems(Solver& solver, const ContactParameters& parameters, const std::filesystem::path& folder,
                    ProblemForm form)
{
    require_writable_folder(folder, "--write-problems");
    take_problems(solver, parameters, [folder, form](int step, const FrictionProblem& problem) {
        std::ostringstream name;
        name << "step_" << std::setw(6) << std::setfill('0') << step;
        const ExactSolution solution = solve_exactly(problem);
        if (!solution.solved())
            std::cerr << name.str() << ": written without an answer, the best one has an error of "
                      << readable(solution.error, 2) << '\n';
        if (form == ProblemForm::fclib)
            return write_fclib(problem, folder / (name.str() + ".hdf5"),
                               solution.solved() ? solution.impulses : Eigen::VectorXd());
        std::filesystem::remove(folder / (name.str() + ".answer"));  // of an earlier run
        write_file(folder / (name.str() + ".dat"), siconos_text(problem));
        if (solution.solved())
            write_file(folder / (name.str() + ".answer"), answer_text(solution.impulses));
    });
}

}  // namespace enduring
