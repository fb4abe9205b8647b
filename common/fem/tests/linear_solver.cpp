#include "common/fem/linear_solver.hpp"
#include "common/fem/stiffness_assembly.hpp"
#include "common/fem/tests/bodies.hpp"
#include "common/geometry/read_gmsh.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>
#include <Eigen/Cholesky>

#include <random>
#include <vector>

using namespace enduring;
using namespace enduring::test;

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
                diagonal[row] += std::abs(value);
                diagonal[column] += std::abs(value);
            }
    for (int i = 0; i < size; ++i)
        entries.emplace_back(i, i, diagonal[i]);
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::VectorXd direct_solution(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b)
{
    const Eigen::MatrixXd dense = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
    return dense.llt().solve(b);
}

struct Solver {
    LinearSolverKind kind;
    const char* name;
    /// that its arithmetic allows: of double and of single precision, times a condition of about 100
    double relative_error;
};
constexpr Solver solvers[] = {{LinearSolverKind::simplicial, "simplicial", 1e-13},
                              {LinearSolverKind::supernodal, "supernodal", 1e-5}};

ElasticMesh bunny()
{
    return ElasticMesh(read_gmsh_quadratic(source_directory() / "common/meshes/bunny_363.msh"));
}

/// M + dt^2 K of a body whose elements have turned each its own way, some nodes fixed: what a step factors.
Eigen::SparseMatrix<double> system_of(const ElasticMesh& mesh, double young, double dt)
{
    ElementRotations rotations;
    for (std::size_t e = 0; e < mesh.elements().size(); ++e)
        rotations.push_back(random_rotation(static_cast<unsigned>(e)));
    std::vector<char> fixed(static_cast<std::size_t>(mesh.node_count()), 0);
    fixed[0] = fixed[3] = 1;
    const LameConstants lame = lame_constants({.young = young, .poisson = 0.4});
    return StiffnessAssembly(mesh).assemble(CorotatedElasticity(mesh, lame, rotations),
                                            mass_matrix(mesh, 1000), fixed, 1, dt * dt);
}

}  // namespace

TEST_CASE(
    "linear solvers: they solve like a dense factorisation, to their precision, be the matrix diagonal, sparse or full")
{
    for (const auto& [kind, name, relative_error] : solvers)
        for (const double density : {0.0, 0.02, 0.1, 0.5, 1.0})
            for (const int size : {1, 2, 50}) {
                CAPTURE(name);
                CAPTURE(density);
                CAPTURE(size);
                const Eigen::SparseMatrix<double> matrix = random_matrix(size, density, 7);
                const auto solver = make_linear_solver(kind, matrix);
                REQUIRE(solver->factor(matrix));
                const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(size, -1, 2),
                                      expected = direct_solution(matrix, b);
                Eigen::VectorXd x = b;
                solver->solve(x);
                CHECK((x - expected).norm() <= relative_error * expected.norm());
            }
}

TEST_CASE(
    "linear solvers: the systems of bars and of a bunny are solved, by residual, and both solvers agree")
{
    for (const ElasticMesh& mesh : {elastic(small_bar(), Basis::linear),
                                    elastic(bar({1, 0.2, 0.2}, {10, 2, 2}), Basis::quadratic), bunny()}) {
        CAPTURE(mesh.node_count());
        const Eigen::SparseMatrix<double> matrix = system_of(mesh, 1e5, 0.01);
        const NodalVectors impulses = random_field(mesh.node_count(), 1, 5);
        std::vector<Eigen::VectorXd> solutions;
        for (const auto& [kind, name, relative_error] : solvers) {
            CAPTURE(name);
            const auto solver = make_linear_solver(kind, matrix);
            REQUIRE(solver->factor(matrix));
            Eigen::VectorXd x = impulses.reshaped();
            solver->solve(x);
            const Eigen::VectorXd left = matrix.selfadjointView<Eigen::Lower>() * x - impulses.reshaped();
            CHECK(left.norm() <= 30 * relative_error * impulses.norm());
            solutions.push_back(x);
        }
        CHECK((solutions[0] - solutions[1]).norm() <= 1e-4 * solutions[0].norm());
    }
}

