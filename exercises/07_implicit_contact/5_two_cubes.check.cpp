#include "exercises/07_implicit_contact/5_two_cubes.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <algorithm>

using namespace enduring;

namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double gravity = 10;  ///< as in the chapter's example [m/s^2]

RandomInputs generator(75);

double random_number() { return generator.number(-1, 1); }

/// The chapter's two cubes of 1 kg: one on the floor, and one 0.9 mm above it.
PileStep two_cubes(double along = 0)
{
    PileStep step;
    step.masses = {1, 1};
    step.pairs = {{0, 1e6, 0, 0.5}, {1e-3 - 0.1e-3, 5e5, 0, 0}};
    step.free = Eigen::Vector4d(along, -0.1, 0, -0.1);
    step.dt = 0.01;
    return step;
}

/// Cubes of any masses, gaps and motions.
PileStep random_pile(int count)
{
    PileStep step;
    step.dt = 0.01;
    step.free = VectorXd::NullaryExpr(2 * count, [](Eigen::Index) { return random_number(); });
    for (int i = 0; i < count; ++i) {
        const double mass = std::pow(10, 2 * random_number());
        step.masses.push_back(mass);
        step.pairs.push_back(
            {1e-3 * random_number(), 1e6 * mass, 1e-4 * random_number(), std::abs(random_number())});
    }
    return step;
}

std::vector<double> random_limits(const PileStep& step)
{
    std::vector<double> limits;
    for (const double mass : step.masses)
        limits.push_back(mass * std::abs(random_number()));
    return limits;
}

std::string told(const CubePair& pair, const Vector2d& velocity, double limit)
{
    return in_words("gap ", pair.gap, " m, k ", pair.stiffness, " N/m, stretch ", pair.stretch,
                    " m, velocity ", readable(velocity), " m/s, limit ", limit, " N s, dt 0.01 s");
}

}  // namespace

TEST_CASE("pair: by hand, pressed and apart, holding and slipping")
{
    const CubePair pair{0, 1e6, 0, 0.5};
    given("gap 0, k 1e6 N/m, stretch 0, velocity (0, -0.1) m/s, limit 2 N s, dt 0.01 s");
    expect("impulse", impulse_of(pair, {0, -0.1}, 2, 0.01), Vector2d(0, 10), 1e-12, "N s");
    expect("potential", potential_of(pair, {0, -0.1}, 2, 0.01), 0.5, 1e-12, "J");
    given("the same, velocity (0.01, 0.2) m/s: apart, and it holds");
    expect("impulse", impulse_of(pair, {0.01, 0.2}, 2, 0.01), Vector2d(-1, 0), 1e-12, "N s");
    expect("potential", potential_of(pair, {0.01, 0.2}, 2, 0.01), 0.005, 1e-12, "J");
    given("the same, velocity (-0.05, 0.2) m/s: it slips");
    expect("impulse", impulse_of(pair, {-0.05, 0.2}, 2, 0.01), Vector2d(2, 0), 1e-12, "N s");
    expect("potential", potential_of(pair, {-0.05, 0.2}, 2, 0.01), 0.08, 1e-12, "J");
}

TEST_CASE("pair: minus the slope of the potential is the impulse, and minus that of the impulse the Hessian")
{
    for (int trial = 0; trial < 400; ++trial) {
        const CubePair pair{1e-3 * random_number(), 1e5 * std::pow(10, random_number()),
                            1e-4 * random_number(), 0};
        const double along = 0.1 * random_number(), up = 0.1 * random_number();
        const Vector2d velocity(along, up);
        const double limit = 0.5 * std::abs(random_number()), by = 1e-7, dt = 0.01,
                     mass = pair.stiffness * dt * dt;
        const double room = pair.stiffness * dt * std::abs(pair.stretch + dt * velocity.x()) - limit;
        if (std::abs(room) < 10 * mass * by || std::abs(pair.gap + dt * velocity.y()) < 10 * dt * by)
            continue;  // at a border
        Vector2d slope;
        Eigen::Matrix2d change;
        for (int axis = 0; axis < 2; ++axis) {
            const Vector2d before = velocity - by * Vector2d::Unit(axis),
                           after = velocity + by * Vector2d::Unit(axis);
            slope(axis) = (potential_of(pair, before, limit, dt) - potential_of(pair, after, limit, dt)) /
                          (2 * by);
            change.col(axis) = (impulse_of(pair, before, limit, dt) - impulse_of(pair, after, limit, dt)) /
                               (2 * by);
        }
        given(told(pair, velocity, limit));
        expect("slope of the potential", slope, impulse_of(pair, velocity, limit, dt), 1e-5 * mass, "N s");
        expect("Hessian", hessian_of(pair, velocity, limit, dt), change, 1e-6 * mass, "kg");
    }
}

