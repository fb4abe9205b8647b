#include "chapters/01_particle_plane/amplification.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/01_particle_plane/plane_impulse.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>

using namespace enduring;

// The printed forms of the thesis, each beside the corrected one.

namespace {

/// One step of a particle whose ground answers with `impulse`.
ParticleState step_with(const std::function<double(double, double)>& impulse, ParticleState s, double m,
                        double g, double dt)
{
    const double v = s.velocity - g * dt;
    const double velocity = v + impulse(s.height, s.height + dt * v) / m;
    return {s.height + dt * velocity, velocity};
}

/// (5.19) as printed: +k times the integral of p_y over the interval, no dt.
double printed_5_19(double p0, double p1, double k)
{
    const auto inside = find_plane_interval(p0, p1);
    if (!inside)
        return 0;
    const auto [a, b] = *inside;
    return k * ((b - a) * p0 + (b * b - a * a) / 2 * (p1 - p0));
}

/// (5.20) as printed: (t_a - t_b) k p_y(t_0) - (t_b^2 - t_a^2) / 2 k v_y, no dt.
double printed_5_20(double p0, double p1, double k)
{
    const auto inside = find_plane_interval(p0, p1);
    if (!inside)
        return 0;
    const auto [a, b] = *inside;
    return (a - b) * k * p0 - (b * b - a * a) / 2 * k * (p1 - p0);
}

/// (7.9) as printed: the factor 1/2 stands with the position.
Eigen::Matrix2d printed_7_9(double m, double k, double dt)
{
    const double h = k * dt * dt / m;
    Eigen::Matrix2d a;
    a << 1 - h / 2, dt * (1 - h), -h / (2 * dt), 1 - h;
    return a;
}

}  // namespace

TEST_CASE("errata: 5.19 as printed pulls the vertex into the ground, 5.20 has the sign right")
{
    const double m = 1, k = 1000, dt = 0.01;
    ParticleState printed{0.1, 0}, corrected{0.1, 0};
    for (int i = 0; i < 200; ++i) {
        printed = step_with([&](double p0, double p1) { return dt * printed_5_19(p0, p1, k); }, printed, m,
                            9.81, dt);
        corrected = step_with([&](double p0, double p1) { return dt * printed_5_20(p0, p1, k); }, corrected,
                              m, 9.81, dt);
    }
    CHECK(printed.height < -1e3);
    CHECK(std::abs(corrected.height) < 0.1);
}

TEST_CASE("errata: 5.20 needs the factor dt, or the force depends on the step")
{
    const double k = 1000, depth = -0.01;
    for (const double dt : {0.1, 0.01, 0.001}) {
        CAPTURE(dt);
        // the spring's force [N]
        CHECK(continuous_plane_impulse(depth, depth, k, dt) / dt == doctest::Approx(10));
        // 100 to 10000 N
        CHECK(printed_5_20(depth, depth, k) / dt == doctest::Approx(10 / dt));
        CHECK(dt * printed_5_20(0.02, -0.03, k) ==
              doctest::Approx(continuous_plane_impulse(0.02, -0.03, k, dt)));
    }
}

TEST_CASE("errata: 7.9 has its factor 1/2 on the wrong term, and only 7.11 is stable up to sqrt(2m/k)")
{
    const double m = 1, k = 100;
    const double limit = critical_step(PenaltyMethod::continuous, m, k);
    CHECK(spectral_radius(printed_7_9(m, k, 0.999 * limit)) > 1.3);
    CHECK(spectral_radius(amplification(PenaltyMethod::continuous, m, k, 0.999 * limit)) < 1);
    // As printed it would be stable up to h = 8/5, not 2, and would damp as DPF does.
    CHECK(spectral_radius(printed_7_9(m, k, std::sqrt(1.6 * m / k))) == doctest::Approx(1));
    CHECK(spectral_radius(printed_7_9(m, k, 0.01)) ==
          doctest::Approx(spectral_radius(amplification(PenaltyMethod::discrete, m, k, 0.01))));
}

TEST_CASE(
    "errata: the condition |lambda| < 1 of 7.1.1 is local, and a bounce multiplies matrices that can grow together")
{
    const double m = 1, k = 100, dt = 0.1;
    const Eigen::Matrix2d contact = amplification(PenaltyMethod::continuous, m, k, dt);
    Eigen::Matrix2d flight;
    flight << 1, dt, 0, 1;
    CHECK(spectral_radius(flight) == 1);  // "unstable" by the printed condition, and it only flies
    CHECK(spectral_radius(contact) < 0.75);
    CHECK(spectral_radius(contact * flight * flight * flight * flight * flight) > 4);
}
