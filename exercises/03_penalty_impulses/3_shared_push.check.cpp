#include "exercises/03_penalty_impulses/3_shared_push.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>
#include <numbers>

using namespace enduring;

namespace {

Patch patch_of(std::vector<Vec3> positions, std::vector<double> masses)
{
    const std::size_t count = positions.size();
    return {std::move(positions), std::move(masses), std::vector<Vec3>(count, Vec3::Zero())};
}

/// A vertex with six neighbours around it, 5 cm away in the plane y = 0.
Patch six_around(double own_mass, double their_mass)
{
    std::vector<Vec3> positions{Vec3::Zero()};
    std::vector<double> masses{own_mass};
    for (int i = 0; i < 6; ++i) {
        const double angle = i * std::numbers::pi / 3;
        positions.emplace_back(0.05 * std::cos(angle), 0, 0.05 * std::sin(angle));
        masses.push_back(their_mass);
    }
    return patch_of(positions, masses);
}

/// Nodes and masses at random, in a box of 20 cm or flat in a plane that lies askew. Coordinates are
/// multiples of 2^-12 m, so that sums and halves of them are exact, and flat stays flat.
Patch random_patch(unsigned seed, bool flat)
{
    RandomInputs random(seed);
    const auto place = [&] { return random.whole(-100, 100) / 1024.0; };
    std::vector<Vec3> positions;
    std::vector<double> masses;
    for (int i = 0; i < 8; ++i) {
        const double x = place(), y = place(), z = place();
        positions.emplace_back(x, flat ? 0.5 * x - 0.25 * z : y, z);
        masses.push_back(random.number(0.01, 1));
    }
    return patch_of(positions, masses);
}

/// A point in the plane of a patch: somewhere between its first three nodes.
Vec3 a_point_of(const Patch& patch)
{
    return 0.5 * patch.positions[0] + 0.25 * patch.positions[1] + 0.25 * patch.positions[2];
}

double sum_of(const std::vector<double>& weights)
{
    double sum = 0;
    for (const double weight : weights)
        sum += weight;
    return sum;
}

Vec3 mean_position(const Patch& patch, const std::vector<double>& weights)
{
    Vec3 mean = Vec3::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i)
        mean += weights[i] * patch.positions[i];
    return mean;
}

Patch shifted(Patch patch, const Vec3& way)
{
    for (Vec3& x : patch.positions)
        x += way;
    return patch;
}

}  // namespace

