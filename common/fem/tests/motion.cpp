#include "common/experiments/verification/spin_verification.hpp"
#include "common/experiments/verification/static_verification.hpp"
#include "common/fem/stiffness_assembly.hpp"
#include "common/fem/surface_embedding.hpp"
#include "common/fem/tests/bodies.hpp"
#include "common/geometry/surface_extraction.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <memory>
#include <utility>

using namespace enduring;
using namespace enduring::test;

namespace {

const Vec3 gravity(0, -9.81, 0);

void run(ElasticBody& body, const Vec3& pull, double dt, int steps)
{
    for (int step = 0; step < steps; ++step) {
        body.predict(pull, dt);
        body.commit(dt);
    }
}

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

TEST_CASE(
    "elastic body: impulses that mend others change the velocities as all of them at once do, and cost less")
{
    const ElasticMesh mesh = elastic(small_bar(), Basis::quadratic);
    for (const double tolerance : {1e-10, 1e-5}) {
        CAPTURE(tolerance);
        const NodalVectors large = random_field(mesh.node_count(), 0.1, 5),
                           small = random_field(mesh.node_count(), 1e-5, 6);
        const auto bent = [&] {
            auto body = std::make_unique<ElasticBody>(mesh, ElasticMaterial{.young = 1e5, .poisson = 0.3},
                                                      ElasticOptions{.solver_tolerance = tolerance});
            body->velocities() = random_field(body->node_count(), 2, 7);
            run(*body, gravity, 0.01, 20);
            body->predict(gravity, 0.01);
            return body;
        };
        const auto mended = bent(), alone = bent(), exact = bent();
        const NodalVectors before = exact->velocities();
        mended->mend_response(large, 0.01);
        mended->mend_response(small, 0.01);
        alone->respond(small, 0.01);
        exact->respond(large + small, 0.01);
        const double change = (exact->velocities() - before).norm();
        CHECK((mended->velocities() - exact->velocities()).norm() <= 30 * tolerance * change);
        CHECK(mended->solver_iterations() < alone->solver_iterations());
    }
}

TEST_CASE("elastic body: near responses are the same one by one and together, and a fixed node has none")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    body.fix(2);
    const NodalVectors first = random_field(body.node_count(), 0.1, 12),
                       second = random_field(body.node_count(), 0.3, 13);
    std::vector<NodalVectors> together{first, second};
    body.near_responses(together);
    CHECK(together[0].isZero(0));  // before the first prediction
    body.predict(gravity, 0.01);
    together = {first, second};
    body.near_responses(together);
    CHECK((together[0] - body.near_response(first)).norm() <= 1e-5 * together[0].norm());
    CHECK((together[1] - body.near_response(second)).norm() <= 1e-5 * together[1].norm());
    CHECK(together[1].col(2).isZero(0));
    CHECK(together[1].norm() > 0);
}

TEST_CASE("elastic body: what pushes a fixed node is felt nowhere, also by a factor from before it was fixed")
{
    const NodalVectors everywhere = random_field(ElasticMesh(with_edge_midpoints(small_bar())).node_count(),
                                                 0.1, 12);
    NodalVectors elsewhere = everywhere;
    elsewhere.leftCols(3).setZero();
    const auto answers = [](const NodalVectors& impulses) {
        ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
        body.predict(Vec3::Zero(), 0.01);
        for (int node = 0; node < 3; ++node)
            body.fix(node);
        const NodalVectors near = body.near_response(impulses);
        body.respond(impulses, 0.01);
        return std::pair<NodalVectors, NodalVectors>(near, body.velocities());
    };
    const auto [near, velocities] = answers(everywhere);
    const auto [near_of_others, velocities_of_others] = answers(elsewhere);
    CHECK(near == near_of_others);
    CHECK(velocities == velocities_of_others);
    CHECK(velocities.leftCols(3).isZero(0));
    CHECK(velocities.norm() > 0.01);
}