TEST_CASE("linear solvers: many right sides at once have the solutions that each has alone")
{
    const ElasticMesh mesh = elastic(bar({1, 0.2, 0.2}, {10, 2, 2}), Basis::quadratic);
    const Eigen::SparseMatrix<double> matrix = system_of(mesh, 1e5, 0.01);
    for (const auto& [kind, name, relative_error] : solvers)
        for (const int count : {1, 3, 48, 100}) {
            CAPTURE(name);
            CAPTURE(count);
            const auto solver = make_linear_solver(kind, matrix);
            REQUIRE(solver->factor(matrix));
            Eigen::MatrixXd together(matrix.rows(), count);
            for (int i = 0; i < count; ++i)
                together.col(i) = random_field(mesh.node_count(), 1, 5 + static_cast<unsigned>(i)).reshaped();
            const Eigen::MatrixXd sides = together;
            solver->solve(together);
            for (int i = 0; i < count; ++i) {
                Eigen::VectorXd alone = sides.col(i);
                solver->solve(alone);
                CHECK((together.col(i) - alone).norm() <= 30 * relative_error * alone.norm());
            }
        }
}

TEST_CASE("linear solvers: a second matrix of the same pattern takes the place of the first")
{
    for (const auto& [kind, name, relative_error] : solvers) {
        CAPTURE(name);
        const Eigen::SparseMatrix<double> first = random_matrix(40, 0.1, 1);
        const Eigen::SparseMatrix<double> second = 3 * first;
        const auto solver = make_linear_solver(kind, first);
        REQUIRE(solver->factor(first));
        REQUIRE(solver->factor(second));
        Eigen::VectorXd x = Eigen::VectorXd::Ones(40);
        solver->solve(x);
        const Eigen::VectorXd expected = direct_solution(second, Eigen::VectorXd::Ones(40));
        CHECK((x - expected).norm() <= relative_error * expected.norm());
    }
}

TEST_CASE("linear solvers: a matrix that is not positive definite is refused, and the next one is not")
{
    for (const auto& [kind, name, relative_error] : solvers) {
        CAPTURE(name);
        const Eigen::SparseMatrix<double> definite = random_matrix(20, 0.2, 3);
        Eigen::SparseMatrix<double> indefinite = definite;
        indefinite.coeffRef(11, 11) = -1;
        const auto solver = make_linear_solver(kind, definite);
        CHECK_FALSE(solver->factor(indefinite));
        CHECK(solver->factor(definite));
    }
}

TEST_CASE(
    "linear solvers: a body moves the same by either, within its tolerance, and the option decides which one it has")
{
    std::vector<NodalVectors> positions;
    for (const auto& [kind, name, relative_error] : solvers) {
        CAPTURE(name);
        ElasticBody body(bunny(), {.young = 1e5, .poisson = 0.4}, {.linear_solver = kind});
        body.fix(7);
        for (int step = 0; step < 20; ++step) {
            body.predict({3, -9.81, 1}, 0.01);
            body.commit(0.01);
        }
        positions.push_back(body.positions());

        // With a new factor the near response is the response, to the precision
        // of the solver: that tells which one it is.
        const NodalVectors impulses = random_field(body.node_count(), 0.1, 6);
        body.predict({3, -9.81, 1}, 0.008);
        const NodalVectors near = body.near_response(impulses), before = body.velocities();
        body.respond(impulses, 0.008);
        const NodalVectors response = body.velocities() - before;
        const double error = (near - response).norm() / response.norm();
        CHECK((error <= 1e-8) == (kind == LinearSolverKind::simplicial || !has_supernodal_solver()));
        CHECK(error <= 1e-4);
    }
    CHECK((positions[0] - positions[1]).norm() <= 1e-8 * positions[0].norm());
}