TEST_CASE("weights: a heavy node between two light ones, by hand")
{
    const std::vector<double> weights = spread_weights(
        patch_of({Vec3(-1, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}, {1, 2, 1}), Vec3(0, 0, 0));
    given("nodes at x = -1, 0 and 1 m of 1, 2 and 1 kg, p in the middle");
    REQUIRE(weights.size() == 3);
    expect("weight of the left node", weights[0], 0.25, 1e-12);
    expect("weight of the middle node", weights[1], 0.5, 1e-12);
    expect("weight of the right node", weights[2], 0.25, 1e-12);
}

TEST_CASE("weights: a point away from the middle weighs the nearer node more, by hand")
{
    const std::vector<double> weights = spread_weights(patch_of({Vec3(0, 0, 0), Vec3(1, 0, 0)}, {5, 1}),
                                                       Vec3(0.25, 0, 0));
    given(
        "nodes at x = 0 and 1 m of 5 and 1 kg, p at x = 0.25 m: only one pair of weights has its mean there");
    REQUIRE(weights.size() == 2);
    expect("weight of the first node", weights[0], 0.75, 1e-12);
    expect("weight of the second node", weights[1], 0.25, 1e-12);
}

TEST_CASE("weights: their sum is one, so momentum is kept")
{
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (const bool flat : {true, false}) {
            const Patch patch = random_patch(seed, flat);
            given("eight nodes at random", flat ? ", in one plane" : "");
            expect("sum of the weights", sum_of(spread_weights(patch, a_point_of(patch))), 1.0, 1e-9);
        }
}

TEST_CASE("weights: their mean position is p, so angular momentum is kept")
{
    for (unsigned seed = 1; seed <= 20; ++seed)
        for (const bool flat : {true, false}) {
            const Patch patch = random_patch(seed, flat);
            const Vec3 p = a_point_of(patch);
            given("eight nodes at random", flat ? ", in one plane" : "", ", p = ", readable(p), " m");
            expect("mean position", mean_position(patch, spread_weights(patch, p)), p, 1e-9, "m");
        }
}

TEST_CASE("weights: they do not depend on where the origin is")
{
    const Patch patch = random_patch(3, true);
    const Vec3 p = a_point_of(patch), way(32, -16, 8);
    const std::vector<double> here = spread_weights(patch, p),
                              there = spread_weights(shifted(patch, way), p + way);
    given("eight nodes in one plane, and the same moved by (32, -16, 8) m");
    REQUIRE(here.size() == there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
        expect("weight " + std::to_string(i), there[i], here[i], 1e-9);
}

TEST_CASE("weights: a light node moves no faster than its place among the others says")
{
    // Five nodes in a row: a field that is affine in x has differences that are all the same.
    const Patch row = patch_of({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(4, 0, 0)},
                               {1, 0.001, 0.5, 2, 0.7});
    const std::vector<double> weights = spread_weights(row, Vec3(1.2, 0, 0));
    given("nodes at x = 0, 1, 2, 3, 4 m of 1, 0.001, 0.5, 2 and 0.7 kg, p at x = 1.2 m, an impulse of 1 N s");
    REQUIRE(weights.size() == 5);
    const auto speed = [&](std::size_t i) { return weights[i] / row.masses[i]; };
    for (std::size_t i = 1; i < 4; ++i)
        expect("speed of node " + std::to_string(i) + ", as the mean of its neighbours'", speed(i),
               0.5 * (speed(i - 1) + speed(i + 1)), 1e-9, "m/s");
}

TEST_CASE("push: the patch gains the impulse, and its moment about the origin")
{
    Patch patch = random_patch(5, false);
    const Vec3 p = a_point_of(patch), impulse(0.1, 0.4, -0.2);
    const std::vector<double> weights = spread_weights(patch, p);
    push_patch(patch, weights, impulse);
    Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        momentum += patch.masses[i] * patch.velocities[i];
        angular += patch.positions[i].cross(patch.masses[i] * patch.velocities[i]);
    }
    given("eight nodes at rest, an impulse of (0.1, 0.4, -0.2) N s at p = ", readable(p), " m");
    expect("momentum", momentum, impulse, 1e-9, "N s");
    expect("angular momentum", angular, p.cross(impulse), 1e-9, "N m s");
}

TEST_CASE("push: a velocity that is there stays")
{
    Patch patch = six_around(0.1, 0.3);
    patch.velocities.assign(7, Vec3(0, -1, 0));
    push_patch(patch, {1, 0, 0, 0, 0, 0, 0}, Vec3(0, 0.05, 0));
    given("seven nodes that fall with 1 m/s; the first, of 0.1 kg, gets all of an impulse of 0.05 N s");
    expect("velocity of the first", patch.velocities[0], Vec3(0, -0.5, 0), 1e-12, "m/s");
    expect("velocity of the second", patch.velocities[1], Vec3(0, -1, 0), 0, "m/s");
}

TEST_CASE("effective mass: a node alone weighs what it weighs")
{
    given("two nodes of 0.3 kg and 0.1 kg, all weight on the first");
    expect("effective mass", effective_mass(patch_of({Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {0.3, 0.1}), {1, 0}),
           0.3, 1e-12, "kg");
}

TEST_CASE("effective mass: two equal nodes that share a push weigh as much as both")
{
    given("two nodes of 0.3 kg, half on each");
    expect("effective mass",
           effective_mass(patch_of({Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {0.3, 0.3}), {0.5, 0.5}), 0.6, 1e-12,
           "kg");
}

TEST_CASE("effective mass: nodes that differ, by hand")
{
    // A push of 1 N s gives them 1/2 and 1/6 m/s, so the point between them gets 1/3 m/s.
    given("nodes of 1 kg and 3 kg, half of the weight on each");
    expect("effective mass", effective_mass(patch_of({Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {1, 3}), {0.5, 0.5}),
           3.0, 1e-12, "kg");
    given("nodes of 1 kg and 3 kg, weights 1.5 and -0.5: 1 / (2.25 / 1 + 0.25 / 3)");
    expect("effective mass", effective_mass(patch_of({Vec3(-1, 0, 0), Vec3(1, 0, 0)}, {1, 3}), {1.5, -0.5}),
           3 / 7.0, 1e-12, "kg");
}

TEST_CASE("effective mass: no other weights of the same sum and mean position make it larger")
{
    // On a rectangle, plus and minus around the corners changes neither sum nor mean.
    const Patch corners = patch_of({Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(2, 0, 0)},
                                   {1, 0.2, 0.7, 0.4});
    const std::vector<double> best = spread_weights(corners, Vec3(0.8, 0, 0.4));
    const double mass = effective_mass(corners, best);
    REQUIRE(best.size() == 4);
    for (const double change : {-0.05, 0.05}) {
        given("corners of a rectangle of 1, 0.2, 0.7 and 0.4 kg, p = (0.8, 0, 0.4) m, weights changed by ",
              change, " in turn");
        const double other = effective_mass(
            corners, {best[0] + change, best[1] - change, best[2] + change, best[3] - change});
        expect_that("the changed weights have less effective mass (" + readable(other) + " kg) than yours (" +
                        readable(mass) + " kg)",
                    other < mass);
    }
}

TEST_CASE("longest step: a light vertex with six neighbours bears the step of all seven")
{
    const Patch patch = six_around(0.00007, 0.3);
    const std::vector<double> alone{1, 0, 0, 0, 0, 0, 0}, shared = spread_weights(patch, Vec3::Zero());
    given("a vertex of 0.07 g, six neighbours of 0.3 kg around it, k = 800 N/m");
    expect("alone", longest_step(patch, alone, 800), std::sqrt(2 * 0.00007 / 800), 1e-9, "s");
    expect("shared", longest_step(patch, shared, 800), std::sqrt(2 * 1.80007 / 800), 1e-9, "s");
    say("a vertex of 0.07 g alone:     steps up to ", 1000 * longest_step(patch, alone, 800), " ms");
    say("shared with six of 0.3 kg: ", effective_mass(patch, shared), " kg, steps up to ",
        1000 * longest_step(patch, shared, 800), " ms");
}
