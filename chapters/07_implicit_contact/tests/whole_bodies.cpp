#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/07_implicit_contact/tests/only_island.hpp"
#include "common/simulation/deformable_body.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace enduring;
using nlohmann::json;

namespace {

constexpr double dense = std::numeric_limits<double>::infinity(), whole = 0;

/// Just above the ground.
/// @param change  of its body
Scene low_mat(int cells, const json& change = json::object())
{
    json mat{{"density", 60},
             {"position", {0, 0.045, 0}},
             {"rotation", {{"axis", {1, 0, 0.3}}, {"angle_deg", 1}}},
             {"velocity", {0.3, -0.5, 0}}};
    mat.update(change);
    return chapter07::falling_mat(1, cells, mat);
}

struct Landed {
    std::vector<Vec3> positions;
    double energy = 0;
    long newton_steps = 0;
};

/// @param restitution  of all bodies
Landed land(Scene scene, double sparse_operation, double restitution = 0)
{
    scene.world.restitution.between = {restitution};
    ImplicitSettings settings;
    settings.sparse_operation = sparse_operation;
    Landed landed;
    settings.record = [&](const SolveRecord& record) {
        CHECK(record.converged);
        landed.newton_steps += record.newton_steps;
    };
    const Solver solver = chapter07_solver(scene.contact, settings);
    Contacts contacts;
    for (int i = 0; i < 25; ++i)
        advance(scene.world, contacts, solver, scene.dt);
    CHECK(scene.world.ended_badly == 0);
    const auto positions = scene.world.bodies[0]->positions_t0();
    landed.positions.assign(positions.begin(), positions.end());
    landed.energy = scene.world.bodies[0]->energy(scene.world.gravity).total();
    return landed;
}

double largest_difference(const Landed& one, const Landed& other)
{
    double largest = 0;
    for (std::size_t i = 0; i < one.positions.size(); ++i)
        largest = std::max(largest, (one.positions[i] - other.positions[i]).norm());
    return largest;
}

}  // namespace

TEST_CASE("whole bodies: a mat lands as with a dense block, free, held or driven, of any law")
{
    const json edge{{"min", {-0.51, -1, -1}}, {"max", {-0.49, 1, 1}}};
    json driven = edge;
    driven["motion"] = {{"velocity", {0.1, 0.2, 0}}};
    const std::pair<std::string, json> mats[] = {{"free", json::object()},
                                                 {"held", {{"fixed", edge}}},
                                                 {"driven", {{"driven", json::array({driven})}}},
                                                 {"neo-Hookean", {{"elasticity", "neo_hookean"}}}};
    for (const auto& [name, change] : mats) {
        CAPTURE(name);
        const Landed one = land(low_mat(3, change), dense), other = land(low_mat(3, change), whole);
        CHECK(largest_difference(one, other) < 1e-4);
        CHECK(other.energy == doctest::Approx(one.energy).epsilon(1e-4));
        CHECK(other.newton_steps < one.newton_steps);
    }
}

TEST_CASE("whole bodies: a mat that bounces does so as with a dense block")
{
    const Landed one = land(low_mat(3), dense, 0.7), other = land(low_mat(3), whole, 0.7);
    CHECK(largest_difference(one, other) < 2e-5);
    CHECK(largest_difference(one, land(low_mat(3), dense)) > 1e-3);
}

TEST_CASE(
    "whole bodies: one enters so where a sparse factor takes fewer operations, and nothing held in part does")
{
    const auto enters = [](Scene scene, double sparse_operation) {
        Contacts contacts;
        const Solver solver = chapter07_solver(scene.contact);
        for (int i = 0; i < 10; ++i)
            advance(scene.world, contacts, solver, scene.dt);
        scene.world.bodies[0]->predict(scene.world.gravity, scene.dt);
        const std::vector<Island> islands = find_islands(scene.world, contacts);
        REQUIRE(islands.size() == 1);
        const StepProblem step = set_up(scene.world, islands[0], {}, {}, {1, scene.dt}, false,
                                        sparse_operation);
        const auto& soft = dynamic_cast<const DeformableBody&>(*scene.world.bodies[0]);
        const bool is_whole = step.problem.blocks[0].whole != nullptr;
        CHECK(step.problem.size ==
              3 * (is_whole ? soft.elastic().node_count() : static_cast<int>(step.vertices[0].size())));
        for (const PairRow& row : step.problem.rows)
            CHECK(row.part_count == 1);
        return is_whole;
    };
    const double usual = ImplicitSettings{}.sparse_operation;
    CHECK(enters(low_mat(6), usual));
    CHECK_FALSE(enters(low_mat(2), usual));
    CHECK(enters(low_mat(2), whole));
    CHECK_FALSE(enters(low_mat(6), dense));
    const json corner{
        {"ball", {{"centre", {-0.5, -0.02, -0.5}}, {"radius", 0.01}}}};  // not the middles of its edges
    CHECK(enters(low_mat(2, {{"fixed", corner}}), whole));
}

TEST_CASE("whole bodies: behind elements that moved, the convex problem begins where the pairs were before")
{
    CHECK(land(low_mat(4), whole).newton_steps <
          300);  // 290, and 310 where it begins at the present velocities
}
