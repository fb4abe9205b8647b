#include "common/experiments/verification/spin_verification.hpp"
#include "common/experiments/verification/static_verification.hpp"
#include "common/fem/tests/bodies.hpp"

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <memory>

using namespace enduring;
using namespace enduring::test;

namespace {

double energy(const ElasticBody& body) { return body.kinetic_energy() + body.elastic_energy(); }

}  // namespace

TEST_CASE("elastic body: rigid motion gives no force and no energy")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        ElasticBody body(elastic(small_bar(), basis), {.young = 1e6, .poisson = 0.45});
        body.positions() = (random_rotation(9) * body.positions()).colwise() + Vec3(10, -4, 7);
        // Rounding of coordinates of size 10 against edges of size 0.1, times young times area.
        CHECK(body.elastic_forces().cwiseAbs().maxCoeff() <= 1e-13 * 1e6);
        CHECK(body.elastic_energy() <= 1e-20 * 1e6);
    }
}

TEST_CASE(
    "elastic body: patch test, a uniform stretch leaves inner nodes free of force and loads the faces with its stress")
{
    const ElasticMaterial material{.young = 1e5, .poisson = 0.3};
    const LameConstants lame = lame_constants(material);
    TetrahedralMesh mesh = bar({1, 1, 1}, {3, 3, 3});
    const NodalVectors jitter = random_field(static_cast<int>(mesh.nodes.size()), 0.05, 8);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        if (mesh.nodes[n].cwiseAbs().maxCoeff() < 0.49)
            mesh.nodes[n] += jitter.col(static_cast<Eigen::Index>(n));  // irregular inside

    Mat3 stretch;  // symmetric, so that every rotation is the identity
    stretch << 1.02, 0.01, 0.00, 0.01, 0.97, 0.02, 0.00, 0.02, 1.01;
    const Mat3 strain = stretch - Mat3::Identity();
    const Mat3 stress = 2 * lame.mu * strain + lame.lambda * strain.trace() * Mat3::Identity();
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const Mat3 turn = random_rotation(21);
        ElasticBody body(elastic(mesh, basis), material);
        body.positions() = turn * stretch * body.mesh().rest();

        // minus the traction, on all six faces
        NodalVectors expected = NodalVectors::Zero(3, body.node_count());
        for (int axis = 0; axis < 3; ++axis)
            for (double side : {-1.0, 1.0}) {
                const auto weights = verification::face_weights(
                    body.mesh(), [&](const Vec3& p) { return side * p[axis] > 0.5 - 1e-9; });
                expected -= turn * stress * (side * Vec3::Unit(axis)) * weights.transpose();
            }
        CHECK((body.elastic_forces() - expected).cwiseAbs().maxCoeff() <= 1e-12 * stress.norm());
    }
}

TEST_CASE("elastic body: free fall is symplectic Euler's, to rounding")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    const double dt = 0.01;
    run(body, gravity, dt, 50);
    const Vec3 v = 50 * dt * gravity, x = dt * dt * gravity * (50 * 51 / 2);
    CHECK((body.velocities().colwise() - v).cwiseAbs().maxCoeff() <= 1e-12);
    CHECK((body.positions() - (body.mesh().rest().colwise() + x)).cwiseAbs().maxCoeff() <= 1e-12);
}

TEST_CASE("elastic body: mass damping slows a fall, stiffness damping does not")
{
    ElasticBody dragged(elastic(small_bar(), Basis::quadratic), {.mass_damping = 2});
    ElasticBody stiff(elastic(small_bar(), Basis::quadratic), {.stiffness_damping = 0.1});
    run(dragged, gravity, 0.01, 100);
    run(stiff, gravity, 0.01, 100);
    const double terminal = 9.81 / 2 * (1 - std::pow(1 + 0.02, -100));  // of v' = g - 2 v by implicit Euler
    CHECK(dragged.velocities()(1, 0) == doctest::Approx(-terminal).epsilon(1e-10));
    CHECK(stiff.velocities()(1, 0) == doctest::Approx(-9.81).epsilon(1e-10));
}

TEST_CASE("elastic body: linear momentum is conserved without supports while it tumbles and shakes")
{
    for (Basis basis : both_bases)
        for (double tolerance : {1e-10, 1e-3}) {
            CAPTURE(name_of(basis));
            CAPTURE(tolerance);
            ElasticBody body(elastic(small_bar(), basis), {.stiffness_damping = 0.001},
                             {.solver_tolerance = tolerance});
            body.velocities() = random_field(body.node_count(), 2, 5);
            body.velocities().row(0) += 10 * body.positions().row(1);
            const Vec3 start = body.linear_momentum();
            run(body, Vec3::Zero(), 0.01, 100);
            CHECK((body.linear_momentum() - start).norm() <= 1e-12 * body.mass());
        }
}

