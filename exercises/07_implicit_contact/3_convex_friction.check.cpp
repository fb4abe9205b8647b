#include "exercises/07_implicit_contact/3_convex_friction.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <Eigen/Dense>

#include <numbers>

using namespace enduring;

namespace {

/// An impulse to be brought into a cone, of any size.
struct Sample {
    Vec3 wanted, normal;
    double mu, size;
};

std::vector<Sample> samples()
{
    RandomInputs random(11);
    std::vector<Sample> all;
    for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6})
        for (int i = 0; i < 200; ++i)
            all.push_back(
                {size * random.normal_vector(), random.direction(), std::abs(random.normal()), size});
    return all;
}

std::string told(const Sample& sample)
{
    return in_words("wanted ", readable(sample.wanted), " N s, normal ", readable(sample.normal), ", mu ",
                    sample.mu);
}

/// How far an impulse lies in its cone (above 0), or out of it.
double room(const Vec3& impulse, const Sample& sample)
{
    const double push = sample.normal.dot(impulse);
    return sample.mu * push - (impulse - push * sample.normal).norm();
}

/// One comparison of many: it is told only if it is wrong, and then it should be the last.
template <class Value>
bool agrees(const std::string& input, const std::string& what, const Value& got, const Value& expected,
            double tolerance, const std::string& unit = "")
{
    if ((got - expected).norm() <= tolerance)
        return true;
    given(input);
    expect(what, got, expected, tolerance, unit);
    return false;
}

/// The same for a property.
bool holds(const std::string& input, const std::string& what, bool right)
{
    if (right)
        return true;
    given(input);
    expect_that(what, false);
    return false;
}

/// Directions on the cone's mantle, all around.
std::vector<Vec3> mantle_of(const Sample& sample)
{
    const Vec3 one = sample.normal.unitOrthogonal(), other = sample.normal.cross(one);
    std::vector<Vec3> rays;
    for (int i = 0; i < 90; ++i) {
        const double angle = 2 * std::numbers::pi * i / 90;
        const Vec3 along = std::cos(angle) * one + std::sin(angle) * other;
        rays.push_back((sample.normal + sample.mu * along).normalized());
    }
    return rays;
}

Mat3 difference_quotient(const Sample& sample)
{
    const double by = 1e-6 * sample.size;
    Mat3 measured;
    for (int axis = 0; axis < 3; ++axis)
        measured.col(axis) =
            (nearest_in_cone(sample.wanted + by * Vec3::Unit(axis), sample.normal, sample.mu) -
             nearest_in_cone(sample.wanted - by * Vec3::Unit(axis), sample.normal, sample.mu)) /
            (2 * by);
    return measured;
}

/// Whether an impulse is so near to a border between two regions that a difference quotient sees both.
bool near_a_border(const Sample& sample)
{
    const double push = sample.normal.dot(sample.wanted);
    const double along = (sample.wanted - push * sample.normal).norm();
    return std::min(std::abs(along - sample.mu * push), std::abs(sample.mu * along + push)) <
               1e-3 * sample.size ||
           along < 1e-2 * sample.size;
}

/// Pairs of bodies from a millimetre to a kilometre, all of which matter in a step.
struct Situation {
    PairLaw pair;
    Vec3 velocity;
    double speed;
};

constexpr double dt = 0.01;

std::vector<Situation> situations()
{
    RandomInputs random(5);
    std::vector<Situation> all;
    for (const double length : {1e-3, 1.0, 1e3})
        for (int i = 0; i < 150; ++i) {
            PairLaw pair;
            pair.normal = random.direction();
            pair.depth_t0 = 0.01 * length * random.normal();
            const Vec3 stretch = 0.01 * length * random.normal_vector();
            pair.stretch = stretch - pair.normal.dot(stretch) * pair.normal;
            pair.stiffness = 1e3 * length * std::exp(random.normal());
            pair.mu = std::abs(random.normal());
            all.push_back({pair, length * random.normal_vector(), length});
        }
    return all;
}

std::string told(const Situation& situation)
{
    return in_words("normal ", readable(situation.pair.normal), ", depth ", situation.pair.depth_t0,
                    " m, stretch ", readable(situation.pair.stretch), " m, k ", situation.pair.stiffness,
                    " N/m, mu ", situation.pair.mu, ", velocity ", readable(situation.velocity),
                    " m/s, dt 0.01 s");
}

