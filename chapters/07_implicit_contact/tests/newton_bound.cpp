#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// Balls of 80 faces, as rough as rubber, that fall into a pit with four steep walls, where they jam.
Scene balls_in_a_pit(int side, int layers, unsigned seed)
{
    Scene scene = scene_of({}, 0.01, 0, 1, 1);
    for (const Vec3& inwards : {Vec3(1, 0.3, 0), Vec3(-1, 0.3, 0), Vec3(0, 0.3, 1), Vec3(0, 0.3, -1)})
        scene.world.planes.push_back({"wall", -0.55 * side * inwards, inwards.normalized()});
    std::mt19937 random(seed);
    const auto shift = [&] { return 0.05 * (static_cast<double>(random()) / std::mt19937::max() - 0.5); };
    for (int i = 0; i < side * side * layers; ++i) {
        SurfaceMesh ball = sphere(0.5, 1);
        const int layer = i / (side * side), place = i % (side * side);
        const Vec3 centre(1.1 * (place % side - 0.5 * (side - 1)) + shift(), 0.8 + 1.1 * layer,
                          1.1 * (place / side - 0.5 * (side - 1)) + shift());
        for (Vec3& x : ball.vertices)
            x += centre;
        scene.world.bodies.push_back(std::make_unique<RigidBody>("ball " + std::to_string(i + 1), ball,
                                                                 with_mass(mass_properties(ball, 1000), 10)));
    }
    return scene;
}

/// The most Newton steps of any island in each step of a run, and how many problems were told as not solved.
struct Counted {
    std::map<int, int> newton_steps;
    int unconverged = 0;
    double gained = 0;  ///< [J]

    int most() const
    {
        return std::max_element(newton_steps.begin(), newton_steps.end(),
                                [](const auto& one, const auto& other) { return one.second < other.second; })
            ->second;
    }
};

Counted count(int max_newton_steps, int steps)
{
    Counted counted;
    ImplicitSettings settings;
    settings.max_newton_steps = max_newton_steps;
    settings.record = [&](const SolveRecord& record) {
        int& most = counted.newton_steps[record.step];  // of any island in any response
        most = std::max(most, record.newton_steps);
        counted.unconverged += !record.converged;
    };
    Scene scene = balls_in_a_pit(3, 3, 1);
    Solver solver = chapter07_solver(scene.contact, settings);
    solver.max_halvings = 0;  // every step as it comes
    Contacts contacts;
    const double first = total_energy(scene.world).total();
    for (int i = 0; i < steps; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        counted.gained = std::max(counted.gained, total_energy(scene.world).total() - first);
    }
    return counted;
}

}  // namespace

TEST_CASE(
    "newton bound: one number bounds all loops of a step, and what is unsolved then is told and gains no energy")
{
    const Counted bounded = count(20, 80), unbounded = count(100000, 80);
    CAPTURE(unbounded.most());
    CHECK(unbounded.most() > 2 * 20);
    CHECK(bounded.most() <= 20);
    CHECK(bounded.unconverged > unbounded.unconverged);
    CHECK(bounded.gained <= 1e-6);
}

TEST_CASE(
    "implicit contact: a cube that comes into a steep wedge is solved in whole steps, for its limits are searched")
{
    long thrown_away = 0;
    for (const double half_angle_deg : {5.0, 10.0})
        for (const double mu : {0.3, 0.5, 1.0, 1.5}) {
            Scene scene = cube_between_planes(half_angle_deg, mu, 0.01);
            ImplicitSettings settings;
            settings.record = [](const SolveRecord&) {};
            const Solver solver = chapter07_solver(scene.contact, settings);
            Contacts contacts;
            for (int i = 0; i < 100; ++i)
                advance(scene.world, contacts, solver, scene.dt);
            thrown_away += scene.world.thrown_away;
        }
    CHECK(thrown_away <= 9);  // without the search 19
}
