#include "common/fem/mass_matrix.hpp"
#include "common/fem/tests/bodies.hpp"
#include "common/fem/tetrahedron_quadrature.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <array>
#include <limits>
#include <string>
#include <utility>

using namespace enduring;
using namespace enduring::test;

namespace {

/// A tetrahedron of no symmetry.
TetrahedralMesh one_element()
{
    return {{Vec3(0.1, 0, 0.2), Vec3(1.3, 0.2, 0), Vec3(0.3, 0.9, -0.1), Vec3(0.2, 0.3, 1.1)},
            {{0, 1, 2, 3}}};
}

/// The ten basis functions written out: squares of the barycentric coordinates, and twice their products.
double bernstein(int node, const Eigen::Vector4d& lambda)
{
    if (node < 4)
        return lambda[node] * lambda[node];
    const auto [i, j] = tetrahedron_edges[node - 4];
    return 2 * lambda[i] * lambda[j];
}

double shape(Basis basis, int node, const Eigen::Vector4d& lambda)
{
    return basis == Basis::linear ? lambda[node] : bernstein(node, lambda);
}

/// Gradient by central differences, which are exact for polynomials of degree two.
Vec3 shape_gradient(Basis basis, int node, const Eigen::Vector4d& lambda,
                    const Eigen::Matrix<double, 3, 4>& gradients)
{
    Vec3 result;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector4d step = gradients.row(axis).transpose();
        result[axis] = 0.5 * (shape(basis, node, lambda + step) - shape(basis, node, lambda - step));
    }
    return result;
}

/// Barycentric coordinates of a point, by solving for them.
Eigen::Vector4d barycentric(const TetrahedralMesh& mesh, const Vec3& point)
{
    Eigen::Matrix4d system;
    Eigen::Vector4d right;
    right << point, 1;
    for (int i = 0; i < 4; ++i)
        system.col(i) << mesh.nodes[i], 1;
    return system.inverse() * right;
}

/// K_e entry by entry from the weak form: int 2 mu eps(phi_a e_i) : eps(phi_b e_j) + lambda div div.
Eigen::MatrixXd stiffness_by_quadrature(Basis basis, const ElasticElement& element, const LameConstants& lame)
{
    const int n = nodes_of(basis);
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(3 * n, 3 * n);
    for (const auto& [lambda, weight] : degree_five_quadrature())
        for (int a = 0; a < n; ++a)
            for (int b = 0; b < n; ++b) {
                const Vec3 ga = shape_gradient(basis, a, lambda, element.gradients),
                           gb = shape_gradient(basis, b, lambda, element.gradients);
                k.block<3, 3>(3 * a,
                              3 * b) += weight * element.volume *
                                        (lame.mu * (ga.dot(gb) * Mat3::Identity() + gb * ga.transpose()) +
                                         lame.lambda * ga * gb.transpose());
            }
    return k;
}

template <class Call>
std::string message_of(const Call& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace

TEST_CASE("elements: gradients of the barycentric coordinates reproduce a linear function")
{
    const TetrahedralMesh mesh = one_element();
    const ElasticElement element = ElasticMesh(mesh).elements()[0];
    for (int i = 0; i < 4; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            const Vec3 p(0.2, 0.3, 0.1);
            const double difference = barycentric(mesh, p + Vec3::Unit(axis))[i] - barycentric(mesh, p)[i];
            CHECK(std::abs(element.gradients(axis, i) - difference) <= 1e-13);
        }
}

TEST_CASE("elements: K_e = V sum m_kl B_k^T E B_l equals a quadrature of the weak form")
{
    const LameConstants lame = lame_constants({.young = 3.0, .poisson = 0.4});
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(one_element(), basis);
        const Eigen::MatrixXd k = element_stiffness(mesh, 0, hooke_matrix(lame));
        const Eigen::MatrixXd expected = stiffness_by_quadrature(basis, mesh.elements()[0], lame);
        CHECK((k - expected).norm() <= 1e-12 * expected.norm());
    }
}

TEST_CASE("elements: the product without a matrix equals the turned element stiffness")
{
    const LameConstants lame = lame_constants({.young = 3.0, .poisson = 0.4});
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(one_element(), basis);
        const ElementRotations rotations{random_rotation(4)};
        const NodalVectors v = random_field(mesh.node_count(), 1, 2);
        NodalVectors product = NodalVectors::Zero(3, mesh.node_count());
        CorotatedElasticity(mesh, lame, rotations).add_stiffness_times(v, 1, product);

        NodalVectors local(3, mesh.node_count());  // in the order of the element's nodes
        for (int i = 0; i < mesh.node_count(); ++i)
            local.col(i) = rotations[0].transpose() * v.col(mesh.elements()[0].nodes[i]);
        const Eigen::VectorXd expected = element_stiffness(mesh, 0, hooke_matrix(lame)) * local.reshaped();
        for (int i = 0; i < mesh.node_count(); ++i)
            CHECK((product.col(mesh.elements()[0].nodes[i]) - rotations[0] * expected.segment<3>(3 * i))
                      .norm() <= 1e-13 * expected.norm());
    }
}

TEST_CASE("elements: forces are the negative gradient of the energy, rotations held")
{
    const LameConstants lame = lame_constants({.young = 3.0, .poisson = 0.4});
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(small_bar(), basis);
        NodalVectors x = mesh.rest() + random_field(mesh.node_count(), 0.03, 3);
        ElementRotations rotations;
        find_rotations(mesh, x, rotations);
        const CorotatedElasticity elasticity(mesh, lame, rotations);
        NodalVectors forces = NodalVectors::Zero(3, mesh.node_count());
        elasticity.add_forces(x, forces);
        // The energy is quadratic in x: central differences are exact but for rounding.
        const NodalVectors direction = random_field(mesh.node_count(), 1, 4);
        const double slope =
            (elasticity.energy(x + 0.1 * direction) - elasticity.energy(x - 0.1 * direction)) / 0.2;
        CHECK(std::abs(slope + forces.cwiseProduct(direction).sum()) <=
              1e-11 * forces.norm() * direction.norm());
    }
}

