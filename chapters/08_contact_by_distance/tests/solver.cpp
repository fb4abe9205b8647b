#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/tests/moving_surface.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

std::vector<PairKey> keys_of(const Contacts& contacts)
{
    std::vector<PairKey> keys;
    for (const Contact& contact : contacts)
        keys.push_back(key_of(contact));
    return keys;
}

void add_static(World& world, const SurfaceMesh& mesh)
{
    world.bodies.push_back(std::make_unique<StaticBody>(
        "fixed", SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

void add_rigid(World& world, const SurfaceMesh& mesh, double mass, const Vec3& velocity = Vec3::Zero())
{
    world.bodies.push_back(
        std::make_unique<RigidBody>("body", mesh, with_mass(mass_properties(mesh, 1000), mass), velocity));
}

/// Balls along x with a gap between them, without gravity; the first one comes with a speed.
World row_of_balls(const std::vector<double>& masses, double size, double gap, double speed)
{
    World world;
    world.gravity.setZero();
    // Faces against faces: one of the icosahedron's faces looks along x, its opposite one along -x.
    SurfaceMesh ball = sphere(0.5, 0);
    const auto [p, q, r] = ball.faces[0];
    const Vec3 normal =
        (ball.vertices[static_cast<std::size_t>(q)] - ball.vertices[static_cast<std::size_t>(p)])
            .cross(ball.vertices[static_cast<std::size_t>(r)] - ball.vertices[static_cast<std::size_t>(p)]);
    ball = turned(ball, Quaternion::FromTwoVectors(normal, Vec3::UnitX()));
    double thick = 0;
    for (const Vec3& x : ball.vertices)
        thick = std::max(thick, 2 * x.x());
    for (std::size_t i = 0; i < masses.size(); ++i)
        add_rigid(world,
                  placed(ball, size, Quaternion::Identity(),
                         size * (thick + gap) * static_cast<double>(i) * Vec3::UnitX()),
                  masses[i], i == 0 ? Vec3(speed * size, 0, 0) : Vec3(Vec3::Zero()));
    return world;
}

/// By how much the bodies of a row overlap their neighbours along x.
double deepest_in_row(const World& world)
{
    double deepest = 0;
    for (std::size_t i = 0; i + 1 < world.bodies.size(); ++i) {
        double right = -INFINITY, left = INFINITY;
        for (const Vec3& x : world.bodies[i]->positions_t0())
            right = std::max(right, x.x());
        for (const Vec3& x : world.bodies[i + 1]->positions_t0())
            left = std::min(left, x.x());
        deepest = std::max(deepest, right - left);
    }
    return deepest;
}

bool touch(const Contacts& contacts, int one, int other)
{
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return std::minmax(contact.body_a, contact.body_b) == std::minmax(one, other);
    });
}

}  // namespace

TEST_CASE("solver of chapter 8: ten passes, of which six are chapter 7's, and none stands around another one")
{
    const Solver solver = chapter08_solver({});
    const auto names = [&](StepStage stage) {
        std::vector<std::string> all;
        for (const Pass& pass : solver.passes(stage))
            all.push_back(pass.name);
        return all;
    };
    using Names = std::vector<std::string>;
    CHECK(names(StepStage::refresh) == Names{"find elastic ends", "put skins", "find pairs"});
    CHECK(names(StepStage::detect) == Names{"let nothing cross"});
    CHECK(names(StepStage::respond) == Names{"solve contacts"});
    CHECK(names(StepStage::finish) == Names{"remember pairs", "turn normals"});
    CHECK(names(StepStage::after_commit) == Names{"bring back", "restitution"});
    CHECK(solver.finds_stiffness);
}

TEST_CASE("solver of chapter 8: pairs are found once at the start of a step, and remembered once at its end")
{
    Scene scene = chapter07::scene_of({{.centre = Vec3(0, 0.5, 0)}}, 0.01);
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    for (int step = 0; step < 3; ++step) {
        std::vector<std::string> passes;
        advance(scene.world, contacts, solver, scene.dt,
                [&](const std::string& pass) { passes.push_back(pass); });
        CAPTURE(step);
        REQUIRE(passes.size() > 5);
        CHECK(passes[0] == "predict");
        CHECK(passes[1] == "find elastic ends");
        CHECK(passes[2] == "put skins");
        CHECK(passes[3] == "find pairs");
        CHECK(std::count(passes.begin(), passes.end(), "find pairs") == 1);
        CHECK(std::count(passes.begin(), passes.end(), "remember pairs") == 1);
        const auto place = [&](const std::string& name) {
            return std::find(passes.begin(), passes.end(), name) - passes.begin();
        };
        CHECK(place("let nothing cross") < place("solve contacts"));
        CHECK(place("solve contacts") < place("remember pairs"));
    }
}

