#include "exercises/08_contact_by_distance/3_first_crossing.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

using namespace enduring;

namespace {

std::string told(const std::vector<Passage>& passages)
{
    std::string words;
    for (const Passage& passage : passages)
        words += in_words(words.empty() ? "" : ", ", "side ", passage.side, " of body ", passage.body, " at ",
                          passage.time);
    return words.empty() ? "none" : words;
}

/// A solve that gives up where rounds do not end.
Solve counted(const Solve& solve)
{
    return [solve, count = 0](const Vec2& free_end, const std::vector<SidePair>& pairs) mutable {
        if (++count > 100)
            throw std::runtime_error("more than 100 solves in one step");
        return solve(free_end, pairs);
    };
}

/// A pair of which only the side counts.
SidePair known(int body, int side) { return {body, side, Vec2::Zero(), Vec2::UnitY()}; }

void expect_decision(const std::vector<Passage>& found, const std::vector<SidePair>& pairs,
                     const std::vector<Passage>& expected, bool halve)
{
    const Decision got = decide(found, pairs);
    given("passages: ", told(found), "; ", pairs.size(), " known pairs",
          pairs.empty() ? "" : in_words(", the first with side ", pairs[0].side, " of body ", pairs[0].body));
    const bool same = std::equal(
        got.new_pairs.begin(), got.new_pairs.end(), expected.begin(), expected.end(),
        [](const Passage& a, const Passage& b) { return a.body == b.body && a.side == b.side; });
    expect_that(in_words("the step is ", halve ? "" : "not ", "halved"), got.halve == halve);
    if (!halve)
        expect_that(in_words("new pairs: ", told(expected), "; got: ", told(got.new_pairs)), same);
}

void expect_end(const std::vector<Outline>& bodies, const Vec2& start, const Vec2& free_end, const Vec2& end)
{
    const std::optional<Vec2> got = end_by_first(bodies, start, free_end, counted(nearest_end));
    given("from ", readable(start), " m, without contact to ", readable(free_end), " m");
    expect_that("the step has an end", got.has_value());
    if (got)
        expect("end of the step", *got, end, 1e-9, "m");
}

const Outline table{{0, -0.5}, {1, -0.5}, {1, 0}, {0, 0}};
/// A floor, and a wall that stands on it from x = 1 on.
const Outline room{{0, -1}, {2, -1}, {2, 2}, {1, 2}, {1, 0}, {0, 0}};

/// Teeth of 20 mm, 2 mm high, from x = 0 on.
Outline washboard(int teeth)
{
    Outline outline{{0, -0.1}, {0.02 * teeth, -0.1}};
    for (int i = teeth - 1; i >= 0; --i) {
        outline.emplace_back(0.02 * (i + 1), 0);
        outline.emplace_back(0.02 * i + 0.01, 0.002);
    }
    outline.emplace_back(0, 0);
    return outline;
}

/// Convex, with corners on a circle.
Outline pebble(RandomInputs& random, const Vec2& middle)
{
    std::vector<double> angles;
    for (int i = 0; i < 7; ++i)
        angles.push_back(2 * std::numbers::pi * (i + random.number(0, 0.8)) / 7);
    Outline outline;
    for (const double angle : angles)
        outline.push_back(middle + 0.4 * Vec2(std::cos(angle), std::sin(angle)));
    return outline;
}

bool is_inside(const Outline& convex, const Vec2& x)
{
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2 along = convex[(i + 1) % convex.size()] - convex[i];
        if (Vec2(along.y(), -along.x()).normalized().dot(x - convex[i]) > -1e-8)
            return false;
    }
    return true;
}

}  // namespace

TEST_CASE("decision: of a body the first passage becomes a pair, and later ones are consequences")
{
    expect_decision({}, {}, {}, false);
    expect_decision({{0.5, 0, 3}}, {}, {{0.5, 0, 3}}, false);
    expect_decision({{0.5, 0, 3}, {0.2, 0, 7}, {0.9, 0, 1}}, {}, {{0.2, 0, 7}}, false);
    expect_decision({{0.5, 2, 3}, {0.2, 0, 7}, {0.9, 0, 1}, {0.6, 2, 8}, {0.8, 1, 7}}, {},
                    {{0.2, 0, 7}, {0.8, 1, 7}, {0.5, 2, 3}}, false);
}

