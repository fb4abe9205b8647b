#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/plane_contact.hpp"
#include "chapters/01_particle_plane/settling.hpp"
#include "chapters/01_particle_plane/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

TEST_CASE("thesis figure 7.1: CPF settles at 0.14 s and not at 0.17 s, DPF at 0.11 s and not at 0.13 s")
{
    const auto settles_with = [](PenaltyMethod method, double dt) {
        return settles(ParticleProblem{1, 100, 9.81, method, dt});
    };
    CHECK(settles_with(PenaltyMethod::continuous, 0.14));
    CHECK_FALSE(settles_with(PenaltyMethod::continuous, 0.17));
    CHECK(settles_with(PenaltyMethod::discrete, 0.11));
    CHECK_FALSE(settles_with(PenaltyMethod::discrete, 0.13));
}

TEST_CASE("thesis figure 7.2: at k = 1000 and dt = 0.01 CPF bounces several times, DPF hardly")
{
    const auto times_in_the_air = [](PenaltyMethod method) {
        const ParticleProblem problem{1, 1000, 9.81, method, 0.01};
        ParticleState state{0.1, 0};
        int bounces = 0;
        for (int i = 0; i < 2000; ++i) {
            const ParticleState next = step(state, problem);
            bounces += state.height < 0 && next.height > 0;
            state = next;
        }
        return bounces;
    };
    CHECK(times_in_the_air(PenaltyMethod::discrete) == 1);
    CHECK(times_in_the_air(PenaltyMethod::continuous) >= 3);
}

TEST_CASE(
    "ground scene: the bar comes to rest, the plane carries its weight, and no element turns inside out")
{
    for (const char* method : {"cpf", "dpf"}) {
        CAPTURE(method);
        Scene scene = load_scene(
            scene_file("ground"),
            std::string(R"({"duration": 1.6, "contact": {"method": ")") + method + R"("}})");
        int inverted = 0;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            inverted += world.bodies[0]->inverted_elements();
        });
        const RunResult result = run(scene, chapter01_solver(scene.contact), {&watch});
        Vec3 force = Vec3::Zero();
        for (const Contact& contact : result.contacts)
            if (contact.body_a == 0)
                force += contact.impulse / scene.dt;
        CHECK(inverted == 0);
        CHECK((force - Vec3(0, scene.world.bodies[0]->mass() * 9.81, 0)).norm() <= 0.1);
        CHECK(scene.world.bodies[0]->linear_momentum().norm() <= 0.01);
    }
}
