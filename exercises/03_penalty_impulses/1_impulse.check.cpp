#include "chapters/03_penalty_impulses/penalty_impulse.hpp"
#include "exercises/checking.hpp"

#include <array>
#include <cmath>

using namespace enduring;

namespace {

constexpr double k = 800, dt = 0.01;

/// A vertex at a height over the floor y = 0, of which the face is a
/// right angle with two sides of this length [m].
PairVertices over_floor(double height, double side = 1)
{
    return {Vec3(0.2 * side, height, 0.2 * side), Vec3(0, 0, 0), Vec3(0, 0, side), Vec3(side, 0, 0)};
}

PairStep vertex_face_step(const PairVertices& t0, const PairVertices& t1)
{
    return {vertex_face_instant(t0), vertex_face_instant(t1)};
}

/// A vertex that comes down through the floor at constant speed.
PairStep fall(double from, double to, double side = 1)
{
    return vertex_face_step(over_floor(from, side), over_floor(to, side));
}

PairVertices between(const PairVertices& t0, const PairVertices& t1, double tau)
{
    PairVertices x;
    for (std::size_t i = 0; i < 4; ++i)
        x[i] = (1 - tau) * t0[i] + tau * t1[i];
    return x;
}

/// The impulse from its definition: the step in many equal pieces, each looked at in its middle.
Vec3 summed_impulse(const PairVertices& t0, const PairVertices& t1, double start = 0)
{
    const int pieces = 20000;
    Vec3 sum = Vec3::Zero();
    double squared_lengths = 0;
    for (int i = 0; i < pieces; ++i) {
        const double tau = (i + 0.5) / pieces;
        const PairVertices x = between(t0, t1, tau);
        const Vec3 normal = (x[2] - x[1]).cross(x[3] - x[1]);
        const double depth = normal.dot(x[0] - x[1]);
        if (depth < 0 && tau > start)
            sum += depth * normal;
        squared_lengths += normal.squaredNorm();
    }
    return -k * dt / squared_lengths * sum;
}

/// A face that sways about the z axis while a vertex passes over it: the vertex is inside twice.
std::array<PairVertices, 2> two_visits()
{
    return {{{Vec3(0.45, 0.005, 0), Vec3(-1, -0.06, -1), Vec3(-1, -0.06, 1), Vec3(1, 0.06, 0)},
             {Vec3(-0.45, 0.01, 0), Vec3(-1, 0.08, -1), Vec3(-1, 0.08, 1), Vec3(1, -0.08, 0)}}};
}

double binomial(int n, int i) { return i == 0 ? 1 : binomial(n, i - 1) * (n - i + 1) / i; }

}  // namespace

TEST_CASE(
    "discrete impulse: a vertex 2 mm under the floor is pushed up by k dt times 2 mm, on large faces and on small ones")
{
    for (const double side : {1.0, 0.1, 3.0}) {
        given("a face of sides ", side, " m, k = 800 N/m, dt = 0.01 s");
        expect("impulse on the vertex",
               discrete_impulse(vertex_face_instant(over_floor(-0.002, side)), k, dt),
               Vec3(0, k * dt * 0.002, 0), 1e-12, "N s");
    }
}

TEST_CASE("discrete impulse: a vertex outside is not pulled back")
{
    given("2 mm above the floor");
    expect("impulse on the vertex", discrete_impulse(vertex_face_instant(over_floor(0.002)), k, dt),
           Vec3(0, 0, 0), 0, "N s");
}

TEST_CASE("size: no face, no depth and no visit is too small or too large to count")
{
    for (const double side : {1e-6, 1e-3, 1.0, 1e3})
        for (const double depth : {1e-9, 1e-3, 1.0}) {
            given("a vertex ", depth, " m under a face of sides ", side, " m, k = 800 N/m, dt = 0.01 s");
            const Vec3 expected(0, k * dt * depth, 0);
            expect("discrete impulse", discrete_impulse(vertex_face_instant(over_floor(-depth, side)), k, dt),
                   expected, 1e-9 * depth, "N s");
            expect("continuous impulse", continuous_impulse(fall(-depth, -depth, side), 0, k, dt), expected,
                   1e-9 * depth, "N s");
        }
    given("a vertex that stays 2 mm under the floor, start = 1 - 2^-20");
    expect("continuous impulse", continuous_impulse(fall(-0.002, -0.002), 1 - 0x1p-20, k, dt),
           Vec3(0, k * dt * 0.002 * 0x1p-20, 0), 1e-14, "N s");
}

TEST_CASE("without a normal: a face that is a needle gives no impulse, and no NaN")
{
    const PairInstant needle{Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(0, -1, 0)};
    given("sides (1, 0, 0) m and (2, 0, 0) m");
    expect("discrete impulse", discrete_impulse(needle, k, dt), Vec3(0, 0, 0), 0, "N s");
    expect("continuous impulse", continuous_impulse({needle, needle}, 0, k, dt), Vec3(0, 0, 0), 0, "N s");
}

