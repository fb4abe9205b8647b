#include "common/experiments/verification/static_verification.hpp"
#include "common/fem/point_elasticity.hpp"
#include "common/fem/point_laws.hpp"
#include "common/fem/polar_rotation.hpp"
#include "common/fem/stiffness_assembly.hpp"
#include "common/fem/tests/bodies.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <vector>

using namespace enduring;
using namespace enduring::test;

namespace {

constexpr ElasticLaw point_laws[] = {ElasticLaw::corotated_at_points, ElasticLaw::neo_hookean};

const char* name_of(ElasticLaw law)
{
    return law == ElasticLaw::neo_hookean ? "neo-Hookean" : "corotated at points";
}

const LameConstants lame = lame_constants({.young = 3.0, .poisson = 0.4});

/// Gradients that are turned, stretched, flat and inverted.
std::vector<Mat3> gradients()
{
    std::vector<Mat3> result{Mat3::Identity()};
    for (const Vec3& stretch : {Vec3(1, 1, 1), Vec3(1.2, 0.9, 1.1), Vec3(3, 2, 0.5), Vec3(0.3, 0.5, 0.4),
                                Vec3(1.5, 0.8, 0.05), Vec3(1.3, 1.1, -0.4), Vec3(2, 2, 2.5)}) {
        const auto seed = static_cast<unsigned>(result.size());
        result.emplace_back(random_rotation(seed) * stretch.asDiagonal() * random_rotation(seed + 50));
    }
    return result;
}

/// A map of gradients by central differences of what gives a stress.
template <class Stress>
GradientMap derivative(const Stress& stress, const Mat3& f)
{
    constexpr double step = 1e-5;
    GradientMap map;
    for (int entry = 0; entry < 9; ++entry) {
        Mat3 change = Mat3::Zero();
        change(entry % 3, entry / 3) = step;
        map.col(entry) = ((stress(f + change) - stress(f - change)) / (2 * step)).reshaped();
    }
    return map;
}

template <class Law>
void check_stress(const Law& law)
{
    for (const Mat3& f : gradients()) {
        CAPTURE(f);
        const Mat3 direction = random_field(3, 1, 4), stress = law.stress(f);
        const double step = 1e-5,
                     slope = (law.energy(f + step * direction) - law.energy(f - step * direction)) /
                             (2 * step);
        CHECK(std::abs(slope - stress.cwiseProduct(direction).sum()) <= 1e-8 * (1 + stress.norm()));
    }
    CHECK(std::abs(law.energy(Mat3::Identity())) <= 1e-15);
    const Mat3 turn = random_rotation(3);
    CHECK(law.stress(turn).norm() <= 1e-14);
    CHECK(std::abs(law.energy(turn * gradients()[2]) - law.energy(gradients()[2])) <= 1e-14);
}

double energy(const ElasticBody& body) { return body.kinetic_energy() + body.elastic_energy(); }

/// Turns, bends and swings.
void set_tumbling(ElasticBody& body)
{
    const Vec3 omega(1, 5, 2);
    for (int n = 0; n < body.node_count(); ++n) {
        const Vec3 x = body.positions().col(n);
        body.velocities().col(n) = omega.cross(x) + Vec3(0, 12 * x.x() * x.x(), 0);
    }
}

}  // namespace

TEST_CASE("point laws: the stress is the gradient of the energy, and a turn gives none")
{
    check_stress(CorotatedLaw(lame));
    check_stress(NeoHookeanLaw(lame));
}

TEST_CASE("point laws: the corotated stiffness is the derivative of the stress with the frame held")
{
    const CorotatedLaw law(lame);
    for (const Mat3& f : gradients()) {
        CAPTURE(f);
        const Mat3 r = polar_rotation(f);
        const auto stress_in_frame = [&](const Mat3& g) {
            const Mat3 gradient = r.transpose() * g,
                       strain = 0.5 * (gradient + gradient.transpose()) - Mat3::Identity();
            return Mat3(r * (2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity()));
        };
        CHECK((law.stiffness(f) - derivative(stress_in_frame, f)).norm() <= 1e-9);
    }
}