/// The velocity of a particle of 1 kg at the end of a step: m (v - free) = impulse(v), by Newton's method
/// with a line search on the objective.
Vec3 velocity_after_step(const PairLaw& pair, const Vec3& free)
{
    const auto objective = [&](const Vec3& v) {
        return 0.5 * (v - free).squaredNorm() + convex_answer(pair, v, dt).potential;
    };
    Vec3 velocity = free;
    for (int i = 0; i < 50; ++i) {
        const ConvexAnswer made = convex_answer(pair, velocity, dt);
        const Vec3 gradient = velocity - free - made.impulse;
        const Vec3 direction = -(Mat3::Identity() + made.hessian).inverse() * gradient;
        double part = 1;
        while (part > 1e-6 && objective(velocity + part * direction) > objective(velocity))
            part /= 2;
        velocity += part * direction;
    }
    return velocity;
}

}  // namespace

TEST_CASE("cone: an impulse of the cone stays as it is, also on the mantle")
{
    const Vec3 up = Vec3::UnitY();
    for (const Vec3& inside : {Vec3(0, 2, 0), Vec3(0.3, 1, -0.2), Vec3(0.5, 1, 0), Vec3(0, 0, 0)}) {
        given("wanted ", readable(inside), " N s, normal (0, 1, 0), mu 0.5");
        expect("impulse", nearest_in_cone(inside, up, 0.5), inside, 1e-15, "N s");
    }
}

TEST_CASE("cone: an impulse that pulls so much that no push is nearer leaves nothing")
{
    const Vec3 up = Vec3::UnitY(), none = Vec3::Zero();
    for (const Vec3& away : {Vec3(0, -2, 0), Vec3(1, -1, 0), Vec3(1, -0.5, 0), Vec3(0, -1e-9, 0)}) {
        given("wanted ", readable(away), " N s, normal (0, 1, 0), mu 0.5");
        expect("impulse", nearest_in_cone(away, up, 0.5), none, 1e-15, "N s");
    }
}

TEST_CASE("cone: an impulse that slips comes to the foot of its perpendicular on the mantle")
{
    given("wanted (3, 1, 0) N s, normal (0, 1, 0), mu 0.5");
    expect("impulse", nearest_in_cone(Vec3(3, 1, 0), Vec3::UnitY(), 0.5), Vec3(1, 2, 0), 1e-12, "N s");
    given("wanted (0, -1, 4) N s, normal (0, 1, 0), mu 1");
    expect("impulse", nearest_in_cone(Vec3(0, -1, 4), Vec3::UnitY(), 1), Vec3(0, 1.5, 1.5), 1e-12, "N s");
}

TEST_CASE("cone: it lies in the cone, and no other impulse of the cone is nearer, at any size")
{
    for (const Sample& sample : samples()) {
        const Vec3 found = nearest_in_cone(sample.wanted, sample.normal, sample.mu),
                   left = sample.wanted - found;
        const double rounding = 1e-12 * sample.size;
        bool nearest = std::abs(left.dot(found)) <= rounding * sample.size;
        for (const Vec3& ray : mantle_of(sample))
            nearest = nearest && left.dot(ray) <= rounding;
        if (!holds(told(sample), "the impulse " + readable(found) + " N s lies in the cone",
                   room(found, sample) >= -rounding * (1 + sample.mu)) ||
            !holds(told(sample),
                   "what is cut off, " + readable(left) +
                       " N s, stands at right angles on the impulse and points away from the cone",
                   nearest))
            return;
    }
}

TEST_CASE("cone: without friction it is the push along the normal")
{
    std::vector<Sample> all = samples();
    for (const double push : {-1, 0, 1})
        all.push_back({Vec3(0, push, 0), Vec3::UnitY(), 0, 1});
    for (Sample& sample : all) {
        sample.mu = 0;
        const Vec3 expected = std::max(0.0, sample.normal.dot(sample.wanted)) * sample.normal;
        if (!agrees(told(sample), "impulse", nearest_in_cone(sample.wanted, sample.normal, 0), expected,
                    1e-12 * sample.size, "N s"))
            return;
    }
}

