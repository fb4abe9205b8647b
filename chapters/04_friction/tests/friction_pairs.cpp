#include "chapters/04_friction/friction_contact.hpp"
#include "chapters/04_friction/mass_splitting_friction.hpp"
#include "chapters/04_friction/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/rigid/mass_properties.hpp"
#include "common/scenes/scene_reader.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>
#include <Eigen/Eigenvalues>

#include <random>

using namespace enduring;

namespace {

const std::array<FrictionParameters, 2> both_models{YamaneNakamura{}, MassSplitting{}};

/// A rigid box thrown on a soft bar that lies on a static floor of triangles, with a rigid ball beside them
/// on a plane: every kind of pair and every pair of kinds of bodies.
Scene heap(const FrictionParameters& model, const std::string& response)
{
    Scene scene = read_scene(R"({"name": "heap", "dt": 0.005, "duration": 1, "contact": {"stiffness": 3000},
        "planes": [{"name": "ground", "point": [0, -0.02, 0]}],
        "bodies": [
          {"name": "floor", "type": "static", "shape": {"plane_grid": {"size": [3, 3], "cells": [5, 5]}}},
          {"name": "bar", "type": "deformable", "basis": "linear", "shape": {"bar": {"size": [1, 0.2, 0.4], "cells": [4, 1, 2]}}, "mass": 8, "young": 2e5,
           "poisson": 0.3, "rayleigh": {"stiffness": 0.01}, "position": [0, 0.13, 0], "velocity": [1, -1, 0.3],
           "rotation": {"axis": [0, 1, 0], "angle_deg": 7}, "impulse_response": ")" +
                                 response + R"("},
          {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.5, 0.2, 0.3]}}, "mass": 3, "position": [0.05, 0.36, 0.02],
           "rotation": {"axis": [0, 1, 0.1], "angle_deg": 31}, "velocity": [-0.5, -2, 0.4], "angular_velocity": [0, 3, 0]},
          {"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.2, "subdivisions": 1}}, "mass": 2, "position": [2, 0.17, 0],
           "velocity": [0.4, -1, 0.2], "angular_velocity": [2, 0, 1]}
        ]})",
                             "", "heap.json", {});
    scene.contact.friction = model;
    if (auto* splitting = std::get_if<MassSplitting>(&scene.contact.friction))
        splitting->spring = scene.contact.stiffness;
    return scene;
}

/// What a run of the heap has to show after every step.
struct Seen {
    int vertex_plane = 0, vertex_face = 0, edge_edge = 0, slipping = 0, holding = 0;
    double worst_normal_part = 0, worst_length = 0;  ///< relative to the friction, and to mu_s |I_n|
    double sum_defect = 0;                           ///< of the weights of pairs of features
};

Seen run_heap(const FrictionParameters& model, const std::string& response)
{
    Scene scene = heap(model, response);
    const Solver solver = chapter04_solver(scene.contact);
    Contacts contacts;
    Seen seen;
    for (int step = 0; step < 80; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        for (const Contact& contact : contacts) {
            const double friction = contact.friction.norm(), normal = contact.impulse.norm();
            if (friction == 0)
                continue;
            seen.vertex_plane += contact.on_plane();
            seen.vertex_face += contact.kind == ContactKind::vertex_face;
            seen.edge_edge += contact.kind == ContactKind::edge_edge;
            seen.slipping += contact.spring.slip > 0;
            seen.holding += contact.spring.slip == 0;
            seen.worst_normal_part = std::max(
                seen.worst_normal_part,
                std::abs(contact.friction.dot(contact.impulse)) / (friction * normal));
            seen.worst_length = std::max(seen.worst_length, friction / (MassSplitting{}.mu_s * normal));
        }
    }
    return seen;
}

}  // namespace

TEST_CASE(
    "friction: tangential to 1e-12 and within mu |f_n| at every pair and step, for all kinds and bodies")
{
    for (const FrictionParameters& model : both_models)
        for (const std::string response : {"lumped", "implicit"}) {
            CAPTURE(response);
            const Seen seen = run_heap(model, response);
            CHECK(seen.vertex_plane > 20);
            CHECK(seen.vertex_face > 20);
            CHECK(seen.edge_edge > 20);
            CHECK(seen.slipping > 20);
            CHECK(seen.holding > 20);
            CHECK(seen.worst_normal_part < 1e-12);
            CHECK(seen.worst_length < 1 + 1e-12);
        }
}