TEST_CASE("gradient: it is the slope of the objective")
{
    for (const int count : {1, 2, 5, 5, 5, 5, 5, 5}) {
        const PileStep step = random_pile(count);
        const std::vector<double> limits = random_limits(step);
        const VectorXd v = VectorXd::NullaryExpr(2 * count,
                                                 [](Eigen::Index) { return 0.1 * random_number(); });
        VectorXd slope(2 * count);
        for (Eigen::Index i = 0; i < v.size(); ++i) {
            const VectorXd by = 1e-7 * VectorXd::Unit(v.size(), i);
            slope(i) = (objective(step, limits, v + by) - objective(step, limits, v - by)) / 2e-7;
        }
        given("a random pile of ", count, " cubes");
        expect("gradient", gradient(step, limits, v), slope, 1e-4 * (1 + slope.norm()), "N s");
    }
}

TEST_CASE("gradient: what a pair gives to one cube it takes from the other")
{
    PileStep step = two_cubes();
    step.pairs = {{1, 1e6, 0, 0}, {-1e-3, 5e5, 1e-4, 0}};
    given("the lower cube is 1 m above the floor, the upper one 1 mm in it; v = v*, limit 0.1 N s");
    const VectorXd slope = gradient(step, {0, 0.1}, step.free);
    expect("gradient", slope, VectorXd(Eigen::Vector4d(-0.1, 5, 0.1, -5)), 1e-12, "N s");
}

TEST_CASE("solved: the chapter's two cubes, with its numbers")
{
    const PileStep step = two_cubes();
    given("two cubes of 1 kg, k 1e6 and 5e5 N/m, gaps 0 and 0.9 mm, both fall with 0.1 m/s, dt 0.01 s");
    expect("gradient at v*", gradient(step, {0, 0}, step.free), VectorXd(Eigen::Vector4d(0, -10, 0, 0)),
           1e-12, "N s");
    const VectorXd v = solved(step, {0, 0}, step.free);
    expect("velocities", v, VectorXd(Eigen::Vector4d(0, -0.00108, 0, -0.09125)), 1e-5, "m/s");
    const Vector2d floor = impulse_of(step.pairs[0], velocity_of_pair(v, 0), 0, step.dt),
                   between = impulse_of(step.pairs[1], velocity_of_pair(v, 1), 0, step.dt);
    expect("impulse of the floor", floor.y(), 0.10767, 1e-5, "N s");
    expect("impulse between the cubes", between.y(), 0.00875, 1e-5, "N s");
    say("two cubes: the floor pushes with ", floor.y(), " N s, the lower cube the upper one with ",
        between.y(), " N s");
}

TEST_CASE("solved: the gradient is zero, wherever it begins and whatever the masses, and nothing is less")
{
    for (int trial = 0; trial < 30; ++trial) {
        const int count = 1 + trial % 8;
        const PileStep step = random_pile(count);
        const std::vector<double> limits = random_limits(step);
        const VectorXd begin = VectorXd::NullaryExpr(2 * count,
                                                     [](Eigen::Index) { return 3 * random_number(); });
        const VectorXd v = solved(step, limits, begin);
        double scale = 0;
        for (const double mass : step.masses)
            scale += 100 * mass;
        given("random pile number ", trial, " of ", count, " cubes");
        expect("gradient", gradient(step, limits, v), VectorXd(VectorXd::Zero(2 * count)), 1e-10 * scale,
               "N s");
        for (int other = 0; other < 5; ++other) {
            const VectorXd there = v + 0.01 * VectorXd::NullaryExpr(
                                                  2 * count, [](Eigen::Index) { return random_number(); });
            expect_that("the objective is larger elsewhere",
                        objective(step, limits, there) > objective(step, limits, v));
        }
    }
}

