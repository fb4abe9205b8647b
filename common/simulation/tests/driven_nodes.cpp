#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/tests/run_until.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

constexpr double young = 1e6, stretch = 0.01;

/// A bar of 1 x 0.2 x 0.2 m whose left end is fixed, and whose right end moves as given.
World held_bar(const GivenMotion& motion, bool all_driven = false)
{
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
    DeformableSettings settings;
    settings.material = {.young = young, .poisson = 0, .density = 1000, .stiffness_damping = 0.02};
    settings.driven_nodes.push_back({{}, motion, Vec3::Zero()});
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        if (all_driven || mesh.nodes[node].x() > 0.49)
            settings.driven_nodes.front().nodes.push_back(static_cast<int>(node));
        else if (mesh.nodes[node].x() < -0.49)
            settings.fixed_nodes.push_back(static_cast<int>(node));
    World world;
    world.gravity.setZero();
    world.bodies.push_back(std::make_unique<DeformableBody>("bar", mesh, settings));
    return world;
}

/// Elastic forces where the step ends.
Solver settling()
{
    Solver solver;
    solver.append(StepStage::refresh, "find elastic ends", [](World& world, Contacts&, double dt) {
        dynamic_cast<DeformableBody&>(*world.bodies[0]).reach_end(dt);
    });
    return solver;
}

GivenMotion pull()
{
    return GivenMotion::through(
        {{0, Vec3::Zero(), Vec3::Zero()}, {1, stretch * Vec3::UnitX(), Vec3::Zero()}});
}

}  // namespace

TEST_CASE(
    "driven nodes: a bar that is pulled holds E e^2 V / 2, and what pulls has given that and the damping's heat")
{
    World world = held_bar(pull());
    run_until(world, 2, 0.01);
    const double expected = young * stretch * stretch * 0.04 / 2;
    CHECK(total_energy(world).elastic == doctest::Approx(expected).epsilon(1e-3));
    CHECK(total_energy(world).kinetic < 1e-6 * expected);
    CHECK(world.driven > total_energy(world).total());
    CHECK(world.driven <
          1.25 * expected);  // damping's heat is 5 percent; the rest is what the step itself damps
}

TEST_CASE(
    "driven nodes: a bar that is pulled, turned and let settle in each step ends as without, and what pulls has given as much")
{
    const GivenMotion motion = GivenMotion::through(
        {{0, Vec3::Zero(), Vec3::Zero()}, {1, stretch * Vec3::UnitX(), 0.2 * Vec3::UnitX()}});
    World linear = held_bar(motion), settled = held_bar(motion);
    run_until(linear, 1.5, 0.01);
    run_until(settled, 1.5, 0.01, settling());
    CHECK(total_energy(settled).elastic == doctest::Approx(total_energy(linear).elastic).epsilon(1e-4));
    CHECK(settled.driven == doctest::Approx(linear.driven).epsilon(1e-2));
}

TEST_CASE(
    "driven nodes: a body whose nodes are all driven moves as one, and its surface has the velocity of the motion")
{
    World world = held_bar(GivenMotion::steady({1, 2, 0}, {0, 0, 3}), true);
    const Body& body = *world.bodies[0];
    const std::vector<Vec3> start(body.positions_t0().begin(), body.positions_t0().end());
    constexpr double dt = 1e-3;
    run_until(world, 0.3, dt);
    const Mat3 turn = Eigen::AngleAxisd(0.9, Vec3::UnitZ()).toRotationMatrix();
    for (std::size_t v = 0; v < start.size(); ++v) {
        const Vec3 expected = 0.3 * Vec3(1, 2, 0) + turn * start[v];
        CHECK((body.positions_t0()[v] - expected).norm() < 1e-9);
        // a step's secant, so half a step behind
        const Vec3 velocity = Vec3(1, 2, 0) + Vec3(0, 0, 3).cross(turn * start[v]);
        CHECK((body.velocity(static_cast<int>(v)) - velocity).norm() < 5 * dt);
    }
    CHECK(world.driven == doctest::Approx(total_energy(world).total()).epsilon(1e-6));
}

TEST_CASE("driven nodes: an impulse on them does not move them, and what holds them pays for its work")
{
    World world = held_bar(GivenMotion::steady({2, 0, 0}, Vec3::Zero()), true);
    Body& body = *world.bodies[0];
    body.predict(Vec3::Zero(), 0.01);
    const double before = body.driven_work(0.01);
    body.apply_impulse(3, {-5, 1, 0});
    CHECK(body.driven_work(0.01) - before == doctest::Approx(10));
    body.update_prediction(0.01);
    CHECK((body.velocity(3) - Vec3(2, 0, 0)).norm() < 1e-12);
}

TEST_CASE(
    "driven nodes: what holds them pays for the momentum that each change of the body would give to them")
{
    constexpr double dt = 0.01;
    const Vec3 velocity(2, -3, 1), impulse(4, -5, 3);
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {4, 1, 1});
    DeformableSettings settings;
    settings.material = {.young = young, .poisson = 0.3, .density = 1000};
    settings.driven_nodes.push_back({{}, GivenMotion::steady(velocity, Vec3::Zero()), Vec3::Zero()});
    std::vector<int>& held = settings.driven_nodes.front().nodes;
    for (std::size_t node = 0; node < mesh.nodes.size(); ++node)
        if (mesh.nodes[node].x() < -0.49)
            held.push_back(static_cast<int>(node));
    DeformableBody body("bar", mesh, settings);
    body.predict(Vec3::Zero(), dt);
    // on a vertex that is held, and on one beside those
    const auto vertex_at = [&](double x) {
        int vertex = 0;
        while (std::abs(mesh.nodes[static_cast<std::size_t>(vertex)].x() - x) > 0.01)
            ++vertex;
        return std::vector<int>{vertex};
    };
    const auto pays = [&](const auto& change) {
        const auto momentum = [&] {
            return Vec3(body.elastic().momenta()(Eigen::all, held).rowwise().sum());
        };
        const double work = body.driven_work(dt);
        const Vec3 before = momentum();
        change();
        const double met = velocity.dot(momentum() - before);
        CHECK(std::abs(met) > 1e-3);
        CHECK(body.driven_work(dt) - work == doctest::Approx(met).epsilon(1e-9));
    };
    pays([&] { body.reach_end(dt); });
    const double work = body.driven_work(dt);
    body.apply_contact_impulse(vertex_at(-0.5), impulse);
    CHECK(body.driven_work(dt) - work == doctest::Approx(-impulse.dot(velocity)));
    body.apply_contact_impulse(vertex_at(-0.25), impulse);
    pays([&] { body.update_prediction(dt); });
    pays([&] { body.approach_end(dt); });
}
