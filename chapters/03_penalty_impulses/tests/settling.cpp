#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/simulation/point_masses.hpp"
#include "common/simulation/static_body.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;

namespace {

/// Three particles of 1 kg on one large resting triangle, a little off
/// their equilibrium: do they come back to it?
bool settles(PenaltyMethod method, double dt)
{
    const double k = 100, g = 9.81, sink = g / k;
    World world;
    world.bodies.push_back(std::make_unique<PointMasses>(
        "particles", std::vector<Vec3>{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}}, std::vector<Face>{{0, 1, 2}}, 1.0));
    world.bodies.push_back(
        std::make_unique<StaticBody>("floor", SurfaceTopology(3, {{0, 1, 2}}),
                                     std::vector<Vec3>{{-50, 0, -50}, {-50, 0, 100}, {100, 0, -50}}));
    Contacts contacts;
    const Solver solver = chapter03_solver({method, k});
    std::array<double, 2> swing{};
    double last = 0;
    for (int step = 0; step < 2000; ++step) {
        advance(world, contacts, solver, dt);
        const double y = world.bodies[0]->positions_t0()[0].y();
        if (step > 1900)
            swing[1] = std::max(swing[1], std::abs(y - last));
        last = y;
    }
    return swing[1] < 1e-3 * sink;
}

double largest_settling_step(PenaltyMethod method)
{
    double low = 0.05, high = 0.3;
    while (high - low > 1e-4) {
        const double middle = 0.5 * (low + high);
        (settles(method, middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace

TEST_CASE("penalty contact: on a mesh the largest settling steps are chapter 1's, sqrt(4m/3k) and sqrt(2m/k)")
{
    const double discrete = largest_settling_step(PenaltyMethod::discrete);
    const double continuous = largest_settling_step(PenaltyMethod::continuous);
    CHECK(discrete == doctest::Approx(std::sqrt(4.0 / 300)).epsilon(0.01));
    CHECK(continuous == doctest::Approx(std::sqrt(0.02)).epsilon(0.01));
    CHECK(continuous / discrete == doctest::Approx(std::sqrt(1.5)).epsilon(0.01));
}
