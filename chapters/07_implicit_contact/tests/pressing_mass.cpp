#include "chapters/07_implicit_contact/step_problem.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

constexpr double dt = 0.01;

/// Points on one another over a ground, from below, as their step is solved: all have stopped.
struct StoppedPoints {
    Contacts contacts;
    StepProblem step;

    /// @param speed  with which all came down [m/s]
    StoppedPoints(const std::vector<double>& masses, const Vec3& gravity, double speed)
        : contacts(masses.size())
    {
        step.problem.step.dt = dt;
        double above = 0;
        for (std::size_t i = masses.size(); i-- > 0;)
            add_pair(i, above += masses[i], speed + gravity.norm() * dt);
        for (std::size_t i = 0; i < masses.size(); ++i)
            step.problem.blocks.push_back(
                {3 * static_cast<int>(i), masses[i] * Mat3::Identity(), 1 / masses[i] * Mat3::Identity()});
        step.problem.size = 3 * static_cast<int>(masses.size());
        for (const PairRow& row : step.problem.rows)
            step.responses.push_back(row.response(step.problem.blocks));
    }

    void add_pair(std::size_t below, double mass, double speed)
    {
        PairRow row;
        contacts[below].kind = ContactKind::vertex_plane;
        contacts[below].body_a = contacts[below].body_b = 0;
        contacts[below].vertices[0] = 0;
        row.law.stiffness = contacts[below].spring.stiffness = 1;
        row.acting = mass * speed * Vec3::UnitY();
        row.parts[0] = {3 * static_cast<int>(below), Mat3::Identity()};
        row.part_count = 1;
        if (below > 0)
            row.parts[static_cast<std::size_t>(row.part_count++)] = {3 * static_cast<int>(below) - 3,
                                                                     -Mat3::Identity()};
        step.problem.rows.push_back(row);
        step.of_row.push_back(&contacts[below]);
    }
};

/// Which tells how large the points' bodies are: a metre. A corner of its cube touches a plane.
World world_of_a_metre()
{
    World world;
    const SurfaceMesh cube = box(Vec3::Ones());
    world.bodies.push_back(std::make_unique<StaticBody>(
        "cube", SurfaceTopology(static_cast<int>(cube.vertices.size()), cube.faces), cube.vertices));
    world.planes.push_back({"ground", cube.vertices[0]});
    return world;
}

}  // namespace

TEST_CASE("pressing mass: a pair is pressed by all that lies above, at rest and in an impact")
{
    const World world = world_of_a_metre();
    for (const double speed : {0.0, 5.0}) {
        const StoppedPoints points({1, 1000, 3}, world.gravity, speed);
        const std::vector<double> masses = pressing_masses(world, points.step);
        CHECK(masses[0] == doctest::Approx(3));  // from above
        CHECK(masses[1] == doctest::Approx(1003));
        CHECK(masses[2] == doctest::Approx(1004));
    }
}

TEST_CASE(
    "pressing mass: a pair gets the stiffness of what presses it in the same step, once, and not more than its load asks for")
{
    const World world = world_of_a_metre();
    for (const double wanted_depth : {1e-5, 1e-3}) {
        StiffnessChoice choice;
        choice.wanted_depth = wanted_depth;
        StoppedPoints points({1, 1000}, world.gravity, 0);
        CHECK(stiffen_where_pressed(world, points.step, choice));
        const double of_mass = choice.k_dt2_over_m * 1001 / (dt * dt), of_load = 1001 * 9.81 / wanted_depth;
        CHECK(points.contacts[0].spring.stiffness ==
              doctest::Approx(std::min(of_mass, of_load)).epsilon(1e-3));
        CHECK(points.contacts[0].spring.rest_offset == 0);
        CHECK(points.step.problem.rows[1].law.stiffness == points.contacts[0].spring.stiffness);
        CHECK_FALSE(stiffen_where_pressed(world, points.step, choice));
    }
}

TEST_CASE("pressing mass: a pair that is pressed by less than twice its own mass stays as it is")
{
    const World world = world_of_a_metre();
    StoppedPoints points({1, 0.9}, world.gravity, 2);
    for (Contact& contact : points.contacts)
        contact.spring.stiffness = 100 / (dt * dt);
    CHECK_FALSE(stiffen_where_pressed(world, points.step, {}));
}

TEST_CASE("pressing mass: a vice presses what it holds like the mass that its load could carry")
{
    const World world = world_of_a_metre();
    for (const double load : {30.0, 3000.0}) {
        StoppedPoints held({1}, world.gravity, 0);
        held.add_pair(0, 0, 0);  // from the other side
        for (const std::size_t side : {0U, 1U}) {
            PairRow& row = held.step.problem.rows[side];
            row.law.normal = side == 0 ? Vec3(Vec3::UnitX()) : Vec3(-Vec3::UnitX());
            row.acting = load * dt * row.law.normal;
        }
        for (const double mass : pressing_masses(world, held.step))
            CHECK(mass == doctest::Approx(load / world.gravity.norm()));
    }
}
