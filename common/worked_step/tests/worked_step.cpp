#include "common/worked_step/worked_step.hpp"
#include "common/worked_step/step_record.hpp"
#include "common/worked_step/worked_step_tables.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

using namespace enduring;

namespace {

/// The page's hand computation: k dt = 1 N s/m and 1 kg a point, so
/// impulse = area of the depth = change of velocity.
struct Expected {
    std::string stage;
    std::vector<double> above_v, below_v, above_t1, below_t1;
    std::size_t contacts;
};

const std::vector<double> rest{0, 0, 0, 0};
const std::vector<double> pushed{-0.0375, -0.10625, -0.08125, -0.1},
    sunk{-0.00375, -0.010625, -0.008125, -0.01};

const std::vector<Expected> expected{
    {"start", {-2, 0, 0}, rest, {0.1, -0.1, -0.2}, rest, 2},
    {"predict", {-2, 0, 0}, rest, {-0.1, -0.1, -0.2}, rest, 2},
    {"resolve", {-2, 0, 0}, rest, {-0.1, -0.1, -0.2}, rest, 2},
    {"redefine", {-2, 0, 0}, rest, {-0.1, -0.1, -0.2}, rest, 2},
    {"detect", {-2, 0, 0}, rest, {-0.1, -0.1, -0.2}, rest, 3},
    {"respond", {-2, 0, 0}, rest, {-0.1, -0.1, -0.2}, rest, 3},
    {"apply impulses", {-1.975, 0.1, 0.2}, pushed, {-0.1, -0.1, -0.2}, rest, 3},
    {"update prediction", {-1.975, 0.1, 0.2}, pushed, {-0.0975, -0.09, -0.18}, sunk, 3},
    {"detect", {-1.975, 0.1, 0.2}, pushed, {-0.0975, -0.09, -0.18}, sunk, 3},
    {"commit", {-1.975, 0.1, 0.2}, pushed, {-0.0975, -0.09, -0.18}, sunk, 3},
};

void check_array(const std::vector<Vec3>& found, const std::vector<double>& y)
{
    REQUIRE(found.size() == y.size());
    for (std::size_t i = 0; i < y.size(); ++i) {
        CAPTURE(i);
        CHECK(found[i].y() == doctest::Approx(y[i]).epsilon(1e-14));
    }
}

void check_contact(const Contact& found, std::array<int, 4> vertices, std::array<double, 4> weights,
                   double start, bool handled, double impulse)
{
    CHECK(found.vertices == vertices);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(found.weights[i] == doctest::Approx(weights[i]).epsilon(1e-14));
    CHECK(found.start == doctest::Approx(start));
    CHECK(found.answered() == handled);
    CHECK((found.impulse - Vec3(0, impulse, 0)).norm() < 1e-15);
}

std::vector<StageRecord> recorded()
{
    WorkedStep step = worked_step();
    return record_step(step.world, step.contacts, worked_step_solver(step.stiffness), step.dt);
}

}  // namespace

TEST_CASE("worked step: every array after every stage is the page's hand computation")
{
    const std::vector<StageRecord> records = recorded();
    REQUIRE(records.size() == expected.size());
    for (std::size_t i = 0; i < records.size(); ++i) {
        CAPTURE(i);
        CAPTURE(expected[i].stage);
        CHECK(records[i].stage == expected[i].stage);
        check_array(records[i].bodies[0].velocities, expected[i].above_v);
        check_array(records[i].bodies[1].velocities, expected[i].below_v);
        check_array(records[i].bodies[0].positions_t1, expected[i].above_t1);
        check_array(records[i].bodies[1].positions_t1, expected[i].below_t1);
        const bool committed = expected[i].stage == "commit";
        check_array(records[i].bodies[0].positions_t0,
                    committed ? expected[i].above_t1 : expected[0].above_t1);
        check_array(records[i].bodies[1].positions_t0, committed ? sunk : rest);
        CHECK(records[i].contacts.size() == expected[i].contacts);
    }
}

TEST_CASE("worked step: the three pairs are an enduring one, a redefined one and a new one")
{
    const std::vector<StageRecord> records = recorded();
    check_contact(records[0].contacts[1], {2, 0, 1, 2}, {1, 0, -0.5, -0.5}, 0, true, 0.2);
    check_contact(records[1].contacts[1], {2, 0, 1, 2}, {1, 0, -0.5, -0.5}, 0, false, 0);
    const Contacts& redefined = records[3].contacts;
    check_contact(redefined[0], {1, 0, 1, 2}, {1, -0.25, -0.5, -0.25}, 0, false, 0);
    check_contact(redefined[1], {2, 3, 2, 1}, {1, -0.5, -0.25, -0.25}, 0, false, 0);
    const Contacts& end = records.back().contacts;
    check_contact(end[0], {1, 0, 1, 2}, {1, -0.25, -0.5, -0.25}, 0, true, 0.1);
    check_contact(end[1], {2, 3, 2, 1}, {1, -0.5, -0.25, -0.25}, 0, true, 0.2);
    check_contact(end[2], {0, 0, 1, 2}, {1, -0.5, -0.25, -0.25}, 0.5, true, 0.025);
}

TEST_CASE("worked step: the impulses move momentum from one body to the other and make none")
{
    WorkedStep step = worked_step();
    const Vec3 before = step.world.bodies[0]->linear_momentum() + step.world.bodies[1]->linear_momentum();
    advance(step.world, step.contacts, worked_step_solver(step.stiffness), step.dt);
    const Vec3 after = step.world.bodies[0]->linear_momentum() + step.world.bodies[1]->linear_momentum();
    CHECK((after - before).norm() < 1e-15);
    CHECK(step.world.bodies[0]->linear_momentum().y() == doctest::Approx(-2 + 0.325));
}

TEST_CASE("worked step: in the next step all three pairs endure and push from its start")
{
    WorkedStep step = worked_step();
    const Solver solver = worked_step_solver(step.stiffness);
    advance(step.world, step.contacts, solver, step.dt);
    const std::vector<StageRecord> records = record_step(step.world, step.contacts, solver, step.dt);
    REQUIRE(records[1].stage == "predict");
    for (const Contact& contact : records[1].contacts) {
        CHECK(contact.start == 0);
        CHECK_FALSE(contact.answered());
        CHECK(contact.impulse.isZero());
    }
    CHECK(records.back().contacts.size() == 3);
}

TEST_CASE(
    "worked step: the page's tables have a column for each stage that changed the array and a row for each vertex")
{
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "enduring_worked_step";
    Report report(folder);
    write_worked_step(worked_step_solver(worked_step().stiffness), report);
    std::ifstream file(folder / "worked_step_velocities.md");
    std::ostringstream text;
    text << file.rdbuf();
    CHECK(text.str().find("| start to respond | apply impulses to commit |") != std::string::npos);
    CHECK(text.str().find("below 3") != std::string::npos);
    CHECK(text.str().find("1.975") != std::string::npos);
    CHECK(std::filesystem::exists(folder / "worked_step_contacts.md"));
    std::filesystem::remove_all(folder);
}
