#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>
#include <Eigen/SparseCholesky>

#include <memory>

using namespace enduring;

namespace {

std::unique_ptr<DeformableBody> soft_bar(ImpulseResponse response, bool quadratic)
{
    DeformableSettings settings;
    settings.material.density = 100;
    settings.material.young = 5e4;
    settings.material.poisson = 0.3;
    settings.impulse_response = response;
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
    if (quadratic)
        return std::make_unique<DeformableBody>("bar", with_edge_midpoints(mesh), settings);
    return std::make_unique<DeformableBody>("bar", mesh, settings);
}

/// Velocity that an impulse at vertex 0 gives that vertex within one step.
Vec3 answer(ImpulseResponse response, bool quadratic, double dt)
{
    const auto body = soft_bar(response, quadratic);
    body->predict(Vec3::Zero(), dt);
    body->apply_impulse(0, {0, 1, 0});
    body->update_prediction(dt);
    return body->velocity(0);
}

}  // namespace

TEST_CASE(
    "impulse response: the implicit one gives the impulse's momentum, once, and moves nothing before the update")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const auto body = soft_bar(ImpulseResponse::implicit, quadratic);
        const double dt = 0.01;
        body->predict(Vec3::Zero(), dt);
        body->apply_impulse(0, {0.5, -1, 2});
        body->apply_impulse(3, {1, 0, 0});
        CHECK(body->linear_momentum().norm() < 1e-12);
        for (int update = 0; update < 2; ++update) {
            body->update_prediction(dt);
            CHECK((body->linear_momentum() - Vec3(1.5, -1, 2)).norm() < 1e-9);
        }
    }
}

namespace {

/// Velocity of vertex 0 per impulse there, w^T M^-1 w: in a step too short for
/// elasticity its neighbours follow by inertia alone.
double answer_of_inertia(bool quadratic)
{
    const auto body = soft_bar(ImpulseResponse::implicit, quadratic);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(body->elastic().node_count());
    for (const auto& [node, weight] : body->embedding().nodes_of(0))
        weights[node] = weight;
    return weights.dot(
        Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(body->elastic().mass_matrix()).solve(weights));
}

}  // namespace

TEST_CASE(
    "impulse response: the implicit one tends to that of the mass matrix alone as the step shrinks, and is smaller in a longer one")
{
    for (const bool quadratic : {false, true}) {
        CAPTURE(quadratic);
        const Vec3 alone(0, answer_of_inertia(quadratic), 0);
        CHECK((answer(ImpulseResponse::implicit, quadratic, 1e-6) - alone).norm() < 1e-5 * alone.norm());
        CHECK(answer(ImpulseResponse::implicit, quadratic, 0.01).y() < 0.7 * alone.y());
    }
}

TEST_CASE("impulse response: an impulse that nobody updates for is not lost at the end of the step")
{
    const auto body = soft_bar(ImpulseResponse::implicit, false);
    body->predict(Vec3::Zero(), 0.01);
    body->apply_impulse(0, {0, 1, 0});
    body->commit(0.01);
    CHECK((body->linear_momentum() - Vec3(0, 1, 0)).norm() < 1e-9);
}

namespace {

/// The block as one solve a column gives it.
Mat3 solved_inverse_mass(DeformableBody& body, int vertex, double dt)
{
    Mat3 block;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 before = body.velocity(vertex);
        body.apply_impulse(vertex, Vec3::Unit(axis));
        body.update_prediction(dt);
        block.col(axis) = body.velocity(vertex) - before;
        body.apply_impulse(vertex, -Vec3::Unit(axis));
        body.update_prediction(dt);
    }
    return block;
}

}  // namespace

TEST_CASE(
    "impulse response: the implicit inverse mass is what one solve of the elastic system gives, also after a turn")
{
    for (const bool quadratic : {false, true})
        for (const double dt : {0.01, 0.002}) {
            CAPTURE(quadratic);
            CAPTURE(dt);
            const auto body = soft_bar(ImpulseResponse::implicit, quadratic);
            body->predict(Vec3::Zero(), 0.1);
            body->inverse_mass(1);  // of another step: must be forgotten
            body->predict(Vec3::Zero(), dt);
            for (const int vertex : {0, 1, 7}) {
                const Mat3 solved = solved_inverse_mass(*body, vertex, dt);
                CHECK((body->inverse_mass(vertex) - solved).norm() < 1e-5 * solved.norm());
            }
        }
}

TEST_CASE("impulse response: the implicit inverse mass turns with the body")
{
    const double dt = 0.01;
    for (const bool quadratic : {false, true}) {
        DeformableSettings settings;
        settings.material.density = 100;
        settings.material.young = 1e6;
        settings.material.poisson = 0.3;
        settings.impulse_response = ImpulseResponse::implicit;
        settings.angular_velocity = {0, 0, 2};
        const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
        const auto body = quadratic
                              ? std::make_unique<DeformableBody>("bar", with_edge_midpoints(mesh), settings)
                              : std::make_unique<DeformableBody>("bar", mesh, settings);
        body->predict(Vec3::Zero(), dt);
        const Mat3 at_first = body->inverse_mass(1);
        for (int step = 0; step < 78; ++step) {  // a quarter turn
            body->commit(dt);
            body->predict(Vec3::Zero(), dt);
        }
        const Mat3 solved = solved_inverse_mass(*body, 1, dt);
        CHECK((at_first - solved).norm() > 0.1 * solved.norm());
        CHECK((body->inverse_mass(1) - solved).norm() < 0.02 * solved.norm());
    }
}

