#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

const PenaltyMethod both[] = {PenaltyMethod::discrete, PenaltyMethod::continuous};
const double side = 0.2, k = 300;

/// A cube of 1 kg whose lowest face hangs 0.1 m above a plane, all of it
/// turned by `turn`: plane, gravity and cube.
World cube_above_plane(const Quaternion& turn = Quaternion::Identity(),
                       const Quaternion& tilt = Quaternion::Identity())
{
    SurfaceMesh mesh = box(Vec3::Constant(side));
    for (Vec3& vertex : mesh.vertices)
        vertex = turn * (tilt * vertex + Vec3(0, 0.1 + side / 2, 0));
    World world;
    world.gravity = turn * Vec3(0, -9.81, 0);
    world.planes.push_back({"ground", Vec3::Zero(), turn * Vec3::UnitY()});
    world.bodies.push_back(std::make_unique<RigidBody>("cube", mesh, with_mass(mass_properties(mesh, 1), 1)));
    return world;
}

Vec3 centre(const World& world)
{
    return static_cast<const RigidBody&>(*world.bodies[0]).motion().pose().position;
}

Solver solver_of(PenaltyMethod method) { return chapter01_solver({method, k}); }

}  // namespace

TEST_CASE("plane contact: a rigid cube that falls flat is a particle on a spring of four times the stiffness")
{
    for (const PenaltyMethod method : both) {
        CAPTURE(short_name(method));
        const double dt = 0.005;
        World world = cube_above_plane();
        Contacts contacts;
        ParticleState particle{0.1, 0};
        double largest_difference = 0;
        for (int i = 0; i < 400; ++i) {
            advance(world, contacts, solver_of(method), dt);
            particle = step(particle, {1, 4 * k, 9.81, method, dt});
            largest_difference = std::max(largest_difference,
                                          std::abs(centre(world).y() - side / 2 - particle.height));
        }
        CHECK(largest_difference <= 1e-9);
        CHECK(contacts.size() == 4);
    }
}

TEST_CASE("plane contact: a plane with a stiffness of its own takes that, whatever all pairs have")
{
    for (const PenaltyMethod method : both) {
        CAPTURE(short_name(method));
        const double dt = 0.005;
        World with_its_own = cube_above_plane(), with_that_of_all = cube_above_plane();
        with_its_own.planes[0].stiffness = k;
        Contacts first, second;
        for (int i = 0; i < 100; ++i) {
            advance(with_its_own, first, chapter01_solver({method, k / 50}), dt);
            advance(with_that_of_all, second, solver_of(method), dt);
        }
        CHECK(first.size() == 4);
        CHECK(centre(with_its_own) == centre(with_that_of_all));
    }
}

TEST_CASE(
    "plane contact: at rest the four impulses carry the weight, at the depth that the particle predicts")
{
    for (const PenaltyMethod method : both) {
        CAPTURE(short_name(method));
        const double dt = 0.01;
        World world = cube_above_plane();
        Contacts contacts;
        for (int i = 0; i < 1500; ++i)
            advance(world, contacts, solver_of(method), dt);
        Vec3 sum = Vec3::Zero();
        for (const Contact& contact : contacts)
            sum += contact.impulse;
        CHECK((sum / dt - Vec3(0, 9.81, 0)).norm() <= 1e-8);
        CHECK(centre(world).y() - side / 2 ==
              doctest::Approx(resting_height({1, 4 * k, 9.81, method, dt})).epsilon(1e-8));
    }
}

TEST_CASE("plane contact: a cube's longest step is set by rocking, not by bouncing")
{
    // About a horizontal axis through the middle: four springs k at s/2
    // against the inertia m s^2 / 6, that is 6 k / m.
    const double rocking_limit = std::sqrt(2.0 / (6 * k)), bouncing_limit = std::sqrt(2.0 / (4 * k));
    const auto last_spin = [](double tilt, double dt) {
        World world = cube_above_plane(Quaternion::Identity(),
                                       Quaternion(Eigen::AngleAxisd(tilt, Vec3::UnitZ())));
        Contacts contacts;
        double fastest = 0;
        for (int i = 0; i < 600; ++i) {
            advance(world, contacts, solver_of(PenaltyMethod::continuous), dt);
            if (i >= 500)
                fastest = std::max(
                    fastest,
                    static_cast<const RigidBody&>(*world.bodies[0]).motion().angular_velocity().norm());
        }
        return fastest;
    };
    const double between = 0.5 * (rocking_limit + bouncing_limit), tilt = 0.02;
    CHECK(last_spin(tilt, 0.95 * rocking_limit) <= 1e-9);
    CHECK(last_spin(tilt, between) >= 0.01);
    CHECK(last_spin(0, between) <= 1e-12);
}

TEST_CASE("plane contact: a plane in any direction answers alike")
{
    const Quaternion turn(Eigen::AngleAxisd(2.1, Vec3(1, 2, -2).normalized()));
    const Quaternion tilt(Eigen::AngleAxisd(0.5, Vec3(3, 1, 2).normalized()));
    for (const PenaltyMethod method : both) {
        World level = cube_above_plane(Quaternion::Identity(), tilt), turned = cube_above_plane(turn, tilt);
        Contacts of_level, of_turned;
        std::size_t pushes = 0;
        for (int i = 0; i < 60; ++i) {
            advance(level, of_level, solver_of(method), 0.005);
            advance(turned, of_turned, solver_of(method), 0.005);
            CHECK(of_turned.size() == of_level.size());
            pushes += of_level.size();
        }
        CHECK(pushes > 10);
        CHECK((turn * centre(level) - centre(turned)).norm() <= 1e-9);
    }
}

