#include "exercises/12_joints/1_two_bounds.hpp"
#include "exercises/checking.hpp"
#include "exercises/random_inputs.hpp"

#include <cmath>
#include <limits>

using namespace enduring;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("impulse: it is a line between two bounds")
{
    const Line line{2, 3, -1, 4};
    given("bias 2, slope 3, bounds -1 and 4");
    expect("at u = -1", impulse(line, -1), 1, 1e-14, "N s");
    expect("at u = 5", impulse(line, 5), -1, 1e-14, "N s");
    expect("at u = -5", impulse(line, -5), 4, 1e-14, "N s");
}

TEST_CASE("floor: its impulse is that of its spring at the end of the step, and never pulls")
{
    const Line line = floor_line(1000, 0.02, 0.01);
    given("1000 N/m, 2 cm deep, dt 0.01 s");
    expect("standing still", impulse(line, 0), 0.2, 1e-14, "N s");
    expect("sinking by 1 cm in the step", impulse(line, -1), 0.3, 1e-14, "N s");
    expect("leaving fast", impulse(line, 5), 0, 0, "N s");
    expect("above the floor", impulse(floor_line(1000, -0.02, 0.01), 0), 0, 0, "N s");
}

TEST_CASE("rope: it pulls where the step ends below its length, and is slack above")
{
    const Line line = rope_line(1000, 0.02, 0.01);
    given("1000 N/m, slack by 2 cm, dt 0.01 s");
    expect("standing still", impulse(line, 0), 0, 0, "N s");
    expect("falling by 3 cm in the step", impulse(line, -3), 0.1, 1e-14, "N s");
    expect("stretched by 1 cm", impulse(rope_line(1000, -0.01, 0.01), 0), 0.1, 1e-14, "N s");
}

TEST_CASE("brake: it resists both ways, up to its largest force")
{
    const Line line = brake_line(50, 1000, 0.01);
    given("50 N at most, holding with 1000 kg, dt 0.01 s");
    expect("creeping down", impulse(line, -1e-4), 0.1, 1e-14, "N s");
    expect("falling", impulse(line, -2), 0.5, 1e-14, "N s");
    expect("rising", impulse(line, 2), -0.5, 1e-14, "N s");
}

TEST_CASE("velocity: what moves the lift is the sum of all lines at this velocity")
{
    RandomInputs random(5);
    for (int run = 0; run < 200; ++run) {
        std::vector<Line> lines;
        for (int i = 0; i < 3; ++i) {
            const double low = i == 0 ? 0 : -std::abs(random.normal());
            lines.push_back({random.normal(), std::exp(2 * random.normal()), low,
                             i == 2 ? std::abs(random.normal()) : infinite});
        }
        const double mass = std::exp(random.normal()), free = 3 * random.normal();
        given("run ", run);
        const double u = velocity_after(mass, free, lines);
        double sum = 0;  // by the definition, not by the student's own impulse()
        for (const Line& line : lines)
            sum += std::max(line.low, std::min(line.high, -(line.bias + line.slope * u)));
        expect("m (u - u*) less all impulses", mass * (u - free) - sum, 0, 1e-8 * (1 + std::abs(sum)), "N s");
    }
}

TEST_CASE("lift: without lines it falls freely, a stiff floor stops it, a weak brake does not")
{
    given("500 kg, falling with 1 m/s");
    expect("without lines", velocity_after(500, -1, {}), -1, 1e-10, "m/s");
    const double stopped = velocity_after(500, -1, {floor_line(5e8, 1e-5, 0.01)}),
                 braked = velocity_after(500, -1, {brake_line(2e4, 1e9, 0.01)});
    expect_that("the floor stops it", std::abs(stopped) < 0.02);
    expect("what a brake of 20 kN leaves", braked, -0.6, 1e-9, "m/s");
    say("a lift of 500 kg that falls with 1 m/s: the floor leaves ", stopped,
        " m/s, a brake of 20 kN leaves ", braked, " m/s");
}
