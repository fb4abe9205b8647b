#include "chapters/02_collision_detection/edge_triangle.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>

#include <random>

using namespace enduring;

namespace {

struct EdgeAndTriangle {
    Vec3 p, q, a, b, c;
};

std::vector<EdgeAndTriangle> random_cases(int count)
{
    std::mt19937_64 engine(41);
    std::uniform_real_distribution<double> in(-1, 1);
    const auto point = [&] { return Vec3(in(engine), in(engine), in(engine)); };
    std::vector<EdgeAndTriangle> cases;
    for (int i = 0; i < count; ++i)
        cases.push_back({point(), point(), point(), point(), point()});
    return cases;
}

/// The condition as the thesis prints it: all three parameters in [0, 1].
bool printed_condition(const EdgeAndTriangle& s)
{
    Mat3 matrix;
    matrix << s.p - s.q, s.b - s.a, s.c - s.a;
    const Vec3 solution = matrix.inverse() * (s.p - s.a);
    return (solution.array() >= 0).all() && (solution.array() <= 1).all();
}

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

/// By signs of volumes alone: p and q lie on different sides of the plane, and
/// the line pq winds around all three edges alike.
bool passes_through(const EdgeAndTriangle& s)
{
    if (volume(s.a, s.b, s.c, s.p) * volume(s.a, s.b, s.c, s.q) > 0)
        return false;
    const double ab = volume(s.p, s.q, s.a, s.b), bc = volume(s.p, s.q, s.b, s.c),
                 ca = volume(s.p, s.q, s.c, s.a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

}  // namespace

TEST_CASE("discrete test: Cramer's rule agrees with the signs of five volumes")
{
    int hits = 0;
    for (const EdgeAndTriangle& s : random_cases(20000)) {
        const auto hit = find_edge_triangle_hit(s.p, s.q, s.a, s.b, s.c);
        CHECK(hit.has_value() == passes_through(s));
        hits += hit.has_value();
    }
    CHECK(hits > 500);
}

TEST_CASE("discrete test: the two points that its weights name are one")
{
    for (const EdgeAndTriangle& s : random_cases(2000))
        if (const auto hit = find_edge_triangle_hit(s.p, s.q, s.a, s.b, s.c)) {
            const Vec3 on_edge = s.p + hit->along_edge * (s.q - s.p);
            const Vec3 in_triangle = s.a + hit->weight_b * (s.b - s.a) + hit->weight_c * (s.c - s.a);
            CHECK((on_edge - in_triangle).norm() < 1e-10);
        }
}

TEST_CASE("errata: with all of (4.4)'s parameters in [0, 1] an edge beside the triangle counts as a hit")
{
    // The edge passes at b + c - a scaled by 0.8: in the parallelogram, outside the triangle.
    const EdgeAndTriangle beside{{0.8, 0.8, -1}, {0.8, 0.8, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(printed_condition(beside));
    CHECK_FALSE(find_edge_triangle_hit(beside.p, beside.q, beside.a, beside.b, beside.c).has_value());

    int printed = 0, real = 0;
    for (const EdgeAndTriangle& s : random_cases(20000)) {
        printed += printed_condition(s);
        real += passes_through(s);
    }
    // A parallelogram is two triangles, but of random ones the far half is met a little less often.
    CHECK(printed > 1.3 * real);
}

TEST_CASE("discrete test: border, ends and parallel edges")
{
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    CHECK(find_edge_triangle_hit({0.5, 0.5, -1}, {0.5, 0.5, 1}, a, b, c).has_value());  // on the long side
    CHECK(find_edge_triangle_hit({0, 0, -1}, {0, 0, 1}, a, b, c).has_value());          // at a corner
    CHECK(find_edge_triangle_hit({0.2, 0.2, 0}, {0.2, 0.2, 1}, a, b, c).has_value());   // with its start
    CHECK(find_edge_triangle_hit({0.2, 0.2, 1}, {0.2, 0.2, 0}, a, b, c).has_value());   // with its end
    CHECK_FALSE(find_edge_triangle_hit({0.2, 0.2, 0.5}, {0.2, 0.2, 1}, a, b, c).has_value());
    // in the plane: not decided here
    CHECK_FALSE(find_edge_triangle_hit({-1, 0.2, 0}, {1, 0.2, 0}, a, b, c).has_value());
}
