#include "chapters/07_implicit_contact/islands.hpp"
#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace enduring;
using namespace enduring::chapter07;

namespace {

/// Bodies of which every third stands still, and pairs between any two of them, a plane, or one body and
/// itself.
struct RandomPairs {
    World world;
    Contacts contacts;

    RandomPairs(int bodies, int pairs, unsigned seed)
    {
        const SurfaceMesh shape = box(Vec3::Ones());
        for (int i = 0; i < bodies; ++i)
            if (i % 3 == 1)
                world.bodies.push_back(std::make_unique<StaticBody>(
                    "fixed", SurfaceTopology(static_cast<int>(shape.vertices.size()), shape.faces),
                    shape.vertices));
            else
                world.bodies.push_back(
                    std::make_unique<PointMasses>("free", shape.vertices, shape.faces, 1.0));
        std::mt19937 random(seed);
        const auto below = [&](int count) {
            return static_cast<int>(random() % static_cast<unsigned>(count));
        };
        for (int i = 0; i < pairs; ++i) {
            Contact contact;
            contact.kind = static_cast<ContactKind>(below(3));
            contact.body_a = below(bodies);
            contact.body_b = below(bodies);
            contact.hold(below(8) == 0);
            contact.resolved = below(8) == 0;
            contacts.push_back(contact);
        }
    }

    bool moves(int body) const { return !world.bodies[static_cast<std::size_t>(body)]->is_static(); }
    /// Bodies that a pair which takes part touches, without those that stand still.
    std::vector<int> moved_by(const Contact& contact) const
    {
        std::vector<int> moved;
        if (contact.held() || contact.resolved)
            return moved;
        if (moves(contact.body_a))
            moved.push_back(contact.body_a);
        if (!contact.on_plane() && moves(contact.body_b))
            moved.push_back(contact.body_b);
        return moved;
    }
    /// The least body that each can be reached from, -1 for one that no pair touches: every pair hands the
    /// lesser number on, until none has anything to hand on.
    std::vector<int> least_reached() const
    {
        std::vector<int> least(world.bodies.size(), -1);
        for (const Contact& contact : contacts)
            for (const int body : moved_by(contact))
                least[static_cast<std::size_t>(body)] = body;
        for (bool any = true; any;) {
            any = false;
            for (const Contact& contact : contacts)
                for (const int one : moved_by(contact))
                    for (const int other : moved_by(contact))
                        if (int& mine = least[static_cast<std::size_t>(one)],
                            theirs = least[static_cast<std::size_t>(other)];
                            theirs < mine) {
                            mine = theirs;
                            any = true;
                        }
        }
        return least;
    }
};

using States = std::vector<std::vector<double>>;

/// All that bodies from `first` on are, after each of some steps.
/// @param per_step  is told the world after each
States run(Scene& scene, ImplicitSettings settings, int steps, std::size_t first, std::size_t count)
{
    Solver solver = chapter07_solver(scene.contact, std::move(settings));
    solver.max_halvings = 0;  // halves are taken by all islands together
    Contacts contacts;
    States states;
    for (int i = 0; i < steps; ++i) {
        advance(scene.world, contacts, solver, scene.dt);
        for (std::size_t body = first; body < first + count; ++body)
            states.push_back(state_of(*scene.world.bodies[body]));
    }
    return states;
}

ImplicitSettings quiet()
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return settings;
}

/// A stack that falls by a little, somewhere.
std::vector<Box> stack_at(double x, int cubes, double mass)
{
    std::vector<Box> boxes = stack_of(cubes, mass, mass);
    for (Box& box : boxes) {
        box.mass = mass;
        box.centre += Vec3(x, 0.02, 0);
    }
    return boxes;
}

std::vector<Box> both(std::vector<Box> one, const std::vector<Box>& other)
{
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

}  // namespace

TEST_CASE("islands: they are what pairs between bodies that move join, each pair in one of them")
{
    std::size_t most = 0, largest = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        CAPTURE(seed);
        RandomPairs random(30, 5 + static_cast<int>(seed % 40), seed);
        const std::vector<int> least = random.least_reached();
        const std::vector<Island> islands = find_islands(random.world, random.contacts);
        std::size_t bodies = 0, pairs = 0;
        int before = -1;
        for (const Island& island : islands) {
            CHECK(island.bodies.front() > before);
            before = island.bodies.front();
            CHECK(std::is_sorted(island.bodies.begin(), island.bodies.end()));
            for (const int body : island.bodies)
                CHECK(least[static_cast<std::size_t>(body)] == island.bodies.front());
            CHECK(std::is_sorted(island.contacts.begin(), island.contacts.end()));
            for (const Contact* contact : island.contacts)
                CHECK(least[static_cast<std::size_t>(random.moved_by(*contact).at(0))] ==
                      island.bodies.front());
            bodies += island.bodies.size();
            pairs += island.contacts.size();
            largest = std::max(largest, island.bodies.size());
        }
        most = std::max(most, islands.size());
        CHECK(bodies == least.size() - static_cast<std::size_t>(std::count(least.begin(), least.end(), -1)));
        CHECK(pairs == static_cast<std::size_t>(std::count_if(
                           random.contacts.begin(), random.contacts.end(),
                           [&](const Contact& contact) { return !random.moved_by(contact).empty(); })));
    }
    CHECK(most > 5);
    CHECK(largest > 10);
}

