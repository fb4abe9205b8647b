#include "chapters/08_contact_by_distance/experiments/constants.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::chapter08;

namespace {

ConstantsOutcome stack_with(const std::string& name, const std::string& of_its_value)
{
    const std::vector<ChangedConstant> all = changed_constants();
    const auto found = std::find_if(all.begin(), all.end(), [&](const ChangedConstant& constant) {
        return constant.name == name && constant.of_its_value == of_its_value;
    });
    REQUIRE(found != all.end());
    return run_with(*found, constants_scene(0, true), 60);
}

}  // namespace

TEST_CASE(
    "constants: with a tenth of h a stack is pressed deeper where it lands, and it rests no deeper than the wanted depth")
{
    const ConstantsOutcome as_is = stack_with("none", "1"), soft = stack_with("h = k dt^2 / m", "1/10"),
                           wide = stack_with("wanted depth", "10");
    CHECK(as_is.at_end_m < 1e-5);
    CHECK(soft.deepest_m > 3 * as_is.deepest_m);
    CHECK(wide.at_end_m < 1e-4);
}

TEST_CASE("constants: the weight of CPF leaves a stack deeper after its impacts than the end of the step")
{
    const ConstantsOutcome end = stack_with("none", "1"),
                           mean = stack_with("weight a over the step; it is 1", "1/2");
    CHECK(mean.deepest_m > 1.5 * end.deepest_m);
    CHECK(mean.speed > end.speed);
}

TEST_CASE("constants: of a heap each change does something, or is told as one that does not")
{
    long that_change = 0;
    const ConstantsOutcome as_is = run_with(changed_constants()[0], constants_scene(1, true), 40);
    for (const ChangedConstant& constant : changed_constants()) {
        const ConstantsOutcome run = run_with(constant, constants_scene(1, true), 40);
        CHECK_FALSE(run.stopped);
        that_change += run.deepest_m != as_is.deepest_m || run.newton_steps != as_is.newton_steps;
    }
    CHECK(that_change > 8);
}