TEST_CASE("decision: what follows the first within a fiftieth of the step is the same impact")
{
    expect_decision({{0.519, 0, 1}, {0.5, 0, 2}, {0.521, 0, 3}}, {}, {{0.5, 0, 2}, {0.519, 0, 1}}, false);
    expect_decision({{0.53, 0, 1}, {0.5, 0, 2}, {0.515, 0, 3}}, {}, {{0.5, 0, 2}, {0.515, 0, 3}}, false);
    expect_decision({{0.51, 1, 1}, {0.5, 0, 2}, {0.525, 1, 3}}, {},
                    {{0.5, 0, 2}, {0.51, 1, 1}, {0.525, 1, 3}}, false);
}

TEST_CASE("decision: a known pair that is passed first has the step halved, unless a new one comes with it")
{
    expect_decision({{0.5, 0, 3}}, {known(0, 3)}, {}, true);
    expect_decision({{0.5, 0, 3}, {0.6, 0, 4}}, {known(0, 3)}, {}, true);
    expect_decision({{0.5, 0, 3}, {0.51, 0, 4}}, {known(0, 3)}, {{0.51, 0, 4}}, false);
    expect_decision({{0.5, 0, 3}, {0.6, 0, 4}}, {known(0, 4)}, {{0.5, 0, 3}}, false);
    expect_decision({{0.5, 1, 3}}, {known(0, 3)}, {{0.5, 1, 3}}, false);
    expect_decision({{0.5, 1, 3}, {0.4, 0, 2}}, {known(1, 3)}, {{0.4, 0, 2}}, true);
    expect_decision({{0.5, 0, 3}, {0.4, 1, 2}}, {known(0, 5), known(0, 3)}, {{0.4, 1, 2}}, true);
}

TEST_CASE("pair: it leads to where the point is at the start, whether this is out of the body or not")
{
    RandomInputs random(3);
    for (int trial = 0; trial < 50; ++trial) {
        const std::vector<Outline> bodies{table, pebble(random, {3, 1})};
        const int body = random.whole(0, 1), side = random.whole(0, body == 0 ? 3 : 6);
        const Vec2 start(random.number(-1, 4), random.number(-1, 3));
        const Outline& outline = bodies[static_cast<std::size_t>(body)];
        const Vec2 one = outline[static_cast<std::size_t>(side)],
                   other = outline[static_cast<std::size_t>(side + 1) % outline.size()];
        const SidePair pair = pair_with(bodies, {0.5, body, side}, start);
        given("a side from ", readable(one), " to ", readable(other), ", start ", readable(start));
        expect_that("it is a pair with this side", pair.body == body && pair.side == side);
        expect("length of the normal", pair.normal.norm(), 1, 1e-12);
        expect("height of one end over the line", pair.normal.dot(one - pair.place), 0, 1e-12, "m");
        expect("height of the other end", pair.normal.dot(other - pair.place), 0, 1e-12, "m");
        expect_that("the start is in front", pair.normal.dot(start - pair.place) > 0);
    }
}

TEST_CASE("end: where nothing is passed the point goes on, and what it meets it slides along")
{
    expect_end({table}, {0.2, 0.3}, {0.4, 0.1}, {0.4, 0.1});
    expect_end({table}, {0.2, 0.1}, {0.4, -0.1}, {0.4, 0});
    expect_end({table}, {-0.2, -0.1}, {0.3, -0.2}, {0, -0.2});
}

TEST_CASE("end: over the rim of a table, by the first passage and by all passages")
{
    expect_end({table}, {0.8, 0.01}, {1.2, -0.2}, {1.2, 0});
    given(
        "from (0.8, 0.01) m, without contact to (1.2, -0.2) m: in through the upper side, out through the right one");
    expect("end with all passages of the free path",
           end_by_all({table}, {0.8, 0.01}, {1.2, -0.2}, nearest_end), Vec2(1, 0), 1e-9, "m");
}