TEST_CASE(
    "point laws: the neo-Hookean stiffness is the derivative of the stress less its negative eigenvalues")
{
    const NeoHookeanLaw law(lame);
    int cut = 0;
    for (const Mat3& f : gradients()) {
        CAPTURE(f);
        const GradientMap exact = derivative([&](const Mat3& g) { return law.stress(g); }, f);
        const Eigen::SelfAdjointEigenSolver<GradientMap> eigen(
            GradientMap(0.5 * (exact + exact.transpose())));
        cut += eigen.eigenvalues()[0] < -0.01;
        const GradientMap expected = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
                                     eigen.eigenvectors().transpose();
        CHECK((law.stiffness(f) - expected).norm() <= 1e-8 * (1 + expected.norm()));
    }
    CHECK(cut >= 3);  // pressed ones
    CHECK(cut < static_cast<int>(gradients().size()));
}

TEST_CASE("point laws: at rest the stiffness of an element is Hooke's K_e, in both bases")
{
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases) {
            CAPTURE(name_of(law));
            CAPTURE(enduring::test::name_of(basis));
            const ElasticMesh mesh = elastic(small_bar(), basis);
            const ElementRotations turns(mesh.elements().size(), Mat3::Identity());
            const auto elasticity = point_elasticity(law, mesh, lame, turns);
            for (int e = 0; e < static_cast<int>(mesh.elements().size()); ++e) {
                const Eigen::MatrixXd expected = element_stiffness(mesh, e, hooke_matrix(lame));
                CHECK((elasticity->stiffness_of(e) - expected).norm() <= 1e-12 * expected.norm());
            }
        }
}

TEST_CASE("point laws: forces of a body are minus the gradient of its energy, and have no torque")
{
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases) {
            CAPTURE(name_of(law));
            CAPTURE(enduring::test::name_of(basis));
            const ElasticMesh mesh = elastic(small_bar(), basis);
            const ElementRotations turns(mesh.elements().size(), Mat3::Identity());
            const auto elasticity = point_elasticity(law, mesh, lame, turns);
            const NodalVectors x = random_rotation(8) * mesh.rest() +
                                   random_field(mesh.node_count(), 0.03, 3),
                               direction = random_field(mesh.node_count(), 1, 4);
            NodalVectors forces = NodalVectors::Zero(3, mesh.node_count());
            elasticity->add_forces(x, forces);
            const double step = 1e-6, slope = (elasticity->energy(x + step * direction) -
                                               elasticity->energy(x - step * direction)) /
                                              (2 * step);
            CHECK(std::abs(slope + forces.cwiseProduct(direction).sum()) <= 1e-6 * forces.norm());
            Vec3 torque = Vec3::Zero();
            for (int n = 0; n < mesh.node_count(); ++n)
                torque += Vec3(x.col(n)).cross(Vec3(forces.col(n)));
            CHECK(torque.norm() <= 1e-14);
            CHECK(forces.norm() > 0.01);
        }
}

TEST_CASE("point laws: the product without a matrix and the assembled matrix agree, also of a strained body")
{
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases) {
            CAPTURE(name_of(law));
            CAPTURE(enduring::test::name_of(basis));
            const ElasticMesh mesh = elastic(small_bar(), basis);
            const ElementRotations turns(mesh.elements().size(), random_rotation(1));  // play no part in it
            const auto elasticity = point_elasticity(law, mesh, lame, turns);
            elasticity->linearise(random_rotation(8) * mesh.rest() +
                                  random_field(mesh.node_count(), 0.03, 3));
            const NodalVectors v = random_field(mesh.node_count(), 1, 2);
            NodalVectors product = NodalVectors::Zero(3, mesh.node_count());
            elasticity->add_stiffness_times(v, 2, product);
            const std::vector<char> all_free(static_cast<std::size_t>(mesh.node_count()), 0);
            StiffnessAssembly assembly(mesh);
            const Eigen::VectorXd expected = assembly
                                                 .assemble(*elasticity, mass_matrix(mesh, 1), all_free, 0, 2)
                                                 .selfadjointView<Eigen::Lower>() *
                                             v.reshaped();
            CHECK((product.reshaped() - expected).norm() <= 1e-12 * expected.norm());
        }
}

