#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

constexpr double earth = 9.81, mass = 10;  // [m/s^2], [kg]

/// A scene under this chapter's solver, and what its pairs exert.
struct Run {
    Scene scene;
    Contacts contacts{};

    void steps(int count)
    {
        ImplicitSettings settings;
        settings.record = [](const SolveRecord&) {};
        const Solver solver = chapter07_solver(scene.contact, settings);
        for (int i = 0; i < count; ++i)
            advance(scene.world, contacts, solver, scene.dt);
    }
    Vec3 on(std::size_t body) const { return body_forces(scene.world, contacts, scene.dt).at(body); }
    /// How far pairs are from k times depth, over the largest force or spring.
    double off_law() const
    {
        const double part = last_part(scene.world, scene.dt);
        double off = 0, largest = 0;
        for (const Contact& contact : contacts) {
            if (!contact.is_spring())
                continue;
            const double depth = contact_geometry(scene.world, contact, 1).depth,
                         spring = contact.spring.stiffness *
                                  std::max(0.0, contact.spring.rest_offset - depth),
                         force = pair_force(contact, part).normal.norm();
            off = std::max(off, std::abs(force - spring));
            largest = std::max({largest, force, spring});
        }
        return largest > 0 ? off / largest : INFINITY;
    }
};

std::unique_ptr<RigidBody> block(const Vec3& size, std::array<int, 3> cells, const Vec3& centre)
{
    SurfaceMesh mesh = box(size, cells);
    for (Vec3& vertex : mesh.vertices)
        vertex += centre;
    return std::make_unique<RigidBody>("block", mesh, with_mass(mass_properties(mesh, 1000), mass));
}

/// On 4 to 121 pairs.
Run resting_block(int cells, double dt, double slope_deg)
{
    Run run{chapter07::scene_of({}, dt, slope_deg)};
    run.scene.world.bodies.push_back(block({1, 0.2, 1}, {cells, 1, cells}, {0, 0.1, 0}));
    return run;
}

}  // namespace

TEST_CASE("forces: what rests is carried with its weight, on however many pairs, each with k times its depth")
{
    for (const int cells : {1, 4, 10})
        for (const double dt : {1.0 / 60, 0.002}) {
            CAPTURE(cells);
            CAPTURE(dt);
            Run run = resting_block(cells, dt, 0);
            run.steps(200);
            CHECK((run.on(0) - Vec3(0, mass * earth, 0)).norm() < 1e-7 * mass * earth);
            CHECK(run.off_law() < 1e-7);
        }
}

TEST_CASE("forces: on a slope below the threshold friction is m g sin, and the normal force m g cos")
{
    for (const double degrees : {5.0, 20.0}) {
        CAPTURE(degrees);
        Run run = resting_block(4, 1.0 / 60, degrees);
        run.steps(200);
        const double slope = degrees * std::numbers::pi / 180;
        const Vec3 expected = mass * earth * Vec3(std::sin(slope), std::cos(slope), 0);
        CHECK((run.on(0) - expected).norm() < 1e-6 * mass * earth);
    }
}

TEST_CASE("forces: two walls that press a block from both sides press alike, with k times the depth")
{
    for (const double pressed : {1e-5, 5e-4}) {
        CAPTURE(pressed);
        Run run{chapter07::scene_of({}, 0.01)};
        run.scene.world.planes.clear();
        run.scene.world.gravity.setZero();
        run.scene.world.bodies.push_back(block({0.2, 0.2, 0.2}, {1, 1, 1}, Vec3::Zero()));
        for (const int side : {-1, 1}) {
            constexpr double gap = 1e-4;  // a wall that begins in touch never crosses
            const Vec3 centre(side * (0.15 + gap), 0, 0);
            SurfaceMesh wall = box({0.1, 0.5, 0.5});
            for (Vec3& vertex : wall.vertices)
                vertex += centre;
            run.scene.world.bodies.push_back(std::make_unique<DrivenBody>(
                "wall", wall, centre,
                GivenMotion::through({{0, Vec3::Zero(), Vec3::Zero()},
                                      {0.05, Vec3(-side * (pressed + gap), 0, 0), Vec3::Zero()}})));
        }
        run.steps(20);             // pairs come and go at first
        CHECK(run.on(1).x() < 0);  // the left wall
        CHECK(std::abs(run.on(1).x() + run.on(2).x()) < 1e-6 * std::abs(run.on(1).x()));
        CHECK(run.off_law() < 1e-6);
        CHECK(run.scene.world.ended_badly == 0);
    }
}