TEST_CASE("end: in a corner of a room, by the first passage and by all passages")
{
    expect_end({room}, {0.8, 0.1}, {1.3, -0.4}, {1, 0});
    given("from (0.8, 0.1) m, without contact to (1.3, -0.4) m, under the wall that begins at x = 1");
    expect("end with all passages of the free path, inside the wall",
           end_by_all({room}, {0.8, 0.1}, {1.3, -0.4}, nearest_end), Vec2(1.3, 0), 1e-9, "m");
}

TEST_CASE("end: over a washboard the point flies up along the tooth that it meets first")
{
    const Outline board = washboard(10);
    const Vec2 start(-0.05, 0.0062), free_end(0.15, -0.0058);
    const Vec2 normal = Vec2(-0.2, 1).normalized(), foot(0.02, 0);  // of the second tooth
    expect_end({board}, start, free_end, free_end - normal.dot(free_end - foot) * normal);
    const Vec2 all = end_by_all({board}, start, free_end, nearest_end);
    given("ten teeth, from ", readable(start), " m, without contact to ", readable(free_end), " m");
    expect_that("with all passages of the free path it hangs on the tooth's tip",
                (all - Vec2(0.03, 0.002)).norm() < 1e-3);
    const auto first = end_by_first({board}, start, free_end, counted(nearest_end));
    say("over a washboard, 200 mm without contact: ", 1e3 * (first.value_or(start) - start).x(),
        " mm by the first passage, ", 1e3 * (all - start).x(), " mm by all");
}

TEST_CASE("end: each solve begins at the free end, with all pairs so far")
{
    std::vector<std::size_t> counts;
    bool always_free = true;
    const Vec2 free_end(1.3, -0.4);
    const Solve watched = [&](const Vec2& from, const std::vector<SidePair>& pairs) {
        counts.push_back(pairs.size());
        always_free = always_free && from == free_end;
        return nearest_end(from, pairs);
    };
    end_by_first({room}, {0.8, 0.1}, free_end, counted(watched));
    given("a floor and then a wall, from (0.8, 0.1) m, without contact to (1.3, -0.4) m");
    expect_that("there are two solves, with one pair and with two",
                counts == std::vector<std::size_t>{1, 2} || counts == std::vector<std::size_t>{0, 1, 2});
    expect_that("each begins at the free end", always_free);
}

TEST_CASE("end: a spring that lets the point through has the step halved")
{
    const Solve weak = [](const Vec2& from, const std::vector<SidePair>& pairs) {
        return Vec2(0.1 * from + 0.9 * nearest_end(from, pairs));
    };
    given("a solve that leaves a tenth of the depth; from (0.2, 0.1) m, without contact to (0.4, -0.1) m");
    expect_that("the step has no end", !end_by_first({table}, {0.2, 0.1}, {0.4, -0.1}, counted(weak)));
    given("the same solve, and nothing in the path");
    expect_that("the step has an end", end_by_first({table}, {0.2, 0.1}, {0.4, 0.05}, weak).has_value());
}

TEST_CASE("end: among random pebbles nothing is passed, and no point ends inside")
{
    RandomInputs random(4);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<Outline> bodies;
        for (const Vec2& middle : {Vec2(0, 0), Vec2(1, 0), Vec2(0.5, 0.9)})
            bodies.push_back(pebble(random, middle));
        const double angle = random.number(0, 2 * std::numbers::pi);
        const Vec2 start = Vec2(0.5, 0.3) + 1.2 * Vec2(std::cos(angle), std::sin(angle)),
                   free_end(random.number(-0.5, 1.5), random.number(-0.5, 1.5));
        const auto end = end_by_first(bodies, start, free_end, counted(nearest_end));
        given("three pebbles, trial ", trial, ", from ", readable(start), " m, without contact to ",
              readable(free_end), " m");
        expect_that("the step has an end", end.has_value());
        if (!end)
            return;
        const bool inside = std::any_of(bodies.begin(), bodies.end(),
                                        [&](const Outline& body) { return is_inside(body, *end); });
        expect_that("it ends outside", !inside);
        expect_that("its path passes nothing", passages(bodies, start, *end).empty());
        if (inside)
            return;
    }
}
