#include "chapters/08_contact_by_distance/begins_inside.hpp"
#include "chapters/13_other_solvers/experiments/soft_scenes.hpp"
#include "chapters/13_other_solvers/tests/small_scenes.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numbers>

using namespace enduring;
using namespace enduring::chapter13;

namespace {

const std::vector<std::string> soft_methods{"xpbd", "avbd", "barrier"};

/// With so many iterations of a single step that nothing is left to iterate.
Solver converged(const std::string& method, const ContactParameters& parameters)
{
    if (method == "xpbd")
        return chapter13_xpbd_solver(parameters, {.substeps = 1, .iterations = 400});
    if (method == "avbd")
        return chapter13_avbd_solver(parameters, {.iterations = 400});
    return chapter13_barrier_solver(parameters, {.max_halvings = 0});
}

/// What is missing of m (v_1 - v_0) / dt = m g + f(x_1) at a node, at most, by the elastic forces of the
/// base; in its weight [1].
double missing_of_implicit_step(const ElasticBody& after, const NodalVectors& velocities_t0, double dt)
{
    const NodalVectors forces = after.elastic_forces();
    double most = 0;
    for (int n = 0; n < after.node_count(); ++n) {
        const double mass = after.masses()[n];
        const Vec3 gained = mass * (after.velocities().col(n) - velocities_t0.col(n)) / dt;
        if (!after.is_fixed(n))
            most = std::max(most, (gained - forces.col(n) - mass * Vec3(0, -9.81, 0)).norm() / (mass * 9.81));
    }
    return most;
}

/// Takes a part of the velocities away behind each step, until what swings has come to rest.
void calm(Scene& scene, const Solver& solver, int steps)
{
    Contacts contacts;
    auto& body = dynamic_cast<DeformableBody&>(*scene.world.bodies[0]);
    for (int step = 0; step < steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        body.take_velocities(0.85 * body.elastic().velocities(), scene.dt);
        body.stand_still();
    }
}

/// What is said when a soft body of this material is stepped; empty if nothing.
std::string refusal(const std::string& method, const ElasticMaterial& material = {}, bool quadratic = false)
{
    Scene scene = chapter07::scene_of({}, 0.01);
    DeformableSettings settings;
    settings.material = material;
    settings.position = Vec3(0, 1, 0);
    const TetrahedralMesh mesh = bar(Vec3::Ones(), {1, 1, 1});
    scene.world.bodies.push_back(
        quadratic ? std::make_unique<DeformableBody>("jelly", with_edge_midpoints(mesh), settings)
                  : std::make_unique<DeformableBody>("jelly", mesh, settings));
    Contacts contacts;
    try {
        advance(scene.world, contacts, chapter13_solver(method, scene.contact), scene.dt);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("soft bodies: a step of each method, iterated, is the implicit step with the base's elastic forces")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = clamped_bar();
        const Solver solver = converged(method, scene.contact);
        const ElasticBody& elastic = soft_body(scene).elastic();
        Contacts contacts;
        for (int step = 0; step < 10; ++step) {
            const NodalVectors before = elastic.velocities();
            advance(scene.world, contacts, solver, scene.dt);
            CHECK(missing_of_implicit_step(elastic, before, scene.dt) <= (method == "xpbd" ? 0.06 : 1e-5));
        }
        CHECK(height_of_tip(soft_body(scene)) < 1.97);  // and the bar has bent
    }
}

TEST_CASE(
    "XPBD: what a step leaves of the forces of soft elements falls with the step, however often it is iterated")
{
    const auto missing = [](double dt, int iterations) {
        Scene scene = clamped_bar(dt);
        const Solver solver = chapter13_xpbd_solver(scene.contact, {.substeps = 1, .iterations = iterations});
        run(scene, solver, 0.08 - dt);
        const ElasticBody& elastic = soft_body(scene).elastic();
        const NodalVectors before = elastic.velocities();
        run(scene, solver, dt);
        return missing_of_implicit_step(elastic, before, dt);
    };
    const double long_step = missing(0.01, 400), more = missing(0.01, 800), short_step = missing(0.0025, 100);
    CHECK(more > 0.9 * long_step);
    CHECK(short_step < 0.3 * long_step);
}

TEST_CASE("soft bodies: what falls freely has the velocity of its time, also where a step has substeps")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = soft_cube_scene({.centre = Vec3(0, 9, 0)});
        run(scene, chapter13_solver(method, scene.contact), 0.2);
        CHECK(scene.world.bodies[0]->mean_velocity().y() == doctest::Approx(-9.81 * 0.2).epsilon(1e-9));
    }
}

