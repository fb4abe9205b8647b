#include "common/experiments/verification/modal_verification.hpp"

#include "common/experiments/verification/static_verification.hpp"
#include "common/experiments/verification/verification_bars.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace enduring::verification {
namespace {

using std::numbers::pi;

struct Mode {
    double omega;  ///< circular frequency [rad/s]
    NodalVectors shape;
};

/// Fields without order: they have some of every mode in them. The same on every machine.
std::vector<NodalVectors> first_guesses(Eigen::Index nodes, int count)
{
    std::mt19937 generator(1);
    std::vector<NodalVectors> guesses;
    for (int i = 0; i < count; ++i)
        guesses.push_back(NodalVectors::NullaryExpr(
            3, nodes, [&] { return static_cast<double>(generator()) / 4294967295.0 - 0.5; }));
    return guesses;
}

/// The slowest modes by inverse iteration on a block of fields, slowest first. In each
/// round K next = M now, and within the space that the fields span the small
/// eigenvalue problem is solved exactly (Rayleigh and Ritz).
std::vector<Mode> slowest_modes(ElasticBody& body, const Eigen::SparseMatrix<double>& masses, int count)
{
    const int size = count + 4, rounds = 10;  // those beyond the count make the others converge sooner
    std::vector<NodalVectors> fields = first_guesses(body.node_count(), size);
    Eigen::VectorXd squares;
    for (int round = 0; round < rounds; ++round) {
        std::vector<NodalVectors> inertia, next;
        for (const NodalVectors& field : fields) {
            inertia.push_back(field * masses);
            next.push_back(static_displacement(body, inertia.back()));
        }
        Eigen::MatrixXd stiffness(size, size), mass(size, size);
        for (int i = 0; i < size; ++i) {
            const NodalVectors momenta = next[i] * masses;
            for (int j = 0; j < size; ++j) {
                stiffness(i, j) = next[j].cwiseProduct(inertia[i]).sum();
                mass(i, j) = next[j].cwiseProduct(momenta).sum();
            }
        }
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(stiffness, mass);
        squares = small.eigenvalues();
        for (int i = 0; i < size; ++i) {
            fields[i].setZero();
            for (int j = 0; j < size; ++j)
                fields[i] += small.eigenvectors()(j, i) * next[j];
        }
    }
    std::vector<Mode> modes;
    for (int i = 0; i < count; ++i)
        modes.push_back({std::sqrt(squares[i]), fields[i]});
    return modes;
}

Eigen::SparseMatrix<double> lumps(const ElasticBody& body)
{
    return Eigen::SparseMatrix<double>(body.masses().asDiagonal());
}

constexpr ElasticMaterial rubber{.young = 1e6, .poisson = 0.3, .density = 1000};

std::unique_ptr<ElasticBody> slender_bar(int cells_along, Basis basis)
{
    return clamped_bar(1, 0.05, {cells_along, 1, 1}, basis, rubber);
}

/// Share of a mode's motion that is a turn about the bar's axis, at the places where it moves.
double twist(const ElasticBody& body, const NodalVectors& shape)
{
    const NodalVectors& x = body.mesh().rest();
    double along = 0, all = 0;
    for (Eigen::Index n = 0; n < x.cols(); ++n) {
        const Vec3 turn = Vec3::UnitX().cross(x.col(n));
        along += std::abs(turn.dot(shape.col(n)));
        all += turn.norm() * shape.col(n).norm();
    }
    return along / all;
}

double first_torsion(ElasticBody& body, const Eigen::SparseMatrix<double>& masses)
{
    const std::vector<Mode> modes = slowest_modes(body, masses, 9);
    const auto torsion = std::max_element(modes.begin(), modes.end(), [&](const Mode& a, const Mode& b) {
        return twist(body, a.shape) < twist(body, b.shape);
    });
    return torsion->omega / (2 * pi);
}

}  // namespace

Table bending_frequency()
{
    const double wave_number = 1.8751040687;  // of cos(x) cosh(x) = -1, for length 1
    const double radius_of_gyration = 0.05 / std::sqrt(12.0);
    const double theory = wave_number * wave_number * radius_of_gyration *
                          std::sqrt(rubber.young / rubber.density) / (2 * pi);

    Table table({"basis", "cells_along", "unknowns", "frequency_hz", "theory_hz", "ratio", "lumped_ratio"});
    for (Basis basis : both_bases)
        for (int cells : {10, 20, 40}) {
            const auto body = slender_bar(cells, basis);
            const double frequency = slowest_modes(*body, body->mass_matrix(), 2).front().omega / (2 * pi);
            const double with_lumps = slowest_modes(*body, lumps(*body), 2).front().omega / (2 * pi);
            table.add({name_of(basis), long{cells}, 3L * body->node_count(), frequency, theory,
                       frequency / theory, with_lumps / theory});
        }
    return table;
}

Table torsion_frequency()
{
    const double length = 1, thickness = 1.0 / 15;
    const double torsion_constant = 0.140577, polar_moment = 1.0 / 6;  // of a unit square (Saint-Venant)
    const double wave_speed =
        std::sqrt(lame_constants(rubber).mu / rubber.density * torsion_constant / polar_moment);
    const double theory = wave_speed / (4 * length);

    Table table({"basis", "cells_across", "unknowns", "frequency_hz", "theory_hz", "ratio", "lumped_ratio"});
    for (Basis basis : both_bases)
        for (int across : {1, 2, 3}) {
            const auto body = clamped_bar(length, thickness, {15, across, across}, basis, rubber);
            const double frequency = first_torsion(*body, body->mass_matrix()),
                         with_lumps = first_torsion(*body, lumps(*body));
            table.add({name_of(basis), long{across}, 3L * body->node_count(), frequency, theory,
                       frequency / theory, with_lumps / theory});
        }
    return table;
}

Table convergence_in_time()
{
    const auto body = slender_bar(10, Basis::quadratic);
    auto [omega, mode] = slowest_modes(*body, body->mass_matrix(), 2).front();
    mode *= 0.001 / mode.cwiseAbs().maxCoeff();
    Table table({"steps_per_period", "error", "order"});
    double previous = 0;
    for (int steps : {100, 200, 400, 800}) {
        const double dt = 2 * pi / omega / steps;
        body->positions() = body->mesh().rest() + mode;
        body->velocities().setZero();
        for (int step = 0; step < steps / 2; ++step) {
            body->predict(Vec3::Zero(), dt);
            body->commit(dt);
        }
        const NodalVectors exact = body->mesh().rest() - mode;  // cos(pi) = -1
        const double error = (body->positions() - exact).norm() / mode.norm();
        // an order needs two steps
        table.add({long{steps}, error, previous > 0 ? Cell{std::log2(previous / error)} : Cell{"-"}});
        previous = error;
    }
    return table;
}

}  // namespace enduring::verification