namespace {

/// Largest part by which the velocities of the touched vertices differ from what the contact mass says, for
/// an impulse on all of them.
double departure_from_mass(DeformableBody& body, const std::vector<int>& touched, double dt)
{
    body.predict(Vec3::Zero(), dt);
    const Eigen::VectorXd impulse = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(3 * touched.size()),
                                                               -1, 2),
                          expected = body.contact_mass(touched).response * impulse;
    Eigen::VectorXd before(impulse.size()), after(impulse.size());
    const auto read = [&](Eigen::VectorXd& velocities) {
        for (std::size_t i = 0; i < touched.size(); ++i)
            velocities.segment<3>(static_cast<Eigen::Index>(3 * i)) = body.velocity(touched[i]);
    };
    read(before);
    body.apply_contact_impulse(touched, impulse);
    body.update_prediction(dt);
    read(after);
    return (after - before - expected).norm() / expected.norm();
}

}  // namespace

TEST_CASE("contact mass: it tells what impulses do, for other vertices and another step too")
{
    for (const ImpulseResponse response : {ImpulseResponse::lumped, ImpulseResponse::implicit}) {
        const auto body = soft_bar(response, true);
        CHECK(departure_from_mass(*body, {0, 3, 5}, 0.01) < 1e-3);
        CHECK(departure_from_mass(*body, {0, 4, 5}, 0.01) < 1e-3);
        CHECK(departure_from_mass(*body, {0, 4, 5}, 0.1) < 1e-3);
    }
}

TEST_CASE(
    "impulse response: a body that settles moves its surface along, and its elements pass on all impulses from there on")
{
    const double dt = 0.01;
    const auto body = soft_bar(ImpulseResponse::lumped, true);
    const auto surface_follows = [&] {
        for (int vertex = 0; vertex < static_cast<int>(body->positions_t1().size()); ++vertex)
            CHECK((body->positions_t1()[static_cast<std::size_t>(vertex)] -
                   body->positions_t0()[static_cast<std::size_t>(vertex)] - dt * body->velocity(vertex))
                      .norm() < 1e-12);
    };
    const std::vector<int> corner{0};
    body->predict(Vec3::Zero(), dt);
    const Vec3 before = body->velocity(0);
    body->apply_contact_impulse(corner, Vec3(0, 5, 5));
    body->update_prediction(dt);
    CHECK((body->velocity(0) - before).norm() > 0.1);
    const Vec3 linear = body->velocity(0);
    body->approach_end(dt);
    CHECK((body->velocity(0) - linear).norm() > 1e-6);
    surface_follows();
    body->apply_contact_impulse(corner, Vec3(0, 5, -5));
    body->update_prediction(dt);
    CHECK(body->reach_end(dt) <= small_imbalance);
    surface_follows();
    const Vec3 settled = body->velocity(0);
    body->apply_impulse(0, Vec3(1, 0, 0));
    CHECK(body->velocity(0) == settled);  // until the update
    body->update_prediction(dt);
    CHECK(body->velocity(0) != settled);
}

TEST_CASE("contact mass: a body tells its mass and its response, and each is the inverse of the other")
{
    const std::vector<int> touched{0, 3, 5};
    for (const ImpulseResponse response : {ImpulseResponse::lumped, ImpulseResponse::implicit}) {
        const auto body = soft_bar(response, true);
        for (int step = 0; step < 3; ++step) {
            body->predict(Vec3::Zero(), 0.01);
            body->commit(0.01);
        }
        body->predict(Vec3::Zero(), 0.01);
        const ContactMass of = body->contact_mass(touched);
        CHECK((of.mass * of.response - Eigen::MatrixXd::Identity(9, 9)).norm() <= 1e-9);
        CHECK((of.response - of.response.transpose()).norm() <= 1e-9 * of.response.norm());
    }
}

TEST_CASE("contact mass: it turns with the body, without being found anew")
{
    const std::vector<int> touched{0, 3, 5};
    DeformableSettings settings;
    settings.impulse_response = ImpulseResponse::implicit;
    settings.angular_velocity = Vec3(0, 0, 100);
    DeformableBody body("bar", bar({1, 0.2, 0.2}, {4, 1, 1}), settings);
    body.predict(Vec3::Zero(), 0.001);
    const Eigen::MatrixXd first = body.contact_mass(touched).mass;
    body.commit(0.001);
    body.predict(Vec3::Zero(), 0.001);
    const Eigen::MatrixXd second = body.contact_mass(touched).mass;
    const Mat3 turn(Eigen::AngleAxisd(std::atan(0.1), Vec3::UnitZ()));  // straight along the tangent
    Eigen::MatrixXd turned = first;
    for (int i = 0; i < 9; i += 3)
        for (int j = 0; j < 9; j += 3)
            turned.block<3, 3>(i, j) = turn * first.block<3, 3>(i, j) * turn.transpose();
    CHECK((second - turned).norm() <= 1e-6 * first.norm());
    CHECK((second - first).norm() > 1e-3 * first.norm());
}