TEST_CASE("soft bodies: a Neo-Hookean step of AVBD and of the barrier is the implicit one, too")
{
    for (const std::string method : {"avbd", "barrier"}) {
        CAPTURE(method);
        Scene scene = soft_cube_scene(
            {.cells = 1, .centre = Vec3(0, 5, 0), .poisson = 0.3, .law = ElasticLaw::neo_hookean});
        auto& cube = dynamic_cast<DeformableBody&>(*scene.world.bodies[0]);
        NodalVectors pulled = cube.elastic().velocities();
        pulled.row(1) = 2 * cube.elastic().mesh().rest().row(1);  // it is stretched
        cube.take_velocities(pulled, scene.dt);
        const Solver solver = converged(method, scene.contact);
        Contacts contacts;
        for (int step = 0; step < 10; ++step) {
            const NodalVectors before = cube.elastic().velocities();
            advance(scene.world, contacts, solver, scene.dt);
            CHECK(missing_of_implicit_step(cube.elastic(), before, scene.dt) <= 1e-5);
        }
        CHECK((cube.elastic().velocities() - pulled).cwiseAbs().maxCoeff() > 0.5);
    }
}

TEST_CASE(
    "soft bodies: a bar that hangs as the implicit solver left it stays, in XPBD the more substeps the better")
{
    Scene damped = clamped_bar(0.01, 20);
    for (int step = 0; step < 300; ++step) {
        damped.world.bodies[0]->predict(damped.world.gravity, damped.dt);
        damped.world.bodies[0]->commit(damped.dt);
    }
    const double sag = 2 - height_of_tip(soft_body(damped));
    const auto moved = [&](const Solver& solver) {
        Scene scene = clamped_bar();
        restore_state(*scene.world.bodies[0], state_of(*damped.world.bodies[0]));
        run(scene, solver, 0.5);
        return std::abs(2 - height_of_tip(soft_body(scene)) - sag) / sag;
    };
    CHECK(sag > 0.1);
    const ContactParameters contact = damped.contact;
    CHECK(moved(chapter13_barrier_solver(contact)) <= 1e-3);
    CHECK(moved(chapter13_avbd_solver(contact, {.iterations = 40})) <= 1e-3);
    const double few = moved(chapter13_xpbd_solver(contact, {.substeps = 10}));
    const double many = moved(chapter13_xpbd_solver(contact, {.substeps = 40}));
    CHECK(many <= 0.3 * few);
    CHECK(many <= 0.01);
}

TEST_CASE("soft bodies: a cube sinks about the mean of a column, and the ground carries its weight")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = soft_cube_scene({}, 0, 0);
        const Solver solver = chapter13_solver(method, scene.contact);
        Contacts contacts;
        double carried = 0;
        const int steps = 80;  // two swings of a column: 4 H / sqrt(E / rho) = 0.4 s
        const double top = mean_over(scene, contacts, solver, steps, [&] {
            carried += sum_of(contacts).y() / steps;
            return height_of_top(soft_body(scene));
        });
        CHECK(1 - top == doctest::Approx(column_sinks()).scale(0).epsilon(0.03));
        const double rose = scene.world.bodies[0]->linear_momentum().y() / (steps * scene.dt);
        CHECK(carried / scene.dt == doctest::Approx(10 * 9.81 + rose).scale(0).epsilon(0.01));
    }
}

TEST_CASE(
    "soft bodies: on a slope a cube stays below the angle of friction, and slides by Coulomb's law above")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene stays = soft_cube_scene({}, 15), slides = soft_cube_scene({}, 50);
        const Solver solver = chapter13_solver(method, stays.contact);
        calm(stays, solver, 120);
        const double from = mean_of_side(soft_body(stays), 1, -1).x();
        run(stays, solver, 0.5);
        const double creep = (mean_of_side(soft_body(stays), 1, -1).x() - from) / 0.5;
        CHECK(std::abs(creep) <= 2e-3);

        // what the ground has given, by momentum alone
        const Body& body = *slides.world.bodies[0];
        const Solver of_slide = chapter13_solver(method, slides.contact);
        run(slides, of_slide, 0.2);
        const Vec3 before = body.linear_momentum();
        run(slides, of_slide, 0.6);
        const Vec3 given = body.linear_momentum() - before - 0.6 * body.mass() * slides.world.gravity;
        CHECK(given.x() / given.y() == doctest::Approx(0.5).scale(0).epsilon(0.01));
    }
}