TEST_CASE(
    "elastic body: the assembled matrix and the product without one agree, fixed rows are the identity's")
{
    for (Basis basis : both_bases) {
        CAPTURE(name_of(basis));
        const ElasticMesh mesh = elastic(small_bar(), basis);
        ElementRotations rotations;
        find_rotations(mesh, random_rotation(2) * (mesh.rest() + random_field(mesh.node_count(), 0.03, 1)),
                       rotations);
        const CorotatedElasticity elasticity(mesh, lame_constants({}), rotations);
        const Eigen::SparseMatrix<double> masses = mass_matrix(mesh, 1000);
        std::vector<char> fixed(mesh.node_count(), 0);
        fixed[3] = 1;
        StiffnessAssembly assembly(mesh);
        assembly.assemble(elasticity, masses, fixed, 9, 9);  // twice: nothing of the first may remain
        const Eigen::MatrixXd lower = assembly.assemble(elasticity, masses, fixed, 2, 0.5);
        const Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();

        NodalVectors v = random_field(mesh.node_count(), 1, 3);
        NodalVectors unfixed = v;
        unfixed.col(3).setZero();
        NodalVectors product = 2 * (unfixed * masses);
        elasticity.add_stiffness_times(unfixed, 0.5, product);
        product.col(3) = v.col(3);
        CHECK((full * v.reshaped() - product.reshaped()).norm() <= 1e-12 * product.norm());
    }
}

TEST_CASE("elastic body: conjugate gradients with an old, turned factor give the direct solution")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {.young = 1e6, .poisson = 0.45});
    body.velocities() = 3 * random_field(body.node_count(), 1, 5);
    body.velocities().row(2) += 20 * body.positions().row(0);
    const double dt = 0.01;
    for (int step = 0; step < 30; ++step) {
        CAPTURE(step);
        ElementRotations rotations;
        find_rotations(body.mesh(), body.positions(), rotations);
        const CorotatedElasticity elasticity(body.mesh(), lame_constants(body.material()), rotations);
        NodalVectors forces = NodalVectors::Zero(3, body.node_count());
        elasticity.add_forces(body.positions(), forces);
        const NodalVectors rhs = body.momenta() + dt * forces;
        const Eigen::MatrixXd lower = StiffnessAssembly(body.mesh())
                                          .assemble(elasticity, body.mass_matrix(),
                                                    std::vector<char>(body.node_count(), 0), 1, dt * dt);
        const Eigen::VectorXd direct =
            Eigen::MatrixXd(lower.selfadjointView<Eigen::Lower>()).ldlt().solve(rhs.reshaped());
        run(body, Vec3::Zero(), dt, 1);
        CHECK((body.velocities().reshaped() - direct).norm() <= 1e-8 * direct.norm());
    }
    CHECK(body.factorisations() < 10);
}

TEST_CASE("elastic body: a body that only turns keeps its factor and needs no second iteration")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    for (int turn = 0; turn < 20; ++turn) {
        body.place(random_rotation(100 + turn), Vec3(0, 0, 0.1));
        body.velocities() = random_field(body.node_count(), 1, turn);
        body.predict(Vec3::Zero(), 0.01);  // not committed: the shape stays
        CHECK(body.solver_iterations() <= 2);
    }
    CHECK(body.factorisations() == 1);
}

TEST_CASE("elastic body: a step of another length is another system, and gets a factor of its own")
{
    ElasticBody body(elastic(small_bar(), Basis::linear), {.young = 1e5}),
        fresh(elastic(small_bar(), Basis::linear), {.young = 1e5});
    body.predict(Vec3::Zero(), 0.001);
    body.predict(Vec3::Zero(), 0.1);
    CHECK(body.factorisations() == 2);
    body.predict(Vec3::Zero(), 0.1);
    CHECK(body.factorisations() == 2);
    fresh.predict(Vec3::Zero(), 0.1);
    const NodalVectors impulses = random_field(body.node_count(), 0.1, 4);
    CHECK((body.near_response(impulses) - fresh.near_response(impulses)).norm() <=
          1e-6 * fresh.near_response(impulses).norm());
}

