#include "chapters/07_implicit_contact/tests/only_island.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

/// An edge of a block that stands upright, along x and at this height.
Edge edge_along_x(const Body& block, double height)
{
    for (const Edge& edge : block.surface().edges()) {
        const Vec3 &a = block.positions_t0()[static_cast<std::size_t>(edge[0])],
                   &b = block.positions_t0()[static_cast<std::size_t>(edge[1])];
        if (std::abs(a.y() - height) < 1e-9 && (b - a).cross(Vec3::UnitX()).norm() < 1e-9)
            return edge;
    }
    FAIL("no such edge");
    return {};
}

/// An edge of a cube's lower side above an edge of another one's upper side, which stands still.
struct CrossingEdges {
    World world;
    Contacts contacts;

    /// @param angle  between the edges [rad]
    explicit CrossingEdges(double angle)
    {
        world.gravity.setZero();
        const SurfaceMesh block = box({1, 1, 1});
        SurfaceMesh cube = box({1, 1, 1});
        for (Vec3& x : cube.vertices)
            x = Eigen::AngleAxisd(angle, Vec3::UnitY()) * x + Vec3::UnitY();
        world.bodies.push_back(std::make_unique<StaticBody>(
            "block", SurfaceTopology(static_cast<int>(block.vertices.size()), block.faces), block.vertices));
        world.bodies.push_back(std::make_unique<RigidBody>("cube", cube, mass_properties(cube, 1000)));
        for (const auto& body : world.bodies)
            body->predict(Vec3::Zero(), dt);
        // both have the same edges
        const Edge a = edge_along_x(*world.bodies[0], -0.5), b = edge_along_x(*world.bodies[0], 0.5);
        Contact pair{ContactKind::edge_edge, 1, 0, 0, 0, {a[0], a[1], b[0], b[1]}, {0.5, 0.5, -0.5, -0.5}};
        pair.orientation = 1;
        contacts.push_back(pair);
    }

    /// The cube will have turned about its centre at the end of the step, by about this angle [rad].
    void turn(const Vec3& axis, double angle)
    {
        Body& cube = *world.bodies[1];
        constexpr double inertia = 1000.0 / 6,
                         levers = 4;  // sum of the squares over eight corners, across an axis
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 lever = cube.positions_t0()[static_cast<std::size_t>(corner)] - cube.centre();
            cube.apply_impulse(corner, inertia / levers * angle / dt * axis.cross(lever));
        }
        cube.update_prediction(dt);
    }
};

/// By how much the pair's normal turns when the cube turns after the problem has been set up [rad].
double turn_of_normal(double sine)
{
    CrossingEdges edges(std::asin(sine));
    StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true);
    REQUIRE(step.problem.rows.size() == 1);
    const Vec3 before = step.problem.rows[0].law.normal;
    edges.turn(Vec3::UnitZ(), 0.05);
    update_kinematics(edges.world, step);
    return std::acos(std::min(1.0, before.dot(step.problem.rows[0].law.normal)));
}

}  // namespace

TEST_CASE("step problem: the normal of two edges follows the bodies")
{
    // An edge that turns by 0.05 out of the plane of both turns their normal by 0.05 over their sine.
    for (const double sine : {0.11, 0.2, 0.7, 1.0})
        CHECK(turn_of_normal(sine) == doctest::Approx(std::atan(0.05 / sine)).epsilon(0.05));
}

TEST_CASE("step problem: a pair that is held, or has been resolved, has no row")
{
    CrossingEdges edges(0.7);
    CHECK(set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true).problem.rows.size() == 1);
    edges.contacts[0].resolved = true;
    CHECK(set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true).problem.rows.empty());
    edges.contacts[0].resolved = false;
    edges.contacts[0].hold(true);
    CHECK(set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true).problem.rows.empty());
}

