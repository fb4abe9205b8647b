#include "common/fem/tests/bodies.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::test;

namespace {

constexpr double dt = 0.01;

/// Corners and middles of edges, whose neighbours are free.
std::vector<char> some_nodes(const ElasticMesh& mesh)
{
    std::vector<char> fixed(static_cast<std::size_t>(mesh.node_count()), 0);
    const auto& nodes = mesh.elements()[3].nodes;
    for (const int i : {0, nodes_of(mesh.basis()) - 1})
        fixed[static_cast<std::size_t>(nodes[static_cast<std::size_t>(i)])] = 1;
    return fixed;
}

}  // namespace

TEST_CASE(
    "whole matrix: times the velocities that impulses give it is these impulses, of free and of held bodies")
{
    for (const Basis basis : both_bases)
        for (const ElasticLaw law : {ElasticLaw::corotated, ElasticLaw::neo_hookean})
            for (const bool is_held : {false, true}) {
                CAPTURE(name_of(basis));
                CAPTURE(is_held);
                ElasticBody body(elastic(bar({1, 0.2, 0.2}, {5, 1, 1}), basis),
                                 {.young = 1e5, .poisson = 0.3, .stiffness_damping = 0.01, .law = law});
                std::vector<char> fixed(static_cast<std::size_t>(body.node_count()), 0);
                if (is_held)
                    fixed = some_nodes(body.mesh());
                NodalVectors impulses = random_field(body.node_count(), 0.05, 3);
                for (int node = 0; node < body.node_count(); ++node)
                    if (fixed[static_cast<std::size_t>(node)]) {
                        body.fix(node);
                        impulses.col(node).setZero();
                    }
                body.velocities() = 5 * body.positions().colwise().cross(Vec3(0, 1, 2)) +
                                    random_field(body.node_count(), 0.5, 1);
                body.predict(Vec3::Zero(), dt);
                body.reach_end(dt);
                const WholeAssembly assembly(body.mesh(), body.mass_matrix(), fixed, true);
                const NodalVectors before = body.velocities_at_nodes();
                body.respond(assembly.on_coefficients(impulses), dt);
                const Eigen::VectorXd p = impulses.reshaped(),
                                      x = (body.velocities_at_nodes() - before).reshaped();
                const WholeMatrix whole = body.whole_matrix(dt);
                CHECK((whole.times(x) - p).norm() <= 1e-6 * p.norm());
                CHECK(whole.turn.cols() == (is_held ? 0 : 6));
                CHECK((whole.respond(p) - x).norm() <= 0.05 * x.norm());
            }
}

TEST_CASE(
    "whole matrix: values at the nodes and impulses on them do the same work as coefficients and theirs")
{
    const ElasticMesh mesh = elastic(small_bar(), Basis::quadratic);
    const Eigen::SparseMatrix<double> masses = mass_matrix(mesh, 1000);
    const WholeAssembly assembly(mesh, masses,
                                 std::vector<char>(static_cast<std::size_t>(mesh.node_count()), 0), true);
    const NodalVectors field = random_field(mesh.node_count(), 1, 1),
                       impulses = random_field(mesh.node_count(), 1, 2);
    CHECK(assembly.values(field).cwiseProduct(impulses).sum() ==
          doctest::Approx(assembly.on_coefficients(impulses).cwiseProduct(field).sum()));
    const int middle = mesh.elements()[0].nodes[4], a = mesh.elements()[0].nodes[0],
              b = mesh.elements()[0].nodes[1];
    CHECK((assembly.values(field).col(middle) - (field.col(a) + 2 * field.col(middle) + field.col(b)) / 4)
              .norm() < 1e-12);
}