TEST_CASE("solver of chapter 8: a cube that rests has the same pairs in every step, on a plane and on a body")
{
    for (const double size : {1e-2, 1.0, 100.0})
        for (const double dt : {0.002, 0.01, 1.0 / 60})
            for (const double mass : {0.1, 1000.0})
                for (const bool on_body : {false, true}) {
                    World world;
                    world.gravity *= size;
                    if (on_body)
                        add_static(world, placed(box({4, 1, 4}, {3, 1, 3}), size, Quaternion::Identity(),
                                                 Vec3(0.03, -0.5, 0.08) * size));
                    else
                        world.planes.push_back({"ground"});
                    const Quaternion turn(Eigen::AngleAxisd(0.4, Vec3::UnitY()));
                    add_rigid(world, placed(box(Vec3::Ones()), size, turn, Vec3(0, 0.5, 0) * size), mass);
                    const Solver solver = chapter08_solver({});
                    Contacts contacts;
                    CAPTURE(size);
                    CAPTURE(dt);
                    CAPTURE(mass);
                    CAPTURE(on_body);
                    std::vector<PairKey> first;
                    double load = 0;
                    for (int step = 0; step < 60; ++step) {
                        advance(world, contacts, solver, dt);
                        if (step == 0) {
                            first = keys_of(contacts);
                            REQUIRE(first.size() >= 4);
                        }
                        CAPTURE(step);
                        REQUIRE(keys_of(contacts) == first);
                        load = 0;
                        for (const Contact& contact : contacts)
                            load += contact.spring.load;
                    }
                    CHECK(load == doctest::Approx(mass * 9.81 * size).epsilon(1e-2));
                }
}

TEST_CASE(
    "solver of chapter 8: in a row of balls, those that the answer brings inside are found in the same step")
{
    for (const double size : {1e-2, 1.0, 100.0})
        for (const std::vector<double>& masses :
             {std::vector<double>{10, 10, 10}, {100, 1, 10}, {1, 1, 1, 1, 1}}) {
            const double dt = 0.01, gap = 1e-3;
            World world = row_of_balls(masses, size, gap, 10);  // a tenth of its size in a step
            double momentum = masses[0] * 10 * size;
            const Solver solver = chapter08_solver({});
            Contacts contacts;
            CAPTURE(size);
            CAPTURE(masses.size());
            CAPTURE(masses[0]);
            const double before = total_energy(world).total();
            advance(world, contacts, solver, dt);
            CHECK(touch(contacts, 0, 1));
            CHECK(touch(contacts, 1, 2));
            CHECK(deepest_in_row(world) < 2e-3 * size);
            CHECK(world.bodies[2]->mean_velocity().x() > 0);
            for (int step = 0; step < 30; ++step)
                advance(world, contacts, solver, dt);
            CHECK(deepest_in_row(world) < 2e-3 * size);
            for (const auto& body : world.bodies)
                momentum -= body->linear_momentum().x();
            CHECK(std::abs(momentum) < 1e-6 * masses[0] * 10 * size);
            CHECK(total_energy(world).total() < (1 + 1e-6) * before);
            for (std::size_t i = 0; i + 1 < masses.size(); ++i)
                CHECK(world.bodies[i]->mean_velocity().x() <=
                      world.bodies[i + 1]->mean_velocity().x() + 1e-4 * size);
        }
}

TEST_CASE(
    "solver of chapter 8: answering a second time in a step replaces the first answer and does not add to it")
{
    for (const double dt : {0.002, 0.01}) {
        Scene once = chapter07::scene_of(chapter07::stack_of(3), dt),
              twice = chapter07::scene_of(chapter07::stack_of(3), dt);
        const Solver solver = chapter08_solver(once.contact);
        Solver answers_twice = chapter08_solver(twice.contact);
        int second = 0;
        const Pass::Function answer = answers_twice.pass("solve contacts").run;
        answers_twice.replace("solve contacts", "solve contacts",
                              [answer, &second](World& world, Contacts& contacts, double length) {
                                  answer(world, contacts, length);
                                  answer(world, contacts, length);
                                  ++second;
                              });
        Contacts of_once, of_twice;
        for (int step = 0; step < 50; ++step) {
            advance(once.world, of_once, solver, dt);
            advance(twice.world, of_twice, answers_twice, dt);
        }
        CAPTURE(dt);
        CHECK(second >= 50);
        CHECK(keys_of(of_once) == keys_of(of_twice));
        for (std::size_t i = 0; i < 3; ++i)
            CHECK((once.world.bodies[i]->centre() - twice.world.bodies[i]->centre()).norm() < 1e-6);
    }
}
