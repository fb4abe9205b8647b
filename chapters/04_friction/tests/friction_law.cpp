#include "chapters/04_friction/mass_splitting_friction.hpp"

#include <doctest/doctest.h>

#include <random>

using namespace enduring;

namespace {

class Random {
public:
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    double magnitude(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    Vec2 vector(double length) { return length * Vec2(between(-1, 1), between(-1, 1)); }

private:
    std::mt19937 engine_{4};
};

template <class Friction>
Friction random_friction(Random& random)
{
    Friction friction;
    friction.spring = random.magnitude(10, 1e6);
    friction.mu_s = random.between(0, 1);
    friction.mu_d = random.between(0, friction.mu_s);
    friction.weighting = random.magnitude(1, 1e5);
    return friction;
}

}  // namespace

TEST_CASE("friction law: the weight of slip is 0 at rest, 1 in motion, and k_w x where x is small")
{
    for (const double k_w : {1.0, 20.0, 1e4}) {
        CHECK(slip_weight(k_w, 0) == 0);
        CHECK(slip_weight(k_w, 50 / k_w) == doctest::Approx(1));
        CHECK(slip_weight(k_w, 1e-9 / k_w) == doctest::Approx(1e-9).epsilon(1e-8));
        CHECK(slip_weight(k_w, std::log(2) / k_w) == doctest::Approx(0.5));
    }
}

TEST_CASE("friction law: 5.22 holds up to mu_s, and 5.23 takes over beyond")
{
    const YamaneNakamura friction{.mu_s = 0.5, .mu_d = 0.2};
    const double dt = 0.1;
    // k_FP = 100, k_FD = 25: the spring pulls with 3 N back along x, the damper with 5 N along y.
    const SlidingPair pair{{0.03, 0}, {0, 0.2}, 1.2};
    const FrictionImpulse held = yamane_nakamura(pair, friction, dt);
    CHECK((held.impulse - Vec2(-0.3, -0.5)).norm() < 1e-15);
    CHECK(held.slip == 0);
    SlidingPair light = pair;
    light.normal_impulse = 1.1;  // 0.55 < sqrt(0.34) = 0.583
    const FrictionImpulse slipping = yamane_nakamura(light, friction, dt);
    CHECK((slipping.impulse - Vec2(0, -0.2 * 1.1)).norm() < 1e-15);  // omega(0.2) is 1 to 1e-800
    CHECK(slipping.slip == 0.2);
    light.velocity = {0, 0};
    light.stretch = {1, 0};
    CHECK(yamane_nakamura(light, friction, dt).impulse == Vec2(0, 0));  // (5.25): no slip, no force
}

TEST_CASE("friction law: no friction is longer than mu_s times the normal impulse, over random pairs")
{
    Random random;
    int slipped = 0;
    for (int i = 0; i < 20000; ++i) {
        const double dt = random.magnitude(1e-4, 0.1), normal = random.magnitude(1e-6, 1e3),
                     w = random.magnitude(1e-3, 1e3);
        const Vec2 stretch = random.vector(random.magnitude(1e-8, 1)),
                   velocity = random.vector(random.magnitude(1e-8, 10));
        const auto printed = random_friction<YamaneNakamura>(random);
        CHECK(yamane_nakamura({stretch, velocity, normal}, printed, dt).impulse.norm() <=
              printed.mu_s * normal * (1 + 1e-14));

        const auto mass_splitting = random_friction<MassSplitting>(random);
        const Vec2 guess = random.vector(mass_splitting.mu_s * normal / 2);
        const FrictionImpulse better = better_impulse(
            guess, velocity, w, normal, anchor_of(mass_splitting, w, stretch, dt), mass_splitting);
        CHECK(better.impulse.norm() <= mass_splitting.mu_s * normal * (1 + 1e-14));
        if (better.slip > 0) {
            ++slipped;
            CHECK(better.impulse.norm() >= mass_splitting.mu_d * normal * (1 - 1e-12));
        }
    }
    CHECK(slipped > 1000);
    CHECK(slipped < 19000);
}

TEST_CASE("friction law: one pair alone is one step of backward Euler of a damped spring")
{
    Random random;
    for (int i = 0; i < 1000; ++i) {
        const MassSplitting friction{.mu_s = 1e9, .spring = random.magnitude(10, 1e4)};  // holds anything
        const double dt = 0.01, mass = random.magnitude(0.5, 100);
        CAPTURE(mass);
        CAPTURE(friction.spring);
        const Vec2 stretch = random.vector(0.1), velocity = random.vector(1);
        const Anchor anchor = anchor_of(friction, 1 / mass, stretch, dt);
        REQUIRE(anchor.spring == doctest::Approx(std::min(friction.spring, mass / (dt * dt))));
        CHECK(anchor.damper == doctest::Approx(friction.damping_ratio * 2 * std::sqrt(anchor.spring * mass)));
        const Vec2 impulse = better_impulse(Vec2::Zero(), velocity, 1 / mass, 1, anchor, friction).impulse;
        // m (u - v) = -dt (k (s + dt u) + d u)
        const Vec2 u = (mass * velocity - dt * anchor.spring * stretch) /
                       (mass + dt * (dt * anchor.spring + anchor.damper));
        CHECK((impulse - mass * (u - velocity)).norm() <= 1e-11 * (mass * velocity).norm());
    }
}

TEST_CASE("friction law: fast slip feels mu_d, slow slip mu_s, and friction opposes it")
{
    const MassSplitting friction{.mu_s = 0.4, .mu_d = 0.1, .spring = 1000};
    const double mass = 2, normal = 0.3, dt = 0.01;
    const Anchor anchor = anchor_of(friction, 1 / mass, Vec2::Zero(), dt);
    const Vec2 direction(0.6, 0.8);
    const FrictionImpulse fast = better_impulse(Vec2::Zero(), 3 * direction, 1 / mass, normal, anchor,
                                                friction);
    CHECK((fast.impulse + 0.1 * normal * direction).norm() < 1e-12);
    // the velocity that mu_s just stops
    const double holdable = 0.4 * normal * (1 / mass + anchor.yielding());
    const FrictionImpulse slow = better_impulse(Vec2::Zero(), 1.0001 * holdable * direction, 1 / mass, normal,
                                                anchor, friction);
    CHECK(slow.slip == doctest::Approx(0.0001 * holdable).epsilon(1e-6));
    CHECK((slow.impulse + 0.4 * normal * direction).norm() < 1e-4);
    CHECK(better_impulse(Vec2::Zero(), 0.9999 * holdable * direction, 1 / mass, normal, anchor, friction)
              .slip == 0);
}

TEST_CASE("friction law: a tangent plane's coordinates keep lengths and leave the normal out")
{
    Random random;
    for (int i = 0; i < 1000; ++i) {
        Vec3 n(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        if (i < 6)
            n = (i % 2 ? -1.0 : 1.0) * Vec3::Unit(i / 2);
        n.normalize();
        const TangentPlane plane(n);
        const Vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        CHECK((plane.projected(v) - (v - n.dot(v) * n)).norm() < 1e-14);
        const Vec2 flat = random.vector(1);
        CHECK(plane.in_space(flat).norm() == doctest::Approx(flat.norm()).epsilon(1e-14));
    }
}
