#include "common/simulation/step.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace enduring;

namespace {

Pass named(const std::string& name)
{
    return {name, [](World&, Contacts&, double) {}};
}

Solver solver() { return {"springs", {named("a"), named("b")}, {named("c")}, {named("d")}}; }

std::string names(const Solver& of, StepStage stage)
{
    std::string names;
    for (const Pass& pass : of.passes(stage))
        names += pass.name + " ";
    return names;
}

}  // namespace

TEST_CASE("solver: a pass comes last in its stage, before one that it names, in its place, or goes")
{
    Solver changed = solver();
    changed.append(StepStage::refresh, named("last"));
    changed.insert_before("b", named("between"));
    CHECK(names(changed, StepStage::refresh) == "a between b last ");
    changed.replace("between", named("other"));
    changed.remove("a");
    CHECK(names(changed, StepStage::refresh) == "other b last ");
    changed.append(StepStage::finish, named("end"));
    changed.insert_before("end", named("near the end"));
    CHECK(names(changed, StepStage::finish) == "near the end end ");
    CHECK(names(changed, StepStage::detect) == "c ");
    CHECK(names(changed, StepStage::respond) == "d ");
}

TEST_CASE("solver: a name gives its pass, and what replaces it runs in its place")
{
    Solver changed = solver();
    int runs = 0;
    changed.replace("c", "c", [&](World&, Contacts&, double) { ++runs; });
    World world;
    Contacts contacts;
    changed.pass("c").run(world, contacts, 0.1);
    CHECK(runs == 1);
    advance(world, contacts, changed, 0.1);
    CHECK(runs == 2);
}

TEST_CASE("solver: what is wrapped around a pass gets what it did, and stands in its place")
{
    Solver changed = solver();
    std::string log;
    changed.replace("c", "c", [&](World&, Contacts&, double) { log += "c "; });
    changed.wrap("c", "around c",
                 [&](const Pass::Function& inner, World& world, Contacts& contacts, double dt) {
                     log += "before ";
                     inner(world, contacts, dt);
                     log += "after ";
                 });
    World world;
    Contacts contacts;
    advance(world, contacts, changed, 0.1);
    CHECK(log == "before c after ");
    CHECK(names(changed, StepStage::detect) == "around c ");
}

TEST_CASE("solver: a name that no pass has is refused, and the message lists those there are")
{
    Solver same = solver();
    const char* message = R"(solver "springs" has no pass "x"; it has "a", "b", "c", "d")";
    CHECK_THROWS_WITH_AS(same.insert_before("x", named("y")), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(same.replace("x", named("y")), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(same.remove("x"), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(same.pass("x"), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(Solver{}.remove("x"), R"(solver "" has no pass "x"; it has none)",
                         std::invalid_argument);
    CHECK(names(same, StepStage::refresh) == "a b ");
}

TEST_CASE("solver: no two passes share a name, whatever their stages")
{
    Solver same = solver();
    const char* message = R"(solver "springs" has a pass "c" already; it has "a", "b", "c", "d")";
    CHECK_THROWS_WITH_AS(same.append(StepStage::refresh, named("c")), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(same.insert_before("a", named("c")), message, std::invalid_argument);
    CHECK_THROWS_WITH_AS(same.replace("a", named("c")), message, std::invalid_argument);
    CHECK_THROWS_AS(Solver("twins", {named("a")}, {named("a")}, {}), std::invalid_argument);
    CHECK_NOTHROW(same.replace("c", named("c")));
    CHECK(names(same, StepStage::refresh) + names(same, StepStage::detect) == "a b c ");
}
