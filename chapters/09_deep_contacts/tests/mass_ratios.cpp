#include "chapters/09_deep_contacts/experiments/loads.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::chapter09;

namespace {

void check_that_it_rests(const std::function<Load()>& scene, double max_sunk_mm)
{
    for (const int chapter : {8, 9}) {
        CAPTURE(chapter);
        Load load = scene();
        const LoadOutcome outcome = watch(load, chapter, 1);
        CHECK(outcome.height_mm < 0.1);
        CHECK(outcome.sunk_mm < max_sunk_mm);
        CHECK(outcome.sideways_mm < 1);
        CHECK(outcome.speed < 1e-4);
        CHECK(outcome.told_at == 0);
    }
}

}  // namespace

TEST_CASE("mass ratios: a body comes to rest on one that is 20,000 times as light, whatever its mesh")
{
    for (const int cells : {1, 2}) {
        CAPTURE(cells);
        check_that_it_rests([&] { return load_of({{1, 20000}, 1, cells, 1e-3}, 0.01); }, 1);
    }
    check_that_it_rests([] { return load_of({{0.05, 1000}, 1, 1, 1e-3}, 0.01); }, 1);
}

TEST_CASE("mass ratios: a block of 100 kg on four dice of a gram stands, begun in touch or just above")
{
    for (const double gap : {0.0, 1e-3}) {
        CAPTURE(gap);
        check_that_it_rests([&] { return block_on_dice(1, gap, 0.01); }, 1);
    }
}

TEST_CASE("mass ratios: light and heavy bodies by turns come to rest, and the watch on energy is silent")
{
    check_that_it_rests([] { return load_of({{1, 5000, 1, 5000, 1, 5000}, 1, 1, 1e-4}, 0.01); }, 1);
}
