#include "chapters/11_exact_contact/matrix_text.hpp"
#include "chapters/11_exact_contact/problem_file.hpp"

#include <string>

namespace enduring {
namespace {

Eigen::VectorXd read_vector(FileWords& words, const char* what, Eigen::Index size)
{
    Eigen::VectorXd numbers(size);
    for (double& x : numbers)
        x = words.next_number(what);
    return numbers;
}

/// Whether a matrix H follows: its kind, the rows of M and the numbers of r stand there as whole numbers.
/// Nothing in the file says which of the two forms it has; a vector q that begins so is not known.
bool is_matrix_next(const FileWords& words, Eigen::Index rows, Eigen::Index columns)
{
    const std::string_view kind = words.peek();
    return (kind == "0" || kind == "1" || kind == "2") && words.peek(1) == std::to_string(rows) &&
           words.peek(2) == std::to_string(columns);
}

}  // namespace

//! [siconos]
FrictionProblem parse_siconos(const std::string& text, const std::filesystem::path& file)
{
    FileWords words(text, file.string());
    FrictionProblem problem;
    problem.dimension = words.next_integer("the dimension", 2, 3);
    const int contacts = words.next_integer("the number of contacts", 1, most_rows),
              numbers = problem.dimension * contacts;
    Eigen::SparseMatrix<double> first = read_matrix(words, "the first matrix");
    if (is_matrix_next(words, first.rows(), numbers)) {
        BodyEquations bodies{first, read_matrix(words, "the matrix H"), {}, {}};
        bodies.force = read_vector(words, "the vector f", bodies.mass.rows());
        bodies.given_velocity = read_vector(words, "the vector w", numbers);
        problem.bodies = std::move(bodies);
    } else {
        problem.response.swap(first);
        if (problem.response.rows() != numbers || problem.response.cols() != numbers)
            words.fail("the matrix W has " + std::to_string(problem.response.rows()) + " rows and " +
                       std::to_string(problem.response.cols()) + " columns, not " + std::to_string(numbers) +
                       " of each");
        problem.free_velocity = read_vector(words, "the vector q", numbers);
    }
    problem.mu = read_vector(words, "the vector mu", contacts);
    complete(problem, file);
    return problem;
}
//! [siconos]

}  // namespace enduring
