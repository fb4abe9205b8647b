#include "exercises/11_exact_contact/1_natural_map.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>

using namespace enduring;

namespace {

double along(const Vec3& of) { return std::hypot(of.y(), of.z()); }

}  // namespace

TEST_CASE("nearest point: what is inside stays, and what is behind the tip goes to it")
{
    for (const Vec3& inside : {Vec3(1, 0.3, 0.4), Vec3(1, 0, 0), Vec3(2, -0.5, 0)}) {
        given("impulse ", inside.transpose(), ", mu 0.5");
        expect("nearest point", nearest_point(inside, 0.5), inside, 1e-14, "N s");
    }
    for (const Vec3& behind : {Vec3(-1, 0, 0), Vec3(-1, 1.9, 0), Vec3(-0.51, 0.6, 0.8)}) {
        given("impulse ", behind.transpose(), ", mu 0.5");
        expect("nearest point", nearest_point(behind, 0.5), Vec3(0, 0, 0), 1e-14, "N s");
    }
    given("impulse (-0.49, 0.6, 0.8), mu 0.5: just beside");
    expect("nearest point", nearest_point(Vec3(-0.49, 0.6, 0.8), 0.5), Vec3(0.008, 0.0024, 0.0032), 1e-14,
           "N s");
}

TEST_CASE("nearest point: what is missing is at right angles to it, and behind the tip")
{
    RandomInputs random(1);
    for (int i = 0; i < 500; ++i) {
        const Vec3 impulse = random.normal_vector();
        const double mu = 0.05 + std::abs(random.normal());
        given("impulse ", impulse.transpose(), ", mu ", mu);
        const Vec3 point = nearest_point(impulse, mu), missing = impulse - point;
        expect_that("it lies in the cone", along(point) <= mu * point.x() + 1e-12);
        expect("product of the two", point.dot(missing), 0, 1e-12, "N^2 s^2");
        expect_that("what is missing is behind the tip", mu * along(missing) <= -missing.x() + 1e-12);
    }
}

TEST_CASE("map: zero where a contact holds, slides or flies")
{
    given("holds: r (2, -0.6, -0.8), u 0, mu 0.6");
    expect("map", map_of_contact(Vec3(2, -0.6, -0.8), Vec3::Zero(), 0.6), Vec3(0, 0, 0), 1e-14, "N s");
    given("slides: r (2, -0.6, -0.8), u (0, 0.9, 1.2), mu 0.5");
    expect("map", map_of_contact(Vec3(2, -0.6, -0.8), Vec3(0, 0.9, 1.2), 0.5), Vec3(0, 0, 0), 1e-14, "N s");
    given("flies: r 0, u (1, 3, 4), mu 0.5");
    expect("map", map_of_contact(Vec3::Zero(), Vec3(1, 3, 4), 0.5), Vec3(0, 0, 0), 1e-14, "N s");
}

TEST_CASE("map: what comes in, what is lifted while it slides, and friction along the slip are wrong")
{
    given("r 0, u (-1, 0, 0), mu 0.5");
    expect("map", map_of_contact(Vec3::Zero(), Vec3(-1, 0, 0), 0.5), Vec3(-1, 0, 0), 1e-14, "N s");
    given("lifted: r (2, -1, 0), u (0.5, 1, 0), mu 0.5");
    expect_that("the map is not zero", map_of_contact(Vec3(2, -1, 0), Vec3(0.5, 1, 0), 0.5).norm() > 0.1);
    given("along the slip: r (2, 1, 0), u (0, 1, 0), mu 0.5");
    expect_that("the map is not zero", map_of_contact(Vec3(2, 1, 0), Vec3(0, 1, 0), 0.5).norm() > 0.1);
}

TEST_CASE("block: its impulse makes the map zero, whatever it does")
{
    RandomInputs random(2);
    for (int i = 0; i < 300; ++i) {
        const Vec3 free_velocity = random.normal_vector();
        const double mass = std::exp(random.normal()), mu = 0.1 + std::abs(random.normal());
        given("free velocity ", free_velocity.transpose(), " m/s, mass ", mass, " kg, mu ", mu);
        const Vec3 impulse = impulse_on_block(free_velocity, mass, mu);
        expect("map", map_of_contact(impulse, free_velocity + impulse / mass, mu), Vec3(0, 0, 0), 1e-12,
               "N s");
        expect("normal impulse", impulse.x(), std::max(0.0, -mass * free_velocity.x()), 1e-12, "N s");
    }
    given("free velocity (-1, 1.2, 1.6) m/s, mass 2 kg, mu 0.5");
    expect("impulse", impulse_on_block(Vec3(-1, 1.2, 1.6), 2, 0.5), Vec3(2, -0.6, -0.8), 1e-14, "N s");
}

TEST_CASE("passes: the error falls by 1 + h each time, and the first solve counts")
{
    for (const double h : {1.0, 10.0, 100.0, 1e6})
        for (const double part : {0.6, 1e-2, 1e-6, 3e-13}) {
            int expected = 0;
            for (double left = 1; left > part; left /= 1 + h)
                ++expected;
            given("h ", h, ", part ", part);
            expect("passes", passes_needed(h, part), expected, 0, "");
        }
    given("h 1, part 0.25, which two passes leave exactly");
    expect("passes", passes_needed(1, 0.25), 2, 0, "");
    say("to 1e-9 of the speed: ", passes_needed(100, 1e-9), " passes at h = 100, ", passes_needed(1e6, 1e-9),
        " at h = 1e6");
}