TEST_CASE("soft bodies: a cube lies on a rigid box that is free, and both stay")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = chapter07::scene_of({{20, Vec3(0, 0.25, 0), 20, Vec3::UnitY(), Vec3(1.5, 0.5, 1.5)}},
                                          0.01);
        append_soft_cube(scene, {.centre = Vec3(0, 1.0, 0)});
        const Solver solver = chapter13_solver(method, scene.contact);
        Contacts contacts;
        const double top = mean_over(scene, contacts, solver, 80,
                                     [&] { return height_of_top(soft_body(scene, 1)); });
        CHECK(1.5 - top == doctest::Approx(column_sinks()).scale(0).epsilon(0.1));
        CHECK((scene.world.bodies[0]->centre() - Vec3(0, 0.25, 0)).norm() <= 3e-3);
        CHECK(std::abs(scene.world.bodies[1]->centre().x()) <= 3e-3);
    }
}

TEST_CASE("soft bodies: a collision with a rigid cube keeps momentum, brings no energy and does not cross")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = chapter07::scene_of({{10, Vec3(1.3, 0.3, 0.2), 50, Vec3(3, 1, 2).normalized()}}, 0.01,
                                          0, 0.3, 0.3);
        scene.world.planes.clear();
        scene.world.gravity.setZero();
        append_soft_cube(scene, {.centre = Vec3(-0.2, 0, 0), .poisson = 0.3, .velocity = Vec3(3, 0, 0)});
        const Solver solver = chapter13_solver(method, scene.contact);
        const auto momentum = [&] {
            return Vec3(scene.world.bodies[0]->linear_momentum() + scene.world.bodies[1]->linear_momentum());
        };
        const Vec3 before = momentum();
        run(scene, solver, 0.6);
        CHECK((momentum() - before).norm() <= (method == "avbd" ? 0.01 : 1e-9) * before.norm());
        const double energy = scene.world.bodies[0]->energy(Vec3::Zero()).total() +
                              scene.world.bodies[1]->energy(Vec3::Zero()).total();
        CHECK(energy <= 45 * 1.001);
        CHECK(scene.world.bodies[0]->mean_velocity().x() >= 0.5);  // it was hit
        if (method == "barrier")
            CHECK(bodies_inside_each_other(scene.world).empty());
    }
}

TEST_CASE("soft bodies: a cube that falls comes up again, and not higher")
{
    for (const std::string& method : soft_methods) {
        CAPTURE(method);
        Scene scene = soft_cube_scene({.centre = Vec3(0, 1, 0), .poisson = 0.3});
        const Solver solver = chapter13_solver(method, scene.contact);
        Contacts contacts;
        double lowest = 1, highest = 0;
        for (int step = 0; step < 120; ++step) {
            advance(scene.world, contacts, solver, scene.dt);
            const double height = scene.world.bodies[0]->centre().y();
            if (step < 60)
                lowest = std::min(lowest, height);
            else
                highest = std::max(highest, height);
        }
        CHECK(highest <= 1);
        CHECK(highest >= 0.57);
    }
}

TEST_CASE("soft bodies: what a method has no answer for is refused by the body's name")
{
    const std::string body = "body 'jelly' ";
    CHECK(refusal("avbd", {}).empty());
    for (const std::string method : {"sequential", "soft_step", "relaxation"})
        CHECK(refusal(method, {}) == body + "is deformable; this solver moves rigid bodies only");
    CHECK(refusal("xpbd", {.law = ElasticLaw::neo_hookean}) ==
          body + "is Neo-Hookean; this solver moves corotated elements only");
    CHECK(refusal("barrier", {.law = ElasticLaw::neo_hookean}).empty());
    CHECK(refusal("barrier", {.stiffness_damping = 0.01}) ==
          body + "has a damped material; this solver moves undamped ones only");
    CHECK(refusal("avbd", {}, true) == body + "has quadratic elements; this solver moves linear ones only");
}
