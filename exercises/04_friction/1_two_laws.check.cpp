#include "chapters/04_friction/friction_law.hpp"
#include "exercises/checking.hpp"

#include <cmath>

namespace enduring {
namespace {

/// mu_s 0.5, mu_d 0.2; spring 100 N/m, damper 25 N s/m; slip counts from 5 cm/s on.
YamaneNakamura thesis() { return {.mu_s = 0.5, .mu_d = 0.2, .spring = 100, .damper = 25, .weighting = 1e4}; }

MassSplitting mass_splitting()
{
    return {.mu_s = 0.5, .mu_d = 0.3, .spring = 2000, .damping_ratio = 20, .weighting = 20};
}

constexpr double dt = 0.1;
const SlidingPair holding{{0.03, 0}, {0, 0.2}, 1.2};

}  // namespace

TEST_CASE("thesis: spring and damper hold against stretch and slip, up to mu_s")
{
    given("stretch (0.03, 0) m, slip (0, 0.2) m/s, normal impulse 1.2 N s, dt 0.1 s");
    const FrictionImpulse held = yamane_nakamura(holding, thesis(), dt);
    expect("friction impulse", held.impulse, Vec2(-0.3, -0.5), 1e-14, "N s");
    expect("slip", held.slip, 0.0, 0, "m/s");
}

TEST_CASE("thesis: beyond mu_s dynamic friction acts against the slip, and the spring is forgotten")
{
    SlidingPair light = holding;
    light.normal_impulse = 1.1;
    given("stretch (0.03, 0) m, slip (0, 0.2) m/s, normal impulse 1.1 N s, dt 0.1 s");
    const FrictionImpulse slipping = yamane_nakamura(light, thesis(), dt);
    expect("friction impulse", slipping.impulse, Vec2(0, -0.22), 1e-14, "N s");
    expect("slip", slipping.slip, 0.2, 1e-15, "m/s");
    const Vec2 held = yamane_nakamura(holding, thesis(), dt).impulse;
    say("the thesis' law: held with ", readable(held), " N s; a lighter pair slips with ",
        readable(slipping.impulse), " N s");
}

TEST_CASE(
    "thesis: exactly at mu_s it still holds, and a little beyond it slips, however small or large it all is")
{
    const YamaneNakamura exact{.mu_s = 0.5, .mu_d = 0.2, .spring = 64, .damper = 32, .weighting = 1e12};
    for (const int power : {-30, 0, 20}) {
        const double size = std::ldexp(1.0, power);
        SlidingPair pair{{0.375 * size, 0}, {0, size}, 10 * size};
        given("stretch (0.375, 0) m, slip (0, 1) m/s and normal impulse 10 N s, all times ", size,
              "; spring 64 N/m, damper 32 N s/m, dt 0.125 s: the pull is 5 N s times as much");
        const FrictionImpulse held = yamane_nakamura(pair, exact, 0.125);
        expect("friction impulse", held.impulse, Vec2(Vec2(-3, -4) * size), 1e-12 * size, "N s");
        expect("slip", held.slip, 0.0, 0, "m/s");
        pair.normal_impulse = 9.99 * size;
        given("the same with a normal impulse of 9.99 N s times ", size);
        const FrictionImpulse slipping = yamane_nakamura(pair, exact, 0.125);
        expect("friction impulse", slipping.impulse, Vec2(Vec2(0, -0.2 * 9.99) * size), 1e-12 * size, "N s");
        expect("slip", slipping.slip, size, 1e-12 * size, "m/s");
    }
}

TEST_CASE(
    "thesis: at the slip of ln(2)/k_w dynamic friction is half of mu_d |I_n|, whether that is a creep or a flight")
{
    for (const double weighting : {0.1, 20.0, 1e4, 1e8}) {
        YamaneNakamura friction = thesis();
        friction.weighting = weighting;
        const double speed = std::log(2.0) / weighting;
        given("stretch (1, 0) m, slip (0, ", speed, ") m/s, normal impulse 1 N s, k_w ", weighting, " s/m");
        expect("friction impulse", yamane_nakamura({{1, 0}, {0, speed}, 1}, friction, dt).impulse,
               Vec2(0, -0.1), 1e-12, "N s");
    }
}

TEST_CASE("thesis: a slip of almost nothing is braked in proportion, and none gives none")
{
    YamaneNakamura friction = thesis();
    friction.weighting = 20;
    SlidingPair pair{{1, 0}, {0, 1e-6}, 1};
    {
        given("stretch (1, 0) m, slip (0, 1e-6) m/s, normal impulse 1 N s, k_w 20 s/m");
        expect("friction impulse over mu_d k_w |I_n| v",
               yamane_nakamura(pair, friction, dt).impulse.y() / (0.2 * 20 * 1e-6), -1.0, 1e-4);
    }
    pair.velocity.setZero();
    given("stretch (1, 0) m, no slip at all, normal impulse 1 N s, k_w 20 s/m");
    expect("friction impulse", yamane_nakamura(pair, friction, dt).impulse, Vec2(0, 0), 0, "N s");
}

TEST_CASE("anchor: the spring is capped at what brings the share back in one step, the damper goes with it")
{
    {
        given("spring 2000 N/m, damping ratio 20, share of 2 kg, dt 0.01 s");
        const Anchor soft = anchor_of(mass_splitting(), 0.5, {0.01, 0}, 0.01);
        expect("spring", soft.spring, 2000.0, 1e-9, "N/m");
        expect("damper", soft.damper, 40 * std::sqrt(4000.0), 1e-9, "N s/m");
    }
    given("spring 2000 N/m, damping ratio 20, share of 2 kg, dt 0.1 s");
    const Anchor capped = anchor_of(mass_splitting(), 0.5, {0.01, -0.03}, 0.1);
    expect("spring", capped.spring, 200.0, 1e-9, "N/m");
    expect("damper", capped.damper, 40 * std::sqrt(400.0), 1e-9, "N s/m");
    expect("stretch", capped.stretch, Vec2(0.01, -0.03), 0, "m");
}

TEST_CASE("mass splitting: a pair alone comes to rest on backward Euler of its spring and damper")
{
    const double inverse_mass = 0.5, step = 0.01;
    const Anchor anchor = anchor_of(mass_splitting(), inverse_mass, {0.001, -0.002}, step);
    const Vec2 free_slip(0.03, 0.01);
    const Vec2 impulse =
        better_impulse({0, 0}, free_slip, inverse_mass, 100, anchor, mass_splitting()).impulse;
    const Vec2 slip = free_slip + inverse_mass * impulse;
    const Vec2 wanted = -step * (anchor.spring * (anchor.stretch + step * slip) + anchor.damper * slip);
    {
        given("stretch (0.001, -0.002) m, slip (0.03, 0.01) m/s without friction, share of 2 kg, dt 0.01 s");
        expect("J against -dt (k (s + dt u) + d u)", impulse, wanted, 1e-12, "N s");
    }
    given("the same pair asked again: impulse ", readable(impulse), " N s and slip ", readable(slip),
          " m/s, as its first answer made them");
    expect("friction impulse",
           better_impulse(impulse, slip, inverse_mass, 100, anchor, mass_splitting()).impulse, impulse, 1e-12,
           "N s");
}

TEST_CASE("mass splitting: who creeps carries mu_s, who slips fast mu_d, and never more than mu_s")
{
    const double inverse_mass = 0.5, normal = 1.2;
    const Anchor anchor = anchor_of(mass_splitting(), inverse_mass, {0, 0}, 0.01);
    given("normal impulse 1.2 N s, mu_s 0.5, mu_d 0.3, k_w 20 s/m, share of 2 kg");
    const FrictionImpulse creeping = better_impulse({0, 0}, {0.3236, 0}, inverse_mass, normal, anchor,
                                                    mass_splitting());
    const FrictionImpulse fast = better_impulse({0, 0}, {30, 0}, inverse_mass, normal, anchor,
                                                mass_splitting());
    expect("carried at a creep", creeping.impulse.norm(), 0.6, 0.02, "N s");
    expect_that("at a creep it is no more than mu_s |I_n|", creeping.impulse.norm() <= 0.6);
    expect("carried at 30 m/s", fast.impulse, Vec2(-0.36, 0), 1e-9, "N s");
    expect("slip of the anchor, r (|J'| - mu_s |I_n|)", fast.slip,
           30 - (inverse_mass + anchor.yielding()) * 0.6, 1e-9, "m/s");
    say("mass-splitting friction: at the limit it carries ", std::round(10 * creeping.impulse.norm()) / 10,
        " N s, at a fast slip ", fast.impulse.norm(), " N s");
}

TEST_CASE(
    "mass splitting: J' is cut to its limit along its own direction, which falls from mu_s to mu_d with the slip of the anchor")
{
    const double inverse_mass = 0.5, step = 0.01;
    const MassSplitting friction = mass_splitting();
    const Anchor anchor = anchor_of(friction, inverse_mass, {0.002, -0.001}, step);
    const double response = inverse_mass + anchor.yielding();
    const Vec2 impulse(0.1, 0.2), direction(0.6, -0.8);
    for (const double normal : {1e-6, 1.0, 1e3})
        for (const double halvings : {0.5, 1.0, 3.0}) {
            const double slip = halvings * std::log(2.0) / friction.weighting;
            const Vec2 wanted = (friction.mu_s * normal + slip / response) * direction;
            const Vec2 velocity = anchor.held_velocity(impulse) - response * (wanted - impulse);
            given("normal impulse ", normal, " N s, J ", readable(impulse),
                  " N s, and a slip for which J' is (0.6, -0.8) times ", wanted.norm(),
                  " N s: omega = 1 - 2^-", halvings);
            const FrictionImpulse better = better_impulse(impulse, velocity, inverse_mass, normal, anchor,
                                                          friction);
            const double mu = friction.mu_d + (friction.mu_s - friction.mu_d) * std::pow(0.5, halvings);
            expect("friction impulse over |I_n|", Vec2(better.impulse / normal), Vec2(mu * direction), 1e-8);
            expect("slip of the anchor", better.slip, slip, 1e-9, "m/s");
        }
}

TEST_CASE("mass splitting: without a normal impulse nothing is carried, and no NaN")
{
    const Anchor anchor = anchor_of(mass_splitting(), 0.5, {0, 0}, 0.01);
    for (const double slip : {0.0, 0.03}) {
        given("normal impulse 0 N s, stretch (0, 0) m, J (0, 0) N s, slip (", slip, ", 0) m/s");
        expect("friction impulse",
               better_impulse({0, 0}, {slip, 0}, 0.5, 0, anchor, mass_splitting()).impulse, Vec2(0, 0), 0,
               "N s");
    }
}

TEST_CASE("after slip: the anchor lags by what the pull can hold, and less the faster it slips")
{
    given("impulse 0.4 N s, spring 2000 N/m, dt 0.01 s, k_w 20 s/m");
    expect("stretch at no slip", stretch_after_slip(0, 0.4, mass_splitting(), 0.01), 0.02, 1e-15, "m");
    expect("stretch at ln(2)/20 m/s", stretch_after_slip(std::log(2.0) / 20, 0.4, mass_splitting(), 0.01),
           0.01, 1e-15, "m");
    MassSplitting soft = mass_splitting();
    soft.spring = 250;
    given("impulse 0.4 N s, spring 250 N/m, dt 0.01 s, k_w 20 s/m");
    expect("stretch at 2 ln(2)/20 m/s", stretch_after_slip(2 * std::log(2.0) / 20, 0.4, soft, 0.01), 0.04,
           1e-15, "m");
}

}  // namespace enduring