TEST_CASE(
    "derivative: it is that of the difference quotients, in the cone, on its mantle and where nothing is left")
{
    std::array<int, 3> seen{};
    for (const Sample& sample : samples()) {
        if (near_a_border(sample))
            continue;
        const Vec3 found = nearest_in_cone(sample.wanted, sample.normal, sample.mu);
        ++seen[found.isZero(0) ? 0 : (found - sample.wanted).isZero(0) ? 1 : 2];
        if (!agrees(told(sample), "derivative", cone_derivative(sample.wanted, sample.normal, sample.mu),
                    difference_quotient(sample), 1e-5))
            return;
    }
    expect_that("all three regions of your cone are met among 1000 impulses",
                std::all_of(seen.begin(), seen.end(), [](int count) { return count > 100; }));
}

TEST_CASE("derivative: it is symmetric, and its eigenvalues lie between 0 and 1")
{
    for (const Sample& sample : samples()) {
        const Mat3 derivative = cone_derivative(sample.wanted, sample.normal, sample.mu);
        const Vec3 eigenvalues = Eigen::SelfAdjointEigenSolver<Mat3>(derivative).eigenvalues();
        if (!agrees(told(sample), "derivative", derivative, Mat3(derivative.transpose()), 1e-12) ||
            !holds(told(sample), "its eigenvalues " + readable(eigenvalues) + " lie between 0 and 1",
                   eigenvalues.minCoeff() >= -1e-12 && eigenvalues.maxCoeff() <= 1 + 1e-12))
            return;
    }
}

TEST_CASE("derivative: on a border it is that of one of the sides, and never undefined")
{
    const Vec3 up = Vec3::UnitY();
    const Mat3 all = Mat3::Identity(), none = Mat3::Zero(), straight = up * up.transpose();
    const auto one_of = [&](const Vec3& wanted, double mu, const std::vector<Mat3>& sides) {
        const Mat3 got = cone_derivative(wanted, up, mu);
        given("wanted ", readable(wanted), " N s, normal (0, 1, 0), mu ", mu);
        expect_that("your derivative " + readable(got) + " is that of one of the sides",
                    std::any_of(sides.begin(), sides.end(),
                                [&](const Mat3& side) { return (got - side).norm() <= 1e-9; }));
    };
    const Vec3 ray = Vec3(0.5, 1, 0);
    const Mat3 mantle = ray * ray.transpose() / 1.25;  // and what turns around the axis
    const Mat3 turning = Vec3::UnitZ() * Vec3::UnitZ().transpose();
    one_of(ray, 0.5, {all, mantle + turning});
    one_of(Vec3(1, -0.5, 0), 0.5, {none, mantle});
    one_of(Vec3(0, 0, 0), 0.5, {none, all});
    one_of(Vec3(0, 0, 0), 0, {none, all, straight});
    one_of(Vec3(0, 1, 0), 0, {all, straight});
    one_of(Vec3(0, -1, 0), 0, {none});
    one_of(Vec3(0, 2, 0), 0.5, {all});
}

TEST_CASE("answer: while it holds it is the chapter's pair at the end of the step")
{
    int holding = 0;
    for (Situation& situation : situations()) {
        situation.pair.mu = 10;
        const StepLaw step{1, dt};
        situation.pair.lagged_normal_impulse = normal_impulse(situation.pair, situation.velocity, step);
        const PairPush chapters = pushed(situation.pair, situation.velocity, step);
        if (chapters.slips || chapters.normal_impulse.isZero(0))
            continue;
        ++holding;
        const ConvexAnswer made = convex_answer(situation.pair, situation.velocity, dt);
        const double mass = situation.pair.stiffness * dt * dt;
        if (!agrees(told(situation), "impulse", made.impulse,
                    Vec3(chapters.normal_impulse + chapters.friction), 1e-9 * mass * situation.speed,
                    "N s") ||
            !agrees(told(situation), "stiffening", made.hessian, hessian_of(situation.pair, chapters, step),
                    1e-9 * mass, "kg"))
            return;
    }
    expect_that("more than 100 of 450 pairs hold", holding > 100);
}

