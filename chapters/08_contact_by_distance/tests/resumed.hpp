#pragma once

#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/experiments/run/saved_run.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/contact_state.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace enduring::chapter08 {

/// All numbers of a world and its pairs.
inline std::vector<double> numbers_of(World& world, Contacts contacts)
{
    StateArchive archive;
    for (const auto& body : world.bodies)
        body->visit_state(archive);
    for (Contact& contact : contacts)
        visit_state(archive, contact);
    archive(world.time);
    archive(world.driven);
    return archive.numbers();
}

/// Runs a scene, saves it on the way, and goes on from there in another world: how far the two are apart at
/// the end.
inline double apart_when_resumed(const std::function<Scene()>& make,
                                 const std::function<Solver(const ContactParameters&)>& solver_for,
                                 int saved_after, int steps)
{
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "state.json";
    Scene whole = make(), second = make();
    const Solver solver = solver_for(whole.contact), other = solver_for(second.contact);
    Contacts contacts;
    for (int step = 0; step < steps; ++step) {
        if (step == saved_after)
            save_run(file, whole.world, contacts);
        advance(whole.world, contacts, solver, whole.dt);
    }
    Contacts resumed = resume_run(file, second.world);
    for (int step = saved_after; step < steps; ++step)
        advance(second.world, resumed, other, second.dt);
    CHECK(!contacts.empty());
    const std::vector<double> a = numbers_of(whole.world, contacts), b = numbers_of(second.world, resumed);
    REQUIRE(a.size() == b.size());
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, std::abs(a[i] - b[i]) / std::max(1.0, std::abs(a[i])));
    return most;
}

}  // namespace enduring::chapter08
