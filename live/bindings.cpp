#include "live/figures.hpp"

#include <emscripten/bind.h>

#include <algorithm>

using namespace enduring::live;

namespace {

/// A copy that JavaScript owns.
emscripten::val array_of(const Numbers& numbers)
{
    return emscripten::val::global("Float64Array")
        .new_(emscripten::typed_memory_view(numbers.size(), numbers.data()));
}

std::array<double, 24> points_of(const emscripten::val& points)
{
    const std::vector<double> list = emscripten::convertJSArrayToNumberVector<double>(points);
    std::array<double, 24> result{};
    std::copy_n(list.begin(), std::min(list.size(), result.size()), result.begin());
    return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(live)
{
    using emscripten::function, emscripten::val;
    function(
        "stability", +[](bool continuous, double dt, double k, int steps) {
            return array_of(stability(continuous, dt, k, steps));
        });
    function(
        "query", +[](bool edges, val points) { return array_of(query(edges, points_of(points))); });
    function(
        "integral",
        +[](double d0, double d1, double d2, double d3) { return array_of(integral(d0, d1, d2, d3)); });
    function(
        "slope",
        +[](bool mass_splitting, double angle, double mu_s, double mu_d, double damping, double seconds) {
            return array_of(slope(mass_splitting, angle, mu_s, mu_d, damping, seconds));
        });
    function(
        "circle", +[](double opening) { return array_of(circle(opening)); });
    function("begin_sliding", &begin_sliding);
    function(
        "slide_on", +[](int steps) { return array_of(slide_on(steps)); });
    function(
        "implicit", +[](double h, double centre, bool by_mean, int steps) {
            return array_of(implicit(h, centre, by_mean, steps));
        });
    function(
        "crossing", +[](bool bar, double x, double y, double z, double turn, double tilt) {
            return array_of(crossing(bar, x, y, z, turn, tilt));
        });
    function(
        "passes", +[](double h, int count, double mu, double normal, double along) {
            return array_of(passes(h, count, mu, normal, along));
        });
    function(
        "method_titles", +[] { return val::array(method_titles()); });
    function(
        "methods", +[](double mu, double speed, int counts) { return array_of(methods(mu, speed, counts)); });
}