TEST_CASE("islands: a stack moves as it does alone, to the last bit, whatever stands far from it")
{
    for (const double mass : {0.01, 10.0, 1e4}) {
        CAPTURE(mass);
        const std::vector<Box> one = stack_at(0, 4, 10), other = stack_at(20, 3, mass);
        Scene together = scene_of(both(one, other), 0.01), first = scene_of(one, 0.01),
              second = scene_of(other, 0.01), again = scene_of(both(one, other), 0.01);
        CHECK(run(together, quiet(), 40, 0, 4) == run(first, quiet(), 40, 0, 4));
        CHECK(run(again, quiet(), 40, 4, 3) == run(second, quiet(), 40, 0, 3));
    }
}

TEST_CASE(
    "islands: a soft body moves as it does alone, to the last bit, whatever rigid ones stand far from it")
{
    const auto soft_and = [](const std::vector<Box>& boxes) {
        Scene scene = soft_cube_on_triangles({2, 1e5, 0.01, 100}, 0.5);
        Scene others = scene_of(boxes, scene.dt);
        for (auto& body : others.world.bodies)
            scene.world.bodies.push_back(std::move(body));
        scene.world.planes = std::move(others.world.planes);
        scene.world.planes.at(0).point.y() = -5;
        return scene;
    };
    std::vector<Box> boxes = stack_at(60, 3, 5000);
    for (Box& box : boxes)
        box.centre.y() -= 5;
    Scene alone = soft_and({}), together = soft_and(boxes);
    const std::size_t own = alone.world.bodies.size();
    CHECK(run(together, quiet(), 25, 0, own) == run(alone, quiet(), 25, 0, own));
}

TEST_CASE("islands: one, two and four threads make the same bytes")
{
    const auto with_threads = [](int threads) {
        std::vector<Box> boxes;
        for (int i = 0; i < 6; ++i)
            boxes = both(boxes, stack_at(5 * i, 1 + i % 3, i == 2 ? 1000 : 10));
        for (Box& box : boxes)
            box.centre.y() -= 5;
        Scene scene = scene_of(boxes, 0.01);
        Scene soft = soft_cube_on_triangles({2, 1e5, 0.01, 100}, 0.5);
        for (auto& body : soft.world.bodies)
            scene.world.bodies.push_back(std::move(body));
        scene.world.planes.at(0).point.y() = -5;
        ImplicitSettings settings = quiet();
        settings.threads = threads;
        settings.pairs_for_threads = 0;
        return run(scene, settings, 30, 0, scene.world.bodies.size());
    };
    const States four = with_threads(4);  // the first to ask for several decides how many there are at most
    CHECK(with_threads(2) == four);
    CHECK(with_threads(1) == four);
}

TEST_CASE("islands: one that is not solved takes nothing from another one, and is told")
{
    // Ten cubes fall on each other with a turn; a cube lies still: this takes less than the bound.
    std::vector<Box> fall = stack_at(0, 10, 10);
    for (std::size_t i = 0; i < fall.size(); ++i) {
        fall[i].centre.y() += 0.05 * static_cast<double>(i);
        fall[i].spin = Vec3(1, 2, 3);
    }
    const std::vector<Box> still{{10, Vec3(20, 0.5, 0)}};
    ImplicitSettings settings;
    settings.max_newton_steps = 6;
    int unsolved = 0, solved_of_two = 0;
    bool is_told = true;
    StepTrouble last = StepTrouble::none;
    Scene together = scene_of(both(fall, still), 0.01), alone = scene_of(still, 0.01);
    settings.record = [&](const SolveRecord& record) {
        is_told = is_told && record.converged == (record.unsolved_islands == 0) &&
                  (record.converged == (record.residual <= settings.tolerance));
        unsolved += record.unsolved_islands;
        solved_of_two += record.islands - record.unsolved_islands;
        if (record.residual > settings.kept_residual)
            last = together.world.attempt.trouble;
    };
    const States beside = run(together, settings, 60, 10, 1);
    CHECK(unsolved > 5);
    CHECK(solved_of_two >= 60);
    CHECK(is_told);
    CHECK(last == StepTrouble::unsolved);
    int unsolved_alone = 0;
    settings.record = [&](const SolveRecord& record) { unsolved_alone += record.unsolved_islands; };
    CHECK(beside == run(alone, settings, 60, 0, 1));
    CHECK(unsolved_alone == 0);
}

TEST_CASE("islands: where two become one in a step, it goes on with the larger count of Newton steps")
{
    ContactProblem problem;
    problem.blocks.push_back({0, Mat3::Identity(), Mat3::Identity()});
    problem.size = 3;
    const std::vector<Island> two{{{0, 2}, {}}, {{1, 3}, {}}}, one{{{0, 1, 2, 3}, {}}};
    IslandMatrices matrices;
    matrices.begin_response(two, 4, true);
    for (int i = 0; i < 5; ++i)
        matrices.of(two[1]).solve(problem, {}, Eigen::Vector3d::Ones());
    matrices.of(two[0]).solve(problem, {}, Eigen::Vector3d::Ones());
    matrices.begin_response(one, 4, false);
    CHECK(matrices.of(one[0]).solves() == 5);
    matrices.begin_response(two, 4, true);
    CHECK(matrices.of(two[0]).solves() == 0);
    CHECK(matrices.of(two[1]).solves() == 0);
    // what one of them took in the step before does not count in a step in which they are one from the first
    matrices.of(two[1]).solve(problem, {}, Eigen::Vector3d::Ones());
    matrices.begin_response(one, 4, true);
    matrices.begin_response(one, 4, false);
    CHECK(matrices.of(one[0]).solves() == 0);
    // nor in a step in which it is touched by nothing at first
    matrices.begin_response(two, 4, true);
    matrices.of(two[1]).solve(problem, {}, Eigen::Vector3d::Ones());
    matrices.begin_response({two[0]}, 4, true);
    matrices.begin_response(one, 4, false);
    CHECK(matrices.of(one[0]).solves() == 0);
}