namespace {

/// Two bodies of random points in random pairs of both kinds, p on q at the start of a step,
/// with normal impulses and stretches that are given. Each pair's points are those of one
/// other pair, too, and most share a face or an edge of B.
struct RandomMeeting {
    World world;
    Contacts contacts;
    double dt = 0.01;

    explicit RandomMeeting(unsigned seed) : engine_(seed)
    {
        for (int i = 0; i < 6; ++i)
            b_.push_back(Vec3(random(-1, 1), 0, random(-1, 1)));
        for (int i = 0; i < 4; ++i)
            contacts.push_back(pair(i % 2 == 0));
        for (std::size_t i = 0; i < 4; ++i)
            contacts.push_back(contacts[i]);
        for (Contact& contact : contacts)
            press(contact);
        world.bodies.push_back(points("a", a_));
        world.bodies.push_back(points("b", b_));
        for (const auto& body : world.bodies)
            body->predict(Vec3(0, -9.81, 0), dt);
    }

    double random(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    Vec3 vector(double size) { return size * Vec3(random(-1, 1), random(-1, 1), random(-1, 1)); }

    std::unique_ptr<PointMasses> points(const std::string& name, const std::vector<Vec3>& positions)
    {
        auto body = std::make_unique<PointMasses>(name, positions, std::vector<Face>{{0, 1, 2}, {3, 4, 5}},
                                                  std::exp(random(-6, 6)));
        for (int i = 0; i < body->surface().vertex_count(); ++i)
            body->set_velocity(i, vector(1));
        return body;
    }

    /// Two new points of A, on a face or on an edge of B.
    Contact pair(bool vertex_face)
    {
        Contact contact;
        contact.kind = vertex_face ? ContactKind::vertex_face : ContactKind::edge_edge;
        contact.body_a = 0;
        contact.body_b = 1;
        const int v = static_cast<int>(a_.size()), first = 3 * static_cast<int>(random(0, 1.99));
        const double s = random(0, 1), t = random(0, 1);
        if (vertex_face) {
            contact.vertices = {v, first, first + 1, first + 2};
            contact.weights = {1, -(1 - s) * (1 - t), -s * (1 - t), -t};
        } else {
            contact.vertices = {v, v + 1, first, first + 1};
            contact.weights = {1 - s, s, -(1 - t), -t};
        }
        Vec3 q = Vec3::Zero();
        for (std::size_t i = vertex_face ? 1 : 2; i < 4; ++i)
            q -= contact.weights[i] * b_[contact.vertices[i]];
        const Vec3 along = vector(1);
        a_.push_back(vertex_face ? q : Vec3(q - s * along));
        a_.push_back(a_.back() + along);
        return contact;
    }

    void press(Contact& contact)
    {
        const Vec3 normal = (Vec3::UnitY() + vector(0.3)).normalized();
        contact.impulse = std::exp(random(-9, 5)) * normal;
        contact.spring.stretch = TangentPlane(normal).projected(vector(0.01));
    }

private:
    std::mt19937 engine_;
    std::vector<Vec3> a_, b_;
};

/// Kinetic energy of what is predicted; point masses in free fall for one step.
double predicted_kinetic(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        for (int v = 0; v < body->surface().vertex_count(); ++v)
            sum += 0.5 * body->mass() / body->surface().vertex_count() * body->velocity(v).squaredNorm();
    return sum;
}

Vec3 momentum(const World& world)
{
    return world.bodies[0]->linear_momentum() + world.bodies[1]->linear_momentum();
}

}  // namespace

TEST_CASE("friction: keeps linear momentum to rounding, between all kinds of pairs")
{
    for (const FrictionParameters& model : both_models)
        for (unsigned seed = 0; seed < 50; ++seed) {
            RandomMeeting it(seed);
            const Vec3 before = momentum(it.world);
            compute_friction_impulses(it.world, it.contacts, model, it.dt);
            apply_impulses(it.world, it.contacts);
            CHECK((momentum(it.world) - before).norm() < 1e-13 * (1 + before.norm()));
        }
}

TEST_CASE(
    "friction: mass-splitting friction takes energy in every step, springs included, over random meetings")
{
    for (unsigned seed = 0; seed < 2000; ++seed) {
        RandomMeeting it(seed);
        CAPTURE(seed);
        MassSplitting friction{.spring = std::exp(it.random(2, 7))};
        friction.mu_s = it.random(0, 1.5);
        friction.mu_d = it.random(0, friction.mu_s);
        for (Contact& contact : it.contacts) {  // a stretch that friction could have left
            const double longest = friction.mu_s * contact.impulse.norm() / (it.dt * friction.spring);
            contact.spring.stretch *= std::min(1.0, longest / contact.spring.stretch.norm());
        }
        double stiffest = 1e300;  // that no anchor has to soften for this step
        MassShares shares(it.world, it.contacts);
        for (const Contact& contact : it.contacts)
            stiffest = std::min(
                stiffest,
                1 / (it.dt * it.dt *
                     shares.inverse_mass(it.world, contact, TangentPlane(contact.impulse.normalized()))));
        friction.spring = std::min(friction.spring, stiffest);
        const double springs_before = friction_spring_energy(it.contacts, friction);
        compute_friction_impulses(it.world, it.contacts, friction, it.dt);
        // What friction adds to what the normal impulses alone would have done.
        Contacts normal_only = it.contacts;
        for (Contact& contact : normal_only)
            contact.friction.setZero();
        Contacts friction_only = it.contacts;
        for (Contact& contact : friction_only)
            contact.impulse.setZero();
        apply_impulses(it.world, normal_only);
        const double kinetic_before = predicted_kinetic(it.world);
        apply_impulses(it.world, friction_only);
        for (const auto& body : it.world.bodies)
            body->update_prediction(it.dt);
        move_friction_anchors(it.world, it.contacts, friction, it.dt);
        const double change = predicted_kinetic(it.world) - kinetic_before +
                              friction_spring_energy(it.contacts, friction) - springs_before;
        CHECK(change <= 1e-12 * kinetic_before);
    }
}

TEST_CASE("friction: a pair's shares bound what all pairs do together")
{
    for (unsigned seed = 0; seed < 300; ++seed) {
        RandomMeeting it(seed);
        MassShares shares(it.world, it.contacts);
        // Any impulses J: the kinetic energy of what they do, J K J / 2, is no
        // more than that of the shares, sum w |J|^2 / 2.
        double of_shares = 0;
        std::vector<Vec3> impulses;
        for (auto& body : it.world.bodies)
            for (int v = 0; v < body->surface().vertex_count(); ++v)
                dynamic_cast<PointMasses&>(*body).set_velocity(v, Vec3::Zero());
        for (Contact& contact : it.contacts) {
            const TangentPlane plane(contact.impulse.normalized());
            const Vec3 impulse = plane.projected(it.vector(1));
            of_shares += 0.5 * shares.inverse_mass(it.world, contact, plane) * impulse.squaredNorm();
            contact.impulse.setZero();
            contact.friction = impulse;
        }
        apply_impulses(it.world, it.contacts);
        CHECK(predicted_kinetic(it.world) <= of_shares * (1 + 1e-12));
    }
}

TEST_CASE(
    "friction: a pair that is alone on a rigid body has the whole of it, through however many vertices it pushes")
{
    World world;
    world.bodies.push_back(std::make_unique<PointMasses>("particle", std::vector<Vec3>{{0.1, 0.5, 0.1}},
                                                         std::vector<Face>{}, 2.0));
    const SurfaceMesh cube = box({1, 1, 1});
    world.bodies.push_back(
        std::make_unique<RigidBody>("cube", cube, with_mass(mass_properties(cube, 1.0), 3.0)));
    const auto [f0, f1, f2] = cube.faces[0];
    Contact contact{ContactKind::vertex_face, 0, 1, 0, 0, {0, f0, f1, f2}, {1, -0.5, -0.3, -0.2}};
    contact.impulse = {0, 1, 0};
    Mat3 expected = Mat3::Identity() / 2.0;
    for (const std::size_t i : {1u, 2u, 3u})
        expected -= contact.weights[i] * world.bodies[1]->inverse_mass(contact.vertices[i]);
    const TangentPlane plane(Vec3::UnitY());
    const double found = MassShares(world, {contact}).inverse_mass(world, contact, plane);
    CHECK(found == doctest::Approx(Eigen::SelfAdjointEigenSolver<Mat2>(plane.of(expected)).eigenvalues()[1])
                       .epsilon(1e-12));
}
