#include "chapters/12_joints/solver.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/energy.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace enduring;

namespace {

constexpr int box = 0, hand = 1, left = 2, right = 3;

/// What pairs push on the box from one body, in the last step [N].
Vec3 force_on_box(const Scene& scene, const Contacts& contacts, int from)
{
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts)
        if (!contact.on_plane() && std::minmax(contact.body_a, contact.body_b) == std::minmax(box, from))
            sum += (contact.body_a == box ? 1 : -1) * (contact.impulse + contact.friction) / scene.dt;
    return sum;
}

}  // namespace

TEST_CASE(
    "gripper: friction alone lifts a box, each finger presses with its motor's force, and work is booked")
{
    Scene scene = load_scene(scene_file("gripper"));
    const World& world = scene.world;
    const Solver solver = chapter12_solver(scene.contact);
    Contacts contacts;
    const auto above_box = [&] { return world.bodies[hand]->centre().y() - world.bodies[box]->centre().y(); };
    const auto own_energy = [&] { return total_energy(world).total() - world.driven; };
    const double first = own_energy();
    double held = 0, slip = 0, unbooked = 0, before = first;
    for (int step = 1; step <= 300; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        if (step == 30)
            held = above_box();
        if (step > 30)
            slip = std::max(slip, std::abs(above_box() - held));
        if (step > 60 && step < 120)  // the hand rises with its speed
            unbooked = std::max(unbooked, std::abs(own_energy() - before));
        before = own_energy();
    }
    CHECK(slip < 1e-4);
    CHECK(world.bodies[hand]->centre().y() == doctest::Approx(0.9).epsilon(1e-6));
    CHECK(world.bodies[box]->centre().y() > 0.5);
    CHECK(force_on_box(scene, contacts, left).x() == doctest::Approx(20).epsilon(1e-4));
    CHECK(force_on_box(scene, contacts, right).x() == doctest::Approx(-20).epsilon(1e-4));
    const double carried = force_on_box(scene, contacts, left).y() + force_on_box(scene, contacts, right).y();
    CHECK(carried == doctest::Approx(9.81).epsilon(1e-4));
    CHECK(unbooked < 1e-6);  // of 0.14 J a step
    CHECK(own_energy() < first);
    CHECK(world.ended_badly == 0);
}

TEST_CASE("gripper: where friction holds less than the weight the box stays behind")
{
    for (const auto& [mu, lifts] : {std::pair{"0.24", false}, std::pair{"0.5", true}}) {
        CAPTURE(mu);
        const std::string patch = R"({"contact": {"friction": {"model": "mass_splitting", "mu_s": )" +
                                  std::string(mu) + R"(, "mu_d": )" + mu + "}}}";
        Scene scene = load_scene(scene_file("gripper"), patch);
        const Solver solver = chapter12_solver(scene.contact);
        Contacts contacts;
        for (int step = 0; step < 300; ++step)
            advance(scene.world, contacts, solver, scene.dt);
        CHECK((scene.world.bodies[box]->centre().y() > 0.5) == lifts);
    }
}