TEST_CASE("elements: M_ij = density int phi_i phi_j equals a quadrature, and no entry is negative")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(one_element(), basis);
        const Eigen::MatrixXd masses = mass_matrix(mesh, 700);
        const auto& nodes = mesh.elements()[0].nodes;
        for (int i = 0; i < mesh.node_count(); ++i)
            for (int j = 0; j < mesh.node_count(); ++j) {
                double integral = 0;
                for (const auto& [lambda, weight] : degree_five_quadrature())
                    integral += 700 * mesh.volume() * weight * shape(basis, i, lambda) *
                                shape(basis, j, lambda);
                CAPTURE(i);
                CAPTURE(j);
                CHECK(masses(nodes[i], nodes[j]) > 0);
                CHECK(std::abs(masses(nodes[i], nodes[j]) - integral) <= 1e-15 * 700);
            }
    }
}

TEST_CASE("elements: lumped masses are the integrals of the basis, positive, and sum to the body's mass")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(one_element(), basis);
        const Eigen::VectorXd masses = lumped_masses(mass_matrix(mesh, 700));
        for (int node = 0; node < mesh.node_count(); ++node) {
            double integral = 0;
            for (const auto& [lambda, weight] : degree_five_quadrature())
                integral += 700 * mesh.volume() * weight * shape(basis, node, lambda);
            CHECK(masses[node] > 0);
            CHECK(std::abs(masses[node] - integral) <= 1e-13 * masses.sum());
        }
        CHECK(std::abs(masses.sum() - 700 * mesh.volume()) <= 1e-12 * masses.sum());
    }
}

TEST_CASE("elements: an inverted, flat or curved element is refused by its number")
{
    TetrahedralMesh inverted = small_bar();
    std::swap(inverted.elements[5][0], inverted.elements[5][1]);
    CHECK(message_of([&] { ElasticMesh{inverted}; }).find("element 5 (counted from 0) is inverted") == 0);

    TetrahedralMesh flat = one_element();
    flat.nodes[3] = 0.2 * flat.nodes[0] + 0.3 * flat.nodes[1] + 0.5 * flat.nodes[2];
    CHECK(message_of([&] { ElasticMesh{flat}; }).find("element 0") == 0);
    flat.nodes[3].setConstant(std::nan(""));
    CHECK(message_of([&] { ElasticMesh{flat}; }).find("element 0") == 0);

    QuadraticTetrahedralMesh curved = with_edge_midpoints(small_bar());
    curved.nodes.back() += Vec3(0.001, 0, 0);
    CHECK(message_of([&] { ElasticMesh{curved}; }).find("is curved at rest") != std::string::npos);

    TetrahedralMesh out_of_range = one_element();
    out_of_range.elements[0][2] = 9;
    CHECK(message_of([&] { ElasticMesh{out_of_range}; }).find("names node 9") != std::string::npos);

    TetrahedralMesh loose = one_element();
    loose.nodes.push_back(Vec3::Zero());
    CHECK(message_of([&] { ElasticBody(ElasticMesh(loose), {}); }).find("node 4 belongs to no element") == 0);
    CHECK(message_of([&] { ElasticMesh{TetrahedralMesh{}}; }) != "no error");
}

TEST_CASE(
    "elements: a pulled bar grows by its stress over Young's modulus and thins by Poisson's ratio of that")
{
    for (const double poisson : {-0.5, 0.0, 0.3, 0.49}) {
        CAPTURE(poisson);
        const double young = 2e5, stress = 30;
        const Eigen::Matrix<double, 6, 6> hooke =
            hooke_matrix(lame_constants({.young = young, .poisson = poisson}));
        const double along = stress / young, across = -poisson * along;
        Eigen::Matrix<double, 6, 1> strain, pull;
        strain << along, across, across, 0, 0, 0;
        pull << stress, 0, 0, 0, 0, 0;
        CHECK((hooke * strain - pull).norm() <= 1e-12 * stress);
    }
}

TEST_CASE("elements: a material constant outside its range is refused by name")
{
    const double nan = std::nan("");
    for (const auto& wrong : std::vector<std::pair<ElasticMaterial, std::string>>{
             {{.young = 0}, "young"},
             {{.young = -1}, "young"},
             {{.young = nan}, "young"},
             {{.young = std::numeric_limits<double>::infinity()}, "young"},
             {{.poisson = 0.5}, "poisson"},
             {{.poisson = -1}, "poisson"},
             {{.poisson = nan}, "poisson"},
             {{.density = 0}, "density"},
             {{.density = nan}, "density"},
             {{.mass_damping = -0.1}, "mass_damping"},
             {{.stiffness_damping = -1e-9}, "stiffness_damping"}}) {
        const ElasticMaterial& material = wrong.first;
        const std::string& word = wrong.second;  // no structured binding: clang 14 captures none
        CAPTURE(word);
        const std::string message = message_of([&] { ElasticBody(ElasticMesh(small_bar()), material); });
        CHECK(message.find(word) == 0);
        CHECK(message.find("must be") != std::string::npos);
    }
    ElasticBody body(ElasticMesh(small_bar()), {});
    for (double dt : {0.0, -0.01, nan, std::numeric_limits<double>::infinity()})
        CHECK(message_of([&] { body.predict(Vec3::Zero(), dt); }).find("dt") == 0);
    CHECK(message_of([&] { body.fix(999); }).find("fixed node 999") == 0);
}