TEST_CASE(
    "answer: minus the slope of the potential is the impulse, and minus that of the impulse the stiffening")
{
    for (const auto& [pair, velocity, speed] : situations()) {
        const double by = 1e-5 * speed, mass = pair.stiffness * dt * dt;
        const ConvexAnswer made = convex_answer(pair, velocity, dt);
        const Vec3 wanted = -pair.stiffness * dt *
                            (pair.depth_t0 * pair.normal + pair.stretch + dt * velocity);
        Vec3 slope;
        Mat3 change;
        for (int axis = 0; axis < 3; ++axis) {
            const ConvexAnswer before = convex_answer(pair, velocity - by * Vec3::Unit(axis), dt),
                               after = convex_answer(pair, velocity + by * Vec3::Unit(axis), dt);
            slope(axis) = (before.potential - after.potential) / (2 * by);
            change.col(axis) = (before.impulse - after.impulse) / (2 * by);
        }
        if (near_a_border({wanted, pair.normal, pair.mu, wanted.norm()}))
            change = made.hessian;
        const std::string input = told({pair, velocity, speed});
        if (!agrees(input, "slope of the potential", slope, made.impulse, 1e-4 * mass * speed, "N s") ||
            !agrees(input, "stiffening", made.hessian, change, 1e-4 * mass, "kg"))
            return;
    }
}

TEST_CASE("answer: the potential lies above each of its tangents, so it is convex, whatever the pair")
{
    RandomInputs random(3);
    for (const auto& [pair, velocity, speed] : situations()) {
        const ConvexAnswer here = convex_answer(pair, velocity, dt);
        for (int i = 0; i < 10; ++i) {
            const Vec3 change = speed * random.normal_vector();
            const ConvexAnswer there = convex_answer(pair, velocity + change, dt);
            const double rounding = 1e-10 * pair.stiffness * dt * dt * speed * speed,
                         tangent = here.potential - here.impulse.dot(change);
            if (!holds(told({pair, velocity, speed}) + ", and another velocity " +
                           readable(Vec3(velocity + change)),
                       "the potential there, " + readable(there.potential) +
                           " J, is neither negative nor below the tangent from here, " + readable(tangent) +
                           " J",
                       there.potential >= tangent - rounding && there.potential >= 0))
                return;
        }
    }
}

TEST_CASE("sliding: at its depth a pair carries its load, and friction is mu times as large")
{
    for (const double load : {1e-3, 30.0, 1e6})
        for (const double mu : {0.1, 0.5, 1.2})
            for (const double speed : {1e-3, 2.0, 300.0}) {
                const double k = 1e4 * load;
                PairLaw pair;
                pair.stiffness = k;
                pair.mu = mu;
                // It slides along x; friction has held mu load dt.
                pair.stretch = Vec3(mu * load / k, 0, 0);
                pair.depth_t0 = depth_of_sliding(load, k, mu, speed, dt);
                const Vec3 impulse = convex_answer(pair, Vec3(speed, 0, 0), dt).impulse;
                given("load ", load, " N, k ", k, " N/m, mu ", mu, ", ", speed, " m/s along x, dt 0.01 s");
                expect("impulse at your depth of " + readable(pair.depth_t0) + " m", impulse,
                       Vec3(-mu * load * dt, load * dt, 0), 1e-9 * load * dt * (1 + speed), "N s");
            }
}

TEST_CASE(
    "sliding: a particle that is pushed along hops, slides above the ground, and comes down as friction stops it")
{
    const double k = 1e6, mu = 0.5, gravity = 9.81;
    PairLaw pair;
    pair.stiffness = k;
    pair.mu = mu;
    pair.depth_t0 = -gravity / k;
    Vec3 velocity(2, 0, 0);
    double highest = 0, sliding = 0;
    given("1 kg at rest on the ground is pushed along x with 2 m/s, k 1e6 N/m, mu 0.5, dt 0.01 s");
    for (int i = 0; i < 100; ++i) {
        const Vec3 before = velocity;
        velocity = velocity_after_step(pair, velocity - Vec3(0, gravity * dt, 0));
        const Vec3 friction((velocity - before).x(), 0, 0);
        pair.depth_t0 += dt * velocity.y();
        pair.stretch = friction / (-k * dt);
        highest = std::max(highest, pair.depth_t0);
        if (i == 19) {
            sliding = pair.depth_t0;
            expect("speed after 0.2 s", velocity.x(), 2 - mu * gravity * 0.2, 0.02, "m/s");
            expect("depth after 0.2 s", pair.depth_t0, depth_of_sliding(gravity, k, mu, velocity.x(), dt),
                   3e-4, "m");
        }
    }
    expect("speed after 1 s", velocity.norm(), 0, 1e-6, "m/s");
    expect("depth after 1 s", pair.depth_t0, -gravity / k, 1e-8, "m");
    say("pushed with 2 m/s it hops ", 1000 * highest, " mm high, slides ", 1000 * sliding,
        " mm above the ground after 0.2 s, and rests ", -1e6 * pair.depth_t0, " um below it");
}