TEST_CASE("plane contact: impulses at a tilted cube's corners balance its momenta")
{
    World world = cube_above_plane(Quaternion::Identity(),
                                   Quaternion(Eigen::AngleAxisd(0.5, Vec3(3, 1, 2).normalized())));
    world.gravity.setZero();
    Body& cube = *world.bodies[0];
    cube.apply_impulse(0, Vec3(0, -4, 0));  // thrown at the ground, spinning
    cube.commit(0);
    Contacts contacts;
    Vec3 momentum = cube.linear_momentum(), spin = cube.angular_momentum(Vec3::Zero());
    int pushes = 0;
    for (int i = 0; i < 100; ++i) {
        const std::vector<Vec3> before(cube.positions_t0().begin(), cube.positions_t0().end());
        advance(world, contacts, solver_of(PenaltyMethod::continuous), 0.005);
        for (const Contact& contact : contacts) {
            momentum += contact.impulse;
            spin += before[contact.feature_a].cross(contact.impulse);
            pushes += contact.impulse.y() > 0;
        }
    }
    CHECK(pushes > 3);
    CHECK((cube.linear_momentum() - momentum).norm() <= 1e-12);
    CHECK((cube.angular_momentum(Vec3::Zero()) - spin).norm() <= 1e-12);
}

TEST_CASE("plane contact: a contact begins where the vertex goes under and ends when it has left")
{
    World world = cube_above_plane();
    world.gravity.setZero();
    Body& cube = *world.bodies[0];
    for (int vertex = 0; vertex < 8; ++vertex)
        cube.apply_impulse(vertex, Vec3(0, -2.0 / 8, 0));  // 2 m/s downwards
    cube.commit(0);
    const double dt = 0.08;  // 0.1 m of air, 0.16 m a step: under after 0.625 of the first
    cube.predict(world.gravity, dt);
    Contacts contacts;
    detect_plane_contacts(world, contacts);
    REQUIRE(contacts.size() == 4);
    for (const Contact& contact : contacts) {
        CHECK(contact.start == doctest::Approx(0.625));
        CHECK_FALSE(contact.answered());
    }
    detect_plane_contacts(world, contacts);
    CHECK(contacts.size() == 4);  // known already

    push_apart(world, contacts, continuous_on_plane, k, dt);
    apply_impulses(world, contacts);
    const Vec3 once = contacts[0].impulse;
    const double speed = cube.velocity(0).y();
    push_apart(world, contacts, continuous_on_plane, k, dt);
    apply_impulses(world, contacts);
    CHECK(contacts[0].impulse == once);  // answered: pushed once
    CHECK(cube.velocity(0).y() == speed);

    resolve_plane_contacts(world, contacts);
    CHECK(contacts.empty());  // at the start of this step the cube was still outside
}

namespace {

/// One particle of 1 kg, and planes through the origin.
World particle_at(const Vec3& place, const Vec3& velocity, const std::vector<Vec3>& normals)
{
    World world;
    world.gravity.setZero();
    world.bodies.push_back(std::make_unique<PointMasses>("particle", std::vector<Vec3>{place},
                                                         std::vector<Face>{}, 1.0, velocity));
    for (const Vec3& normal : normals)
        world.planes.push_back({"plane", Vec3::Zero(), normal});
    return world;
}

Contact particle_on_plane(int plane)
{
    return {ContactKind::vertex_plane, 0, plane, 0, -1, {0, -1, -1, -1}, {1, 0, 0, 0}};
}

}  // namespace

TEST_CASE("plane contact: a vertex exactly on the plane keeps its contact, one a hair above it does not")
{
    for (const double height : {-1e-15, 0.0, 1e-15}) {
        CAPTURE(height);
        World world = particle_at({0, height, 0}, Vec3::Zero(), {Vec3::UnitY()});
        Contacts contacts{particle_on_plane(0)};
        resolve_plane_contacts(world, contacts);
        CHECK(contacts.size() == (height > 0 ? 0 : 1));
    }
}

TEST_CASE(
    "plane contact: a vertex in a corner is pushed by the wall along the wall's normal, besides the floor")
{
    // On the floor already, 0.1 m in front of the wall, which it passes in the middle of the step.
    const double dt = 0.1;
    World world = particle_at({0.1, -0.2, 0}, {-2, 0, 0}, {Vec3::UnitY(), Vec3::UnitX()});
    Contacts contacts{particle_on_plane(0)};
    world.bodies[0]->predict(world.gravity, dt);
    detect_plane_contacts(world, contacts);
    REQUIRE(contacts.size() == 2);
    push_apart(world, contacts, continuous_on_plane, k, dt);
    CHECK((contacts[0].impulse - Vec3(0, k * dt * 0.2, 0)).norm() <= 1e-12);
    CHECK((contacts[1].impulse - Vec3(k * dt * 0.1 / 4, 0, 0)).norm() <= 1e-12);

    // Answered once, and never again in this step, however deep it lies then.
    apply_impulses(world, contacts);
    world.bodies[0]->apply_impulse(0, {0, -7, 0});
    world.bodies[0]->update_prediction(dt);
    push_apart(world, contacts, continuous_on_plane, k, dt);
    CHECK((contacts[0].impulse - Vec3(0, k * dt * 0.2, 0)).norm() <= 1e-12);
}
