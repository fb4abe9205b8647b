#include "chapters/13_other_solvers/barrier_distances.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <set>

using namespace enduring;

namespace {

FourPoints moved(FourPoints x, int coordinate, double by)
{
    x[static_cast<std::size_t>(coordinate / 3)][coordinate % 3] += by;
    return x;
}

/// Slopes by differences against the gradient, and slopes of the gradient against the Hessian.
void check_slopes(const FourPoints& x, const std::function<Derivatives(const FourPoints&)>& of, double size)
{
    constexpr double h = 1e-5;
    const Derivatives here = of(x);
    for (int k = 0; k < 12; ++k) {
        const Derivatives more = of(moved(x, k, h)), less = of(moved(x, k, -h));
        CHECK(std::abs((more.value - less.value) / (2 * h) - here.gradient[k]) <= 1e-6 * size);
        CHECK(((more.gradient - less.gradient) / (2 * h) - here.hessian.col(k)).norm() <= 1e-5 * size);
    }
    CHECK((here.hessian - here.hessian.transpose()).norm() <= 1e-12 * size);
}

/// The case: how many corners have a part on either side.
std::pair<int, int> case_of(const NearestPoints& nearest)
{
    const auto has = [&](double sign) {
        return static_cast<int>(std::count_if(nearest.weights.begin(), nearest.weights.end(),
                                              [sign](double w) { return sign * w > 0; }));
    };
    return {has(1), has(-1)};
}

/// The least distance over a grid of places on both features.
double by_grid(const FourPoints& x, bool is_edges)
{
    constexpr int n = 60;
    double least = 1e300;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= (is_edges ? n : n - i); ++j) {
            const double s = i / double(n), t = j / double(n);
            const Vec3 difference = is_edges ? Vec3(lerp(x[0], x[1], s) - lerp(x[2], x[3], t))
                                             : Vec3(x[0] - (1 - s - t) * x[1] - s * x[2] - t * x[3]);
            least = std::min(least, difference.norm());
        }
    return least;
}

}  // namespace

TEST_CASE(
    "barrier distances: value, gradient and Hessian are those of the distance, in all cases of two features")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (const bool is_edges : {false, true}) {
        std::set<std::pair<int, int>> cases;
        for (int i = 0; i < 200; ++i) {
            FourPoints x;
            for (Vec3& point : x)
                point = Vec3(coordinate(random), coordinate(random), coordinate(random));
            const auto nearest_of = is_edges ? nearest_of_edges : nearest_of_point_triangle;
            const NearestPoints nearest = nearest_of(x);
            CHECK(by_grid(x, is_edges) >= nearest.difference.norm() - 1e-12);
            CHECK(by_grid(x, is_edges) <= nearest.difference.norm() + 0.06);
            const bool stays = std::all_of(nearest.weights.begin(), nearest.weights.end(),
                                           [](double w) { return w == 0 || (std::abs(w) > 0.02); });
            const double least = is_edges ? (x[1] - x[0]).cross(x[3] - x[2]).norm() /
                                                ((x[1] - x[0]).norm() * (x[3] - x[2]).norm())
                                          : (x[2] - x[1]).cross(x[3] - x[1]).norm();
            if (!stays || least < 0.2)  // differences see one case
                continue;
            cases.insert(case_of(nearest));
            check_slopes(
                x, [&](const FourPoints& y) { return squared_distance(y, nearest_of(y)); }, 30);
        }
        CHECK(cases.size() == (is_edges ? 4 : 3));
    }
}

TEST_CASE(
    "barrier distances: the mollifier of edges is 0 where they are parallel, 1 from its bound on, and smooth between")
{
    const FourPoints parallel{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(2, 1, 0)};
    CHECK(edge_mollifier(parallel, 0.1).value == 0);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    for (int i = 0; i < 50; ++i) {
        FourPoints x = parallel;
        for (Vec3& point : x)
            point += 0.2 * Vec3(coordinate(random), coordinate(random), coordinate(random));
        const double c = (x[1] - x[0]).cross(x[3] - x[2]).squaredNorm();
        CHECK(edge_mollifier(x, c).value == 1);
        CHECK(edge_mollifier(x, 2 * c).value == doctest::Approx(0.75));  // 2 / 2 - 1 / 4
        check_slopes(
            x, [&](const FourPoints& y) { return edge_mollifier(y, 2); }, 30);
    }
}