TEST_CASE("contact mass: where the body has bent it is as if it had never been found before")
{
    const auto asked = soft_bar(ImpulseResponse::implicit, true),
               other = soft_bar(ImpulseResponse::implicit, true);
    std::vector<int> touched;  // all over the bar
    for (int vertex = 0; vertex < asked->surface().vertex_count(); vertex += 3)
        touched.push_back(vertex);
    const double dt = 0.01;
    for (int step = 0; step < 20; ++step)
        for (DeformableBody* body : {asked.get(), other.get()}) {
            body->predict(Vec3::Zero(), dt);
            if (step == 0 && body == asked.get())
                body->contact_mass(touched);
            for (const int vertex : touched) {  // one end is pushed up, and the other down
                const double x = body->positions_t0()[static_cast<std::size_t>(vertex)].x();
                body->apply_impulse(vertex, {0, std::abs(x - 0.5) < 0.2 ? 0.5 : -0.5, 0});
            }
            body->update_prediction(dt);
            body->commit(dt);
        }
    asked->predict(Vec3::Zero(), dt);
    other->predict(Vec3::Zero(), dt);
    const Eigen::MatrixXd expected = other->contact_mass(touched).mass;
    CHECK((asked->contact_mass(touched).mass - expected).norm() <= 1e-9 * expected.norm());
}

TEST_CASE("contact mass: where only one end has bent it is found anew as well")
{
    const auto asked = soft_bar(ImpulseResponse::implicit, true),
               other = soft_bar(ImpulseResponse::implicit, true);
    std::vector<int> touched;  // all over the bar
    double end = 0;
    for (int vertex = 0; vertex < asked->surface().vertex_count(); vertex += 3) {
        touched.push_back(vertex);
        end = std::max(end, asked->positions_t0()[static_cast<std::size_t>(vertex)].x());
    }
    const double dt = 0.01;
    for (int step = 0; step < 12; ++step)
        for (DeformableBody* body : {asked.get(), other.get()}) {
            body->predict(Vec3::Zero(), dt);
            if (step == 0 && body == asked.get())
                body->contact_mass(touched);
            for (const int vertex : touched)
                if (body->positions_t0()[static_cast<std::size_t>(vertex)].x() > end - 0.2)
                    body->apply_impulse(vertex, {0, 1.5, 0});
            body->update_prediction(dt);
            body->commit(dt);
        }
    asked->predict(Vec3::Zero(), dt);
    other->predict(Vec3::Zero(), dt);
    const Eigen::MatrixXd expected = other->contact_mass(touched).mass;
    CHECK((asked->contact_mass(touched).mass - expected).norm() <= 1e-9 * expected.norm());
}

TEST_CASE("contact mass: after a turn it tells what impulses do, also where more vertices touch than before")
{
    DeformableSettings settings;
    settings.material.density = 100;
    settings.material.young = 5e4;
    settings.impulse_response = ImpulseResponse::implicit;
    settings.angular_velocity = Vec3(0, 0, 8);
    DeformableBody body("bar", bar({1, 0.2, 0.2}, {4, 1, 1}), settings);
    const double dt = 0.01;
    body.predict(Vec3::Zero(), dt);
    body.contact_mass(std::vector<int>{0, 1});
    for (int step = 0; step < 20; ++step) {  // a quarter turn
        body.commit(dt);
        body.predict(Vec3::Zero(), dt);
    }
    body.commit(dt);
    CHECK(departure_from_mass(body, {0, 1, 3, 5, 7}, dt) < 0.02);
}

TEST_CASE(
    "contact mass: a vertex that is held does not move, and the others have the mass that they had without it")
{
    DeformableSettings settings;
    settings.material = {.young = 5e4, .poisson = 0.3, .density = 100};
    settings.impulse_response = ImpulseResponse::implicit;
    settings.fixed_nodes = {0};
    DeformableBody body("bar", bar({1, 0.2, 0.2}, {4, 1, 1}), settings);
    body.predict(Vec3::Zero(), 0.01);
    int held = 0;
    for (int vertex = 0; vertex < body.surface().vertex_count(); ++vertex)
        if (body.inverse_mass(vertex).isZero(0))
            held = vertex;
    const int other = held == 5 ? 6 : 5;
    const Eigen::Matrix3d alone = body.contact_mass(std::vector{other}).response;
    const Eigen::MatrixXd both = body.contact_mass(std::vector{held, other}).response;
    CHECK(both.allFinite());
    CHECK((both.bottomRightCorner<3, 3>() - alone).norm() < 1e-3 * alone.norm());
    CHECK(both.topRows<3>().norm() < 1e-3 * alone.norm());
    CHECK(body.contact_mass(std::vector{held}).mass.allFinite());
}
