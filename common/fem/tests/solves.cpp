#include "common/fem/stiffness_assembly.hpp"
#include "common/fem/tests/bodies.hpp"

#include <doctest/doctest.h>
#include <Eigen/Dense>

#include <memory>
#include <utility>

using namespace enduring;
using namespace enduring::test;

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