TEST_CASE(
    "point laws: patch test, a uniform stretch leaves inner nodes free of force and loads the faces with its stress")
{
    TetrahedralMesh mesh = bar({1, 1, 1}, {3, 3, 3});
    const NodalVectors jitter = random_field(static_cast<int>(mesh.nodes.size()), 0.05, 8);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].cwiseAbs().maxCoeff() < 0.49)
            mesh.nodes[n] += jitter.col(static_cast<Eigen::Index>(n));  // irregular inside
    const Mat3 f = random_rotation(21) * Vec3(1.4, 0.6, 0.9).asDiagonal() * random_rotation(22);
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases) {
            CAPTURE(name_of(law));
            CAPTURE(enduring::test::name_of(basis));
            ElasticBody body(elastic(mesh, basis), {.young = 3.0, .poisson = 0.4, .law = law});
            body.positions() = f * body.mesh().rest();
            const Mat3 stress = law == ElasticLaw::neo_hookean ? NeoHookeanLaw(lame).stress(f)
                                                               : CorotatedLaw(lame).stress(f);
            NodalVectors expected = NodalVectors::Zero(3, body.node_count());  // minus the traction
            for (int axis = 0; axis < 3; ++axis)
                for (const double side : {-1.0, 1.0}) {
                    const auto weights = verification::face_weights(
                        body.mesh(), [&](const Vec3& p) { return side * p[axis] > 0.5 - 1e-9; });
                    expected -= stress * (side * Vec3::Unit(axis)) * weights.transpose();
                }
            CHECK((body.elastic_forces() - expected).cwiseAbs().maxCoeff() <= 1e-12 * stress.norm());
        }
}

TEST_CASE(
    "point laws: a free body that tumbles and swings keeps its angular momentum, at any length of the step")
{
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases)
            for (const double dt : {0.02, 0.002}) {
                CAPTURE(name_of(law));
                CAPTURE(enduring::test::name_of(basis));
                CAPTURE(dt);
                ElasticBody body(elastic(small_bar(), basis),
                                 {.young = 1e4, .stiffness_damping = 0.01, .law = law},
                                 {.solver_tolerance = 1e-4});
                set_tumbling(body);
                const Vec3 start = body.angular_momentum(Vec3::Zero());
                const double energy_start = energy(body);
                for (int step = 0; step < 100; ++step) {
                    body.predict(Vec3::Zero(), dt);
                    body.commit(dt);
                }
                CHECK((body.angular_momentum(Vec3::Zero()) - start).norm() <= 1e-11 * start.norm());
                CHECK(energy(body) < energy_start);
            }
}

TEST_CASE("point laws: an impulse turns a strained body by its lever, and near responses do, too")
{
    for (const ElasticLaw law : point_laws) {
        CAPTURE(name_of(law));
        ElasticBody body(elastic(small_bar(), Basis::quadratic), {.young = 1e5, .law = law});
        body.positions().row(0) *= 0.5;
        body.predict(Vec3::Zero(), 0.01);
        NodalVectors impulses = NodalVectors::Zero(3, body.node_count());
        impulses.col(3) = Vec3(0.1, 0.2, -0.3);
        const Vec3 before = body.angular_momentum(Vec3::Zero()),
                   expected = Vec3(body.positions().col(3)).cross(Vec3(impulses.col(3)));
        const NodalVectors near = body.near_response(impulses), velocities = body.velocities();
        std::vector<NodalVectors> together{impulses};
        body.near_responses(together);
        CHECK((together[0] - near).norm() <= 1e-5 * near.norm());
        body.respond(impulses, 0.01);
        CHECK((body.angular_momentum(Vec3::Zero()) - before - expected).norm() <= 1e-12 * expected.norm());
        body.velocities() = near;
        CHECK((body.angular_momentum(Vec3::Zero()) - expected).norm() <= 1e-5 * expected.norm());
    }
}

TEST_CASE("point laws: what an impulse at one node does at another is what one there does here")
{
    for (const ElasticLaw law : point_laws) {
        CAPTURE(name_of(law));
        const NodalVectors here = random_field(elastic(small_bar(), Basis::quadratic).node_count(), 0.1, 1),
                           there = random_field(static_cast<int>(here.cols()), 0.1, 2);
        const auto changed_by = [&](const NodalVectors& impulses) -> NodalVectors {
            ElasticBody body(elastic(small_bar(), Basis::quadratic), {.young = 1e5, .law = law});
            body.positions().row(0) *= 0.5;
            body.positions() += random_field(body.node_count(), 0.02, 3);
            body.predict(Vec3::Zero(), 0.01);
            const NodalVectors before = body.velocities();
            body.respond(impulses, 0.01);
            return body.velocities() - before;
        };
        const double work = there.cwiseProduct(changed_by(here)).sum();
        CHECK(here.cwiseProduct(changed_by(there)).sum() == doctest::Approx(work).epsilon(1e-7));
    }
}