TEST_CASE("step: friction holds the chapter's lower cube, which slid at 0.05 m/s")
{
    const PileStep step = two_cubes(0.05);
    given("two cubes of 1 kg, mu 0.5 on the floor and 0 between them, the lower one slides with 0.05 m/s");
    const PileMotion motion = after_step(step);
    expect("velocity of the lower cube along the floor", motion.velocities(0), 0.05 / 101, 1e-9, "m/s");
    expect("limit of friction on the floor", motion.limits[0], 0.5 * 0.10767, 1e-5, "N s");
    expect("limit between the cubes", motion.limits[1], 0, 1e-15, "N s");
}

TEST_CASE("step: every pair holds below its limit or slips at it, and limits are mu times normal impulses")
{
    for (int trial = 0; trial < 30; ++trial) {
        const int count = 1 + trial % 8;
        const PileStep step = random_pile(count);
        const PileMotion motion = after_step(step);
        VectorXd momentum = VectorXd::Zero(2 * count);
        for (std::size_t i = 0; i < step.masses.size(); ++i) {
            const Vector2d u = velocity_of_pair(motion.velocities, i);
            const Vector2d impulse = impulse_of(step.pairs[i], u, motion.limits[i], step.dt);
            const double wanted = -step.pairs[i].stiffness * step.dt *
                                  (step.pairs[i].stretch + step.dt * u.x()),
                         limit = step.pairs[i].mu * impulse.y();
            given("random pile number ", trial, " of ", count, " cubes, pair ", i);
            expect("limit", motion.limits[i], limit, 1e-8 * (1 + limit), "N s");
            expect("friction", impulse.x(), std::max(-limit, std::min(limit, wanted)), 1e-8 * (1 + limit),
                   "N s");
            expect_that("it pushes", impulse.y() >= 0);
        }
        expect("gradient with these limits", gradient(step, motion.limits, motion.velocities), momentum,
               1e-6 * step.masses[0] + 1e-6, "N s");
    }
}

TEST_CASE("steps: a pile of ten comes to rest, each pair pressed by its load over k")
{
    PileStep step;
    step.dt = 0.01;
    step.masses.assign(10, 1);
    for (int i = 0; i < 10; ++i)
        step.pairs.push_back({1e-4 * i, 1e6, 0, 0.5});
    VectorXd v = VectorXd::Zero(20);
    v(18) = 1;  // the uppermost one slides
    double after_ten = 0;
    for (int count = 0; count < 100; ++count) {
        step.free = v;
        for (Eigen::Index i = 1; i < 20; i += 2)
            step.free(i) -= gravity * step.dt;
        const PileMotion motion = after_step(step);
        v = motion.velocities;
        for (std::size_t i = 0; i < 10; ++i) {
            const Vector2d u = velocity_of_pair(v, i);
            step.pairs[i].stretch = impulse_of(step.pairs[i], u, motion.limits[i], step.dt).x() /
                                    (-step.pairs[i].stiffness * step.dt);
            step.pairs[i].gap += step.dt * u.y();
        }
        if (count == 9)
            after_ten = v(18);
    }
    given(
        "ten cubes of 1 kg, k 1e6 N/m, mu 0.5; gaps 0 to 0.9 mm, and the uppermost one slides with 1 m/s; 1 s");
    expect_that("the uppermost one is slower after ten steps", after_ten < 0.999);
    expect("fastest velocity", v.lpNorm<Eigen::Infinity>(), 0, 1e-6, "m/s");
    for (std::size_t i = 0; i < 10; ++i)
        expect("depth of joint " + readable(i), -1e6 * step.pairs[i].gap,
               (10.0 - static_cast<double>(i)) * gravity, 1e-3, "um");
    say("ten cubes: the lowest joint is ", -1e6 * step.pairs[0].gap, " um deep");
}