TEST_CASE("elastic body: an impulse answered after the prediction equals the force that it is over the step")
{
    const double dt = 0.01;
    const ElasticMaterial material{.mass_damping = 0.5, .stiffness_damping = 0.01};
    ElasticBody pushed(elastic(small_bar(), Basis::quadratic), material),
        forced(elastic(small_bar(), Basis::quadratic), material);
    for (ElasticBody* body : {&pushed, &forced}) {
        body->velocities() = random_field(body->node_count(), 1, 4);
        run(*body, gravity, dt, 5);
    }
    const NodalVectors impulses = random_field(pushed.node_count(), 0.1, 12);
    pushed.predict(gravity, dt);
    pushed.respond(impulses, dt);
    forced.external_forces() = impulses / dt;
    forced.predict(gravity, dt);
    CHECK((pushed.velocities() - forced.velocities()).norm() <= 1e-8 * forced.velocities().norm());
    CHECK((pushed.linear_momentum() - forced.linear_momentum()).norm() <= 1e-13 * pushed.mass());
}

TEST_CASE("elastic body: a change that repeats, of a fall or of an impulse, needs no second iteration")
{
    ElasticBody body(elastic(small_bar(), Basis::quadratic), {});
    body.velocities() = NodalVectors::Ones(3, body.node_count());
    run(body, gravity, 0.01, 1);
    run(body, gravity, 0.01, 1);
    CHECK(body.solver_iterations() == 0);
    const NodalVectors impulses = random_field(body.node_count(), 0.1, 12);
    body.respond(impulses, 0.01);
    CHECK(body.solver_iterations() > 0);
    body.respond(0.5 * impulses, 0.01);
    CHECK(body.solver_iterations() == 0);
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

TEST_CASE(
    "surface embedding: rest positions are the surface's, and follow the curved edge of the Bernstein form")
{
    const QuadraticTetrahedralMesh mesh = with_edge_midpoints(small_bar());
    const ExtractedSurface surface = surface_of(mesh);
    const SurfaceEmbedding embedding(mesh, surface.nodes);
    const ElasticMesh elements(mesh);
    std::vector<Vec3> positions(surface.nodes.size());
    embedding.evaluate(elements.rest(), positions);
    for (std::size_t v = 0; v < positions.size(); ++v)
        CHECK((positions[v] - surface.mesh.vertices[v]).norm() <= 1e-15);

    // A quadratic motion is a member of the space: y += x^2 with control
    // points from polarisation, y_ab += x_a x_b.
    NodalVectors curved = elements.rest();
    for (const auto& element : mesh.elements)
        for (std::size_t i = 0; i < 10; ++i) {
            const auto [a, b] = i < 4 ? std::array{int(i), int(i)} : tetrahedron_edges[i - 4];
            const int node = element[i];
            curved(1, node) = elements.rest()(1, node) +
                              mesh.nodes[element[a]].x() * mesh.nodes[element[b]].x();
        }
    embedding.evaluate(curved, positions);
    for (std::size_t v = 0; v < positions.size(); ++v) {
        const Vec3& p = surface.mesh.vertices[v];
        CHECK((positions[v] - (p + p.x() * p.x() * Vec3::UnitY())).norm() <= 1e-15);
    }
}

TEST_CASE(
    "surface embedding: an impulse on lumped masses keeps its linear momentum, and moves its vertex by the inverse mass there")
{
    const QuadraticTetrahedralMesh mesh = with_edge_midpoints(small_bar());
    const SurfaceEmbedding embedding(mesh, surface_of(mesh).nodes);
    const Vec3 impulse(0.3, -1, 2);
    for (int vertex = 0; vertex < embedding.vertex_count(); ++vertex) {
        CAPTURE(vertex);
        ElasticBody body(ElasticMesh(mesh), {});
        embedding.apply_impulse(vertex, impulse, body.inverse_masses(), body.velocities());
        const Vec3 change = embedding.at(vertex, body.velocities());
        CHECK((body.linear_momentum() - impulse).norm() <= 1e-13);
        CHECK((change - embedding.inverse_mass(vertex, body.inverse_masses()) * impulse).norm() <=
              1e-13 * change.norm());
        const double of_lumps = 0.5 * body.velocities().colwise().squaredNorm() * body.masses();
        CHECK(of_lumps == doctest::Approx(0.5 * impulse.dot(change)));  // the work the impulse did
        CHECK(body.kinetic_energy() < 0.9 * of_lumps);  // between the nodes the body lags behind them
    }
    const std::vector<int> wrong{0, 9999};
    CHECK_THROWS_AS(SurfaceEmbedding(mesh, wrong), InputError);
}
