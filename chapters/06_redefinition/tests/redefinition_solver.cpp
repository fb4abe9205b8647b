#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/06_redefinition/resolution.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "chapters/06_redefinition/tests/small_worlds.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/tests/block_of_any_kind.hpp"
#include "common/worked_step/tests/worked_step_numbers.hpp"

#include <cmath>

using namespace enduring;

namespace {

/// Chapter 6's passes without the edge pairs that redefinitions bring: the
/// page's worked step knows vertices and faces alone.
Solver without_edge_pairs(double stiffness)
{
    Solver solver = chapter06_solver({PenaltyMethod::continuous, stiffness});
    solver.remove("edge pairs of redefinitions");
    return solver;
}

}  // namespace

TEST_CASE("worked step: redefinition, detection and impulses of this chapter give the page's numbers")
{
    tests::check_worked_step(without_edge_pairs(worked_step().stiffness));
}

TEST_CASE(
    "worked step: with vertex 2 come the two edges that lie over the diagonal, at depths worked out by hand")
{
    WorkedStep step = worked_step();
    const Solver solver = chapter06_solver({});
    for (const Pass& pass : solver.passes(StepStage::refresh))
        pass.run(step.world, step.contacts, step.dt);
    Contacts edges;
    for (const Contact& contact : step.contacts)
        if (contact.kind == ContactKind::edge_edge)
            edges.push_back(contact);
    REQUIRE(edges.size() == 2);
    // From (0.5, 0.1, 0.5) and from (0.5, -0.1, 1) to (1.5, -0.2, 1.5): over x + z = 2
    // at y = -1/20 and y = -2/15. Their cross products with the diagonal are (0.6, 4,
    // 0.6) and (0.2, 3, 0.2), and the depth is n_y y / |n|.
    const double expected[] = {-0.05 * 4 / std::sqrt(16.72), -2.0 / 15 * 3 / std::sqrt(9.08)};
    for (std::size_t i = 0; i < 2; ++i) {
        const ContactGeometry geometry = contact_geometry(step.world, edges[i], 0);
        CHECK(geometry.depth == doctest::Approx(expected[i]));
        CHECK(geometry.normal.y() > 0.9);
        CHECK_FALSE(edges[i].held());
    }
}

namespace {

Vec3 momentum(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->linear_momentum();
    return sum;
}

}  // namespace

TEST_CASE("momentum: sliding, redefined pairs of every two kinds of bodies keep it to rounding")
{
    using tests::BodyKind;
    using enum BodyKind;
    const tests::BlockCells finer{{3, 3, 3}, {2, 1, 2}};
    for (const std::pair<BodyKind, BodyKind>& kinds : {std::pair{rigid, rigid},
                                                       {rigid, linear},
                                                       {linear, rigid},
                                                       {linear, quadratic},
                                                       {quadratic, rigid}}) {
        CAPTURE(static_cast<int>(kinds.first));
        CAPTURE(static_cast<int>(kinds.second));
        World world;
        world.gravity.setZero();
        world.bodies.push_back(tests::block("above", kinds.first, {-0.3, 0.93, 0.21}, {2, -1, 0.4}, finer));
        world.bodies.push_back(tests::block("below", kinds.second, {0, 0, 0}, {0, 0.2, 0}, finer));
        const Vec3 before = momentum(world);
        Contacts contacts;
        const Solver solver = chapter06_solver({PenaltyMethod::continuous, 300});
        std::size_t most = 0;
        for (int step = 0; step < 60; ++step) {
            advance(world, contacts, solver, 0.005);
            most = std::max(most, contacts.size());
            CHECK((momentum(world) - before).norm() < 1e-11 * before.norm());
        }
        CHECK(most > 3);
    }
}

TEST_CASE("solver: the same scene gives the same bytes")
{
    std::array<std::vector<double>, 2> seen;
    for (std::vector<double>& numbers : seen) {
        Scene scene = load_scene(scene_file("hooked"));
        const RunResult result = run(scene, chapter06_solver(scene.contact), {}, {80, {}});
        for (const auto& body : scene.world.bodies)
            for (const Vec3& x : body->positions_t0())
                numbers.insert(numbers.end(), {x.x(), x.y(), x.z()});
        for (const Contact& c : result.contacts)
            numbers.insert(numbers.end(), {static_cast<double>(c.feature_a), static_cast<double>(c.feature_b),
                                           c.weights[1], c.impulse.y()});
    }
    CHECK(seen[0] == seen[1]);
}
