#include "exercises/11_exact_contact/2_multiplier_step.hpp"
#include "exercises/checking.hpp"

#include <cmath>

using namespace enduring;

namespace {

/// Of 2 kg in steps of 0.1 s, so that h = stiffness / 200.
BlockOnSpring block_of(double h, double mu, const Vec3& free_velocity)
{
    return {2, 200 * h, 0.1, mu, free_velocity};
}

}  // namespace

TEST_CASE("solve: a spring that is not pressed in stops the part of the velocity that its stiffness gives")
{
    given("2 kg, h 3, mu 1, free velocity (-1, 0.3, 0.4) m/s");
    expect("impulse", impulse_of_spring(block_of(3, 1, Vec3(-1, 0.3, 0.4)), Vec3::Zero()),
           Vec3(1.5, -0.45, -0.6), 1e-13, "N s");
    given("the same block with mu 0.25");
    expect("impulse", impulse_of_spring(block_of(3, 0.25, Vec3(-1, 0.3, 0.4)), Vec3::Zero()),
           Vec3(1.5, -0.225, -0.3), 1e-13, "N s");
}

TEST_CASE("solve: a spring that is pressed in pushes, and never pulls")
{
    given("2 kg, h 3, mu 1, free velocity 0, begin (0.04, 0.01, 0) m");
    expect("impulse", impulse_of_spring(block_of(3, 1, Vec3::Zero()), Vec3(0.04, 0.01, 0)),
           Vec3(0.6, 0.15, 0), 1e-13, "N s");
    given("2 kg, h 3, mu 1, free velocity (1, 1, 0) m/s, begin (0.04, 0.01, 0) m");
    expect("impulse", impulse_of_spring(block_of(3, 1, Vec3(1, 1, 0)), Vec3(0.04, 0.01, 0)), Vec3(0, 0, 0),
           1e-13, "N s");
}

TEST_CASE("solve: friction is cut to its limit at every size")
{
    for (const double size : {1e-6, 1e-3, 1.0, 1e3}) {
        given("2 kg, h 3, mu 0.4, free velocity ", size, " times (-1, 0.3, 0.4) m/s");
        expect("impulse over the size",
               Vec3(impulse_of_spring(block_of(3, 0.4, size * Vec3(-1, 0.3, 0.4)), Vec3::Zero()) / size),
               Vec3(1.5, -0.36, -0.48), 1e-12, "N s");
    }
}

TEST_CASE("memory: a block at rest under it is pushed the same, and does not move")
{
    given("2 kg, h 3, impulse (2, -0.6, -0.8) N s");
    const BlockOnSpring block = block_of(3, 1, Vec3(-1, 0.3, 0.4));
    const Vec3 begin = next_begin(block, Vec3(2, -0.6, -0.8));
    expect("begin", begin, Vec3(1.0 / 30, -0.01, -0.04 / 3), 1e-13, "m");
    expect("impulse of the next solve", impulse_of_spring(block, begin), Vec3(2, -0.6, -0.8), 1e-13, "N s");
}

TEST_CASE("passes: each leaves the part of the error that is predicted")
{
    struct Case {
        double mu;
        Vec3 free_velocity, exact;
    };
    for (const Case& one :
         {Case{0.6, Vec3(-1, 0.3, 0.4), Vec3(2, -0.6, -0.8)},
          Case{0.25, Vec3(-1, 0.9, 1.2), Vec3(2, -0.3, -0.4)}, Case{0.6, Vec3(0.5, 0.3, 0.4), Vec3(0, 0, 0)}})
        for (const double h : {0.5, 3.0, 100.0})
            for (const int passes : {0, 1, 2, 5}) {
                given("2 kg, h ", h, ", mu ", one.mu, ", free velocity ", one.free_velocity.transpose(),
                      " m/s, ", passes, " passes");
                const BlockOnSpring block = block_of(h, one.mu, one.free_velocity);
                const Vec3 expected = (1 - std::exp(-passes * std::log1p(h))) * one.exact;
                expect("impulse", impulse_after(block, passes), expected, 1e-12, "N s");
                expect("prediction", predicted_impulse(block, one.exact, passes), expected, 1e-12, "N s");
            }
    const BlockOnSpring block = block_of(3, 0.6, Vec3(-1, 0.3, 0.4));
    int passes = 0;
    while (passes < 100 && std::abs(1 - impulse_after(block, passes).x() / 2) > 1e-6)
        ++passes;
    say("h = 3: ", passes, " passes until less than a millionth of the impulse is missing");
}
