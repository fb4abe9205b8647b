#include "chapters/07_implicit_contact/step_problem.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

/// A light point on a ground under a heavy one, as their step is solved: both have stopped. The lower spring
/// has been made stiffer before, so it has a rest offset, and friction holds it.
struct HeavyOnLight {
    static constexpr double light = 1, heavy = 1000;  // [kg]
    double dt;
    World world;
    Contacts contacts{2};
    StepProblem step;

    HeavyOnLight(double length, double fall, double size = 1) : dt(length)
    {
        const SurfaceMesh cube = box(size * Vec3::Ones());
        world.bodies.push_back(std::make_unique<StaticBody>(
            "cube", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
        world.planes.push_back(
            {"ground", world.bodies[0]->positions_t0()[0] + (2e-3 + 5e-4) * Vec3::UnitY()});
        step.problem.step.dt = dt;
        step.problem.size = 6;
        for (const double mass : {light, heavy})
            step.problem.blocks.push_back(
                {mass == light ? 0 : 3, mass * Mat3::Identity(), 1 / mass * Mat3::Identity()});
        const double speed = fall + world.gravity.norm() * dt;
        for (const int i : {0, 1}) {
            Contact& contact = contacts[static_cast<std::size_t>(i)];
            contact.kind = ContactKind::vertex_plane;
            contact.body_a = contact.body_b = 0;
            contact.vertices[0] = 0;
            contact.spring.rest_offset = -2e-3;
            contact.spring.stretch = Vec3(1e-5, 0, -3e-5);
            PairRow row;
            row.law.stiffness = contact.spring.stiffness = 3;
            row.law.depth_t0 = -5e-4;  // from where the spring is slack
            row.law.stretch = contact.spring.stretch;
            row.acting = (i == 0 ? light + heavy : heavy) * speed * Vec3::UnitY();
            row.parts[0] = {3 * i, Mat3::Identity()};
            row.parts[1] = {0, -Mat3::Identity()};
            row.part_count = 1 + i;
            step.problem.rows.push_back(row);
            step.of_row.push_back(&contact);
            step.responses.push_back(row.response(step.problem.blocks));
        }
    }
    double load() const { return step.problem.rows[0].acting.y() / dt; }
};

}  // namespace

TEST_CASE("pressing mass: a pair that is made stiffer in its step pushes and holds as it did, with any step")
{
    for (const double dt : {0.001, 0.02}) {
        HeavyOnLight points(dt, 0.5);
        CAPTURE(dt);
        StiffnessChoice choice;
        choice.wanted_depth = 1e-7;  // so that the mass decides
        REQUIRE(stiffen_where_pressed(points.world, points.step, choice));
        const Contact& contact = points.contacts[0];
        const PairLaw& law = points.step.problem.rows[0].law;
        const double depth = -2e-3 - 5e-4;
        CHECK(contact.spring.stiffness == doctest::Approx(100 * 1001 / (dt * dt)));
        CHECK(contact.spring.stiffness * (contact.spring.rest_offset - depth) == doctest::Approx(3 * 5e-4));
        CHECK((contact.spring.stiffness * contact.spring.stretch - 3 * Vec3(1e-5, 0, -3e-5)).norm() < 1e-12);
        CHECK(law.stiffness == contact.spring.stiffness);
        CHECK(law.stretch == contact.spring.stretch);
    }
}

TEST_CASE(
    "pressing mass: what presses asks in vain for more than a part of the mass that the pair feels itself")
{
    for (const double dt : {0.001, 0.02}) {
        HeavyOnLight points(dt, 0.5);
        StiffnessChoice choice;
        choice.max_k_dt2_over_m = 2000;
        CAPTURE(dt);
        CHECK(stiffen_where_pressed(points.world, points.step, choice));
        CHECK(points.contacts[0].spring.stiffness == doctest::Approx(2000 * points.light / (dt * dt)));
        CHECK_FALSE(stiffen_where_pressed(points.world, points.step, choice));
    }
}

TEST_CASE(
    "pressing mass: the load asks for a stiffness by the size of the pair's body and the length of the step")
{
    for (const double size : {1.0, 0.1})
        for (const double dt : {0.001, 0.02}) {
            HeavyOnLight points(dt, 0, size);
            StiffnessChoice choice;
            choice.k_dt2_over_m = 1e9;
            choice.max_k_dt2_over_m = 1e12;
            CAPTURE(size);
            CAPTURE(dt);
            CHECK(stiffen_where_pressed(points.world, points.step, choice));
            CHECK(points.contacts[0].spring.stiffness ==
                  doctest::Approx(points.load() / choice.depth(points.world.bodies[0]->size())));
        }
}

TEST_CASE("pressing mass: where nothing approaches, nothing presses")
{
    HeavyOnLight points(0.01, 0);
    points.world.gravity.setZero();
    for (PairRow& row : points.step.problem.rows)
        row.acting.setZero();
    for (const double mass : pressing_masses(points.world, points.step))
        CHECK(mass == 0);
    CHECK_FALSE(stiffen_where_pressed(points.world, points.step, {}));
}

TEST_CASE("pressing mass: what still moves when its pairs push counts with the speed that it had before")
{
    for (const double left : {-0.3, 0.7}) {  // still approaching, or thrown back
        HeavyOnLight points(0.004, 0);
        points.world.gravity.setZero();
        const double came = 2;
        for (const std::size_t i : {0U, 1U}) {
            PairRow& row = points.step.problem.rows[i];
            const double mass = i == 0 ? points.light + points.heavy : points.heavy;
            row.acting = mass * (came + left) * Vec3::UnitY();
            row.velocity = i == 0 ? Vec3(0, left, 0) : Vec3(Vec3::Zero());
        }
        CAPTURE(left);
        const std::vector<double> masses = pressing_masses(points.world, points.step);
        CHECK(masses[0] == doctest::Approx((points.light + points.heavy) * (came + left) / came));
    }
}