TEST_CASE(
    "elastic body: turned, stretched and spinning it has the energy and momenta of the integral over its volume")
{
    const Vec3 size(0.4, 0.2, 0.2), velocity(1, 2, -1), about(0.3, 0.1, -0.7);
    const double density = 700;
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        ElasticBody body(elastic(small_bar(), basis), {.density = density});
        // x = F X + t, v = G X + u with X uniform in the box: only its second
        // moments are needed, size^2 / 12 along each side.
        const Mat3 f = random_rotation(3) * Vec3(1.2, 0.9, 1.1).asDiagonal(), g = random_rotation(5);
        const Vec3 t(1, -2, 0.5);
        body.positions() = (f * body.mesh().rest()).colwise() + t;
        body.velocities() = (g * body.mesh().rest()).colwise() + velocity;
        const double mass = density * size.prod();
        const Mat3 moments = (mass / 12 * size.cwiseAbs2()).asDiagonal();
        CHECK(body.kinetic_energy() == doctest::Approx(0.5 * mass * velocity.squaredNorm() +
                                                       0.5 * (g * moments * g.transpose()).trace())
                                           .epsilon(1e-12));
        CHECK((body.linear_momentum() - mass * velocity).norm() <= 1e-12 * mass * velocity.norm());
        // sum of x v^T about the centre; its antisymmetric part turns
        const Mat3 of_turn = f * moments * g.transpose();
        const Vec3 spin(of_turn(1, 2) - of_turn(2, 1), of_turn(2, 0) - of_turn(0, 2),
                        of_turn(0, 1) - of_turn(1, 0));
        const Vec3 expected = mass * (t - about).cross(velocity) + spin;
        CHECK((body.angular_momentum(about) - expected).norm() <= 1e-12 * expected.norm());
    }
}

TEST_CASE("elastic body: with frozen rotations the energy never grows in a step")
{
    for (Basis basis : both_bases)
        for (double dt : {1e-4, 1e-2, 1.0}) {
            CAPTURE(name_of(basis));
            CAPTURE(dt);
            ElasticBody body(elastic(small_bar(), basis), {}, {.freeze_rotations = true});
            body.positions() += random_field(body.node_count(), 0.02, 6);
            body.velocities() = random_field(body.node_count(), 1, 7);
            for (int step = 0; step < 50; ++step) {
                const double before = energy(body);
                run(body, Vec3::Zero(), dt, 1);
                CHECK(energy(body) <= before * (1 + 1e-10));
            }
        }
}

TEST_CASE("elastic body: inverted elements are counted, do not break the solve, and come back")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        ElasticBody body(elastic(small_bar(), basis), {.young = 1e5, .stiffness_damping = 0.01});
        CHECK(body.inverted_elements() == 0);
        // Push one end through the other, and crush the whole flat.
        body.positions().row(0) *= -0.5;
        CHECK(body.inverted_elements() == 10);
        run(body, Vec3::Zero(), 0.01, 300);
        CHECK(body.positions().allFinite());
        CHECK(body.inverted_elements() == 0);

        body.positions().setZero();
        CHECK(body.inverted_elements() == 10);
        run(body, Vec3::Zero(), 0.01, 20);
        CHECK(body.positions().allFinite());
    }
}

TEST_CASE("elastic body: fixed nodes stay, the others hang from them with the body's weight")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {.young = 1e5, .stiffness_damping = 0.05});
    run(body, Vec3::Zero(), 0.01, 2);  // a factor from before the nodes are fixed
    std::vector<int> held;
    for (int n = 0; n < body.node_count(); ++n)
        if (body.mesh().rest()(0, n) < -0.199)
            held.push_back(n);
    for (int n : held)
        body.fix(n);
    const NodalVectors rest = body.positions();
    run(body, gravity, 0.02, 400);
    Vec3 carried = Vec3::Zero();
    for (int n : held) {
        CHECK((body.positions().col(n) - rest.col(n)).norm() == 0);
        carried += body.elastic_forces().col(n) + body.masses()[n] * gravity;
    }
    CHECK((carried - body.mass() * gravity).norm() <= 1e-6 * body.mass() * 9.81);
    CHECK(body.velocities().cwiseAbs().maxCoeff() <= 1e-6);
}

TEST_CASE("elastic body: a quadratic element with one corner inside out counts as inverted")
{
    const ElasticMesh mesh(
        with_edge_midpoints({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}));
    NodalVectors positions = mesh.rest();
    CHECK(inverted_elements(mesh, positions) == 0);
    // the control point between corners 0 and 1, mirrored to the other side of corner 0
    positions(0, 4) = -0.5;
    CHECK(inverted_elements(mesh, positions) == 1);
}

TEST_CASE("elastic body: a node that is fixed in flight stops at once, and no impulse moves it")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    body.velocities().colwise() = Vec3(1, 2, 3);
    body.fix(4);
    CHECK(body.velocities().col(4).isZero());
    CHECK(body.velocities().col(3) == Vec3(1, 2, 3));
    CHECK(body.inverse_masses()[4] == 0);
    CHECK(body.inverse_masses()[3] == 1 / body.masses()[3]);
}

TEST_CASE("elastic body: the same run twice gives the same bits")
{
    const auto result = [] {
        ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
        body.velocities() = random_field(body.node_count(), 3, 5);
        run(body, gravity, 0.01, 60);
        return body.positions();
    };
    CHECK(result() == result());
}

TEST_CASE("elastic body: a NaN passes through a step without a crash or an endless loop")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    run(body, gravity, 0.01, 1);
    body.positions()(1, 4) = std::nan("");
    run(body, gravity, 0.01, 2);
    CHECK(std::isnan(body.positions()(1, 4)));
}