TEST_CASE("step problem: how fast a pair slips is its speed along the surface")
{
    CrossingEdges edges(0.7);
    edges.contacts[0].spring.stiffness = 1000;
    StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {0.1, 0.1}, {1, dt}, true);
    REQUIRE(step.problem.rows.size() == 1);
    PairRow& row = step.problem.rows[0];
    row.law.normal = Vec3::UnitY();
    row.law.mu = 0.1;
    row.law.lagged_normal_impulse = 1e-3;
    row.law.depth_t0 = 0;
    row.velocity = Vec3(1, -5, 0);
    find_slip(step);
    CHECK(edges.contacts[0].spring.slip == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE(
    "step problem: what slides round a bend is pushed along the mean of two paths' normals, and is as deep at the end as without")
{
    for (const double bend : {0.02, 0.3}) {
        CAPTURE(bend);
        const auto row_with = [](const Vec3& sliding_normal) {
            CrossingEdges edges(1.2);
            Body& cube = *edges.world.bodies[1];
            edges.turn(Vec3::UnitY(), 0.1);
            cube.commit(dt);
            cube.predict(Vec3::Zero(), dt);  // turns on, so that levers change in the step
            cube.apply_impulse(0, {900, -400, 0});
            cube.update_prediction(dt);
            edges.contacts[0].sliding_normal = sliding_normal;
            StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true);
            update_kinematics(edges.world, step);
            const Eigen::MatrixXd middle =
                0.5 * (cube.contact_coordinates().contact_motion(step.vertices[0], 0, 0.5).rate +
                       cube.contact_coordinates().contact_motion(step.vertices[0], 1, 0.5).rate);
            return std::pair(step.problem.rows.at(0), middle);
        };
        const auto [plain, middle] = row_with(Vec3::Zero());
        const Vec3 came = Eigen::AngleAxisd(bend, Vec3::UnitZ()) * plain.law.normal;
        const PairRow row = row_with(came).first;
        REQUIRE(row.part_count == 1);
        CHECK((row.parts[0].rate - middle).norm() < 1e-12);
        CHECK((plain.parts[0].rate - middle).norm() > 1e-3);

        // the other side of the mean is the normal of this step's path
        const Vec3 path = 2 * row.law.normal.dot(came) * row.law.normal - came;
        const double a = came.dot(row.velocity), b = plain.law.normal.dot(row.velocity);
        const double over = std::clamp(a / (a - b), 0.0, 1.0);
        CHECK((path - (came + over * (plain.law.normal - came)).normalized()).norm() < 1e-9);
        CHECK(row.law.depth_t0 + dt * row.law.normal.dot(row.velocity) ==
              doctest::Approx(plain.law.depth_t0 + dt * plain.law.normal.dot(plain.velocity)).epsilon(1e-9));
    }
}

TEST_CASE(
    "step problem: a pair has the coefficients of its two materials, and those of the scene where it has none")
{
    for (const bool slips : {false, true}) {
        CAPTURE(slips);
        const auto mu_of = [&](int block, int cube) {
            CrossingEdges edges(1);
            edges.contacts[0].spring.slip = slips ? 1e6 : 0;
            edges.contacts[0].spring.load = 1;
            edges.world.friction = {2, std::vector<FrictionCoefficients>(9)};
            for (std::size_t i = 0; i < 9; ++i)
                edges.world.friction.between[i] = {static_cast<double>(i), 0.5 * static_cast<double>(i)};
            edges.world.bodies[0]->set_material(block);
            edges.world.bodies[1]->set_material(cube);
            const StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {0.7, 0.6}, {1, dt},
                                                        true);
            return step.problem.rows.at(0).law.mu;
        };
        const double part = slips ? 0.5 : 1;
        CHECK(mu_of(MaterialFriction::none, MaterialFriction::none) == (slips ? 0.6 : 0.7));
        CHECK(mu_of(0, MaterialFriction::none) == 1 * part);
        CHECK(mu_of(MaterialFriction::none, 1) == 6 * part);
        CHECK(mu_of(0, 1) == 7 * part);
        CHECK(mu_of(1, 0) == 5 * part);
        CHECK(mu_of(1, 1) == 8 * part);
    }
}

TEST_CASE("step problem: a surface that runs moves a pair against its other body, along the surface alone")
{
    for (const bool of_a : {false, true}) {
        CAPTURE(of_a);
        CrossingEdges edges(1);
        edges.world.bodies[of_a ? 1 : 0]->set_surface_velocity(Vec3(2, 5, -1));
        StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true);
        update_kinematics(edges.world, step);
        const Vec3 expected = (of_a ? 1 : -1) * Vec3(2, 0, -1);  // the cube stands
        CHECK((step.problem.rows.at(0).velocity - expected).norm() < 1e-12);
    }
}

TEST_CASE(
    "step problem: a pair along whose normal a lock holds the body has no row, and it has one along other normals")
{
    for (const Vec3& free : {Vec3(1, 0, 1), Vec3(0, 1, 0)}) {
        CAPTURE(free.transpose());
        CrossingEdges edges(1);
        dynamic_cast<RigidBody&>(*edges.world.bodies[1]).hold({free, Vec3::Zero()});
        const StepProblem step = set_up_only_island(edges.world, edges.contacts, {}, {}, {1, dt}, true);
        CHECK(step.problem.rows.size() == (free.y() > 0 ? 1 : 0));
    }
}