TEST_CASE("point laws: with a fixed node it is held against turning, and the node stays")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {.young = 1e4, .law = ElasticLaw::neo_hookean});
    body.fix(0);
    const Vec3 held = body.positions().col(0);
    set_tumbling(body);
    for (int step = 0; step < 20; ++step) {
        body.predict(Vec3(0, -9.81, 0), 0.01);
        body.commit(0.01);
    }
    body.predict(Vec3(0, -9.81, 0), 0.01);
    body.fix(1);
    body.respond(random_field(body.node_count(), 0.01, 3), 0.01);
    CHECK(body.velocities().leftCols(2).isZero(0));
    CHECK(Vec3(body.positions().col(0)) == held);
}

TEST_CASE("point laws: a body that is crushed flat or pushed through itself comes back")
{
    for (const ElasticLaw law : point_laws)
        for (const Basis basis : both_bases) {
            CAPTURE(name_of(law));
            CAPTURE(enduring::test::name_of(basis));
            ElasticBody body(elastic(small_bar(), basis),
                             {.young = 1e5, .stiffness_damping = 0.01, .law = law});
            body.positions().row(0) *= -0.5;
            CHECK(body.inverted_elements() == 10);
            for (int step = 0; step < 300; ++step) {
                body.predict(Vec3::Zero(), 0.01);
                body.commit(0.01);
            }
            CHECK(body.inverted_elements() == 0);
            body.positions().setZero();
            for (int step = 0; step < 20; ++step) {
                body.predict(Vec3::Zero(), 0.01);
                body.commit(0.01);
            }
            CHECK(body.positions().allFinite());
        }
}

TEST_CASE(
    "point laws: a cube pressed to 30% between bonded plates inverts no linear neo-Hookean element, and corotated ones")
{
    const auto inverted = [](ElasticLaw law) {
        ElasticBody body(elastic(bar({0.4, 0.4, 0.4}, {3, 3, 3}), Basis::linear),
                         {.young = 1e5, .poisson = 0.4, .stiffness_damping = 0.002, .law = law});
        std::vector<int> top;
        for (int n = 0; n < body.node_count(); ++n)
            if (std::abs(body.mesh().rest()(1, n)) > 0.2 - 1e-9) {
                body.fix(n);
                if (body.mesh().rest()(1, n) > 0)
                    top.push_back(n);
            }
        int most = 0;
        for (int step = 1; step <= 50; ++step) {
            for (const int n : top)
                body.positions()(1, n) = 0.2 - 0.28 * step / 50;
            body.predict(Vec3::Zero(), 0.01);
            body.commit(0.01);
            most = std::max(most, body.inverted_elements());
        }
        return most;
    };
    CHECK(inverted(ElasticLaw::neo_hookean) == 0);
    CHECK(inverted(ElasticLaw::corotated) > 0);
}

TEST_CASE("point laws: a block of rubber that is let go from a tenth of its height gains no energy")
{
    for (const ElasticLaw law : point_laws) {
        CAPTURE(name_of(law));
        ElasticBody body(elastic(bar({0.4, 0.4, 0.4}, {2, 2, 2}), Basis::linear),
                         {.young = 1e6, .poisson = 0.4, .law = law});
        for (int n = 0; n < body.node_count(); ++n)
            if (body.mesh().rest()(1, n) < -0.2 + 1e-9)
                body.fix(n);
        body.positions().row(1).array() = 0.1 * body.positions().row(1).array() - 0.18;
        double most = energy(body);
        const double start = most;
        for (int step = 0; step < 30; ++step) {
            body.predict(Vec3::Zero(), 0.02);
            body.commit(0.02);
            most = std::max(most, energy(body));
        }
        CHECK(most <= start * (1 + 2e-3));
    }
}

TEST_CASE("point laws: frozen rotations are refused, and a law of one frame is not taken at points")
{
    const ElasticMesh mesh = elastic(small_bar(), Basis::linear);
    CHECK_THROWS_AS(ElasticBody(mesh, {.law = ElasticLaw::neo_hookean}, {.freeze_rotations = true}),
                    InputError);
    CHECK_THROWS_AS(point_elasticity(ElasticLaw::corotated, mesh, lame, {}), InputError);
}