TEST_CASE("integral of the product: right for each of the twelve products of basis polynomials")
{
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 2; ++j) {
            Bernstein<double, 3> depth{};
            Bernstein<Vec3, 2> normal{{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)}};
            depth.coefficients[i] = 1;
            normal.coefficients[j] = Vec3(1, -2, 0);
            given("depth ", i, " is 1, normal ", j, " is (1, -2, 0), all others are 0");
            const double integral = binomial(3, i) * binomial(2, j) / binomial(5, i + j) / 6;
            expect("integral", integral_of_product(depth, normal), Vec3(1, -2, 0) * integral, 1e-14);
        }
}

TEST_CASE(
    "continuous impulse: a vertex that falls through the floor gets k dt times the triangle under its depth")
{
    // Inside for the last half of the step, 3 mm deep at its end: the triangle is 1/2 * 1/2 * 3 mm.
    given("from 3 mm above the floor to 3 mm under it, k = 800 N/m, dt = 0.01 s");
    expect("impulse on the vertex", continuous_impulse(fall(0.003, -0.003), 0, k, dt),
           Vec3(0, k * dt * 0.00075, 0), 1e-12, "N s");
    say("falling in:  continuous ", continuous_impulse(fall(0.003, -0.003), 0, k, dt).y(), " N s, discrete ",
        discrete_impulse(fall(0.003, -0.003).t1, k, dt).y(), " N s");
    say("climbing out: continuous ", continuous_impulse(fall(-0.003, 0.003), 0, k, dt).y(), " N s, discrete ",
        discrete_impulse(fall(-0.003, 0.003).t1, k, dt).y() + 0.0, " N s");
}

TEST_CASE("continuous impulse: it points out of the face, even when most of the step is spent outside")
{
    given("from 9 mm above the floor to 1 mm under it");
    const Vec3 impulse = continuous_impulse(fall(0.009, -0.001), 0, k, dt);
    expect_that("the impulse on the vertex points up; it is " + readable(impulse) + " N s", impulse.y() > 0);
}

TEST_CASE("continuous impulse: half the step, half the impulse")
{
    given("from 3 mm above the floor to 3 mm under it, dt = 0.01 s and dt = 0.005 s");
    const Vec3 all = continuous_impulse(fall(0.003, -0.003), 0, k, 0.01),
               half = continuous_impulse(fall(0.003, -0.003), 0, k, 0.005);
    expect("twice the impulse of the shorter step", 2 * half, all, 1e-12, "N s");
}

TEST_CASE("continuous impulse: how large the face is does not matter")
{
    for (const double side : {0.1, 3.0}) {
        given("a face of sides ", side, " m; a vertex that stays 2 mm under it");
        expect("impulse on the vertex", continuous_impulse(fall(-0.002, -0.002, side), 0, k, dt),
               Vec3(0, k * dt * 0.002, 0), 1e-12, "N s");
    }
}

TEST_CASE("continuous impulse: what lies before the start of the pair does not count")
{
    // At constant depth each part of the step gives the same: a quarter is left.
    given("2 mm under the floor all the time, start = 0.75");
    expect("impulse on the vertex", continuous_impulse(fall(-0.002, -0.002), 0.75, k, dt),
           Vec3(0, k * dt * 0.0005, 0), 1e-12, "N s");
}

TEST_CASE("continuous impulse: a face that turns pushes along all its normals, not along one")
{
    PairVertices t0{Vec3(0.2, -0.1, 0.2), Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)};
    PairVertices t1{Vec3(0.2, -0.1, 0.2), Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0.7, 0.7, 0)};
    given("a face that turns about the z axis by 45 degrees, over a vertex at (0.2, -0.1, 0.2) m");
    expect("impulse on the vertex", continuous_impulse(vertex_face_step(t0, t1), 0, k, dt),
           summed_impulse(t0, t1), 1e-6, "N s");
}

TEST_CASE("continuous impulse: a vertex that is inside twice gets the sum of both visits")
{
    const auto [t0, t1] = two_visits();
    given("a face that sways while a vertex passes over it");
    const Vec3 impulse = continuous_impulse(vertex_face_step(t0, t1), 0, k, dt);
    expect("impulse on the vertex", impulse, summed_impulse(t0, t1), 1e-6, "N s");
    say("two visits:  continuous ", impulse.norm(), " N s, discrete ",
        discrete_impulse(vertex_face_instant(t1), k, dt).norm(), " N s");
}

TEST_CASE("two edges: the lower one keeps pushing up after the upper one went through")
{
    // 3 mm apart in height, across each other; orientation as at first contact, when a was above.
    const PairVertices x{Vec3(-1, -0.003, 0), Vec3(1, -0.003, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
    const PairInstant pair = edge_edge_instant(x, 1);
    given("edge a along x lies 3 mm under edge b along -z, orientation 1");
    expect("discrete impulse on a", discrete_impulse(pair, k, dt), Vec3(0, k * dt * 0.003, 0), 1e-12, "N s");
    expect("continuous impulse on a", continuous_impulse({pair, pair}, 0, k, dt), Vec3(0, k * dt * 0.003, 0),
           1e-12, "N s");
}
