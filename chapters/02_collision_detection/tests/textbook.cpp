#include "chapters/02_collision_detection/textbook.hpp"
#include "chapters/02_collision_detection/cubic_roots.hpp"
#include "chapters/02_collision_detection/tests/exact_oracle.hpp"
#include "chapters/02_collision_detection/tests/step_generators.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace enduring;
using namespace enduring::generated;

TEST_CASE("cubic: the roots of a product of linear factors come back, ascending")
{
    Random random(21);
    for (int i = 0; i < 500; ++i) {
        std::array<double, 3> r{random.uniform(-2, -0.8), random.uniform(-0.5, 0.5), random.uniform(0.8, 2)};
        const double lead = random.uniform(0.5, 2);
        const RealRoots roots = cubic_roots(
            {-lead * r[0] * r[1] * r[2], lead * (r[0] * r[1] + r[1] * r[2] + r[2] * r[0]),
             -lead * (r[0] + r[1] + r[2]), lead},
            0);
        REQUIRE(roots.count == 3);
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(roots.values[k] == doctest::Approx(r[k]).epsilon(1e-10));
    }
}

TEST_CASE("cubic: where the leading coefficients vanish the degree falls, and nothing has no roots")
{
    CHECK(cubic_roots({-1, 0, 0, 8}, 0).values[0] == doctest::Approx(0.5));
    CHECK(cubic_roots({-1, 0, 4, 1e-30}, 1e-12).count == 2);
    CHECK(cubic_roots({-1, 0, 4, 0}, 0).values[1] == doctest::Approx(0.5));
    CHECK(cubic_roots({1, 0, 4, 0}, 0).count == 0);
    CHECK(cubic_roots({-1, 2, 0, 0}, 0).values[0] == doctest::Approx(0.5));
    CHECK(cubic_roots({1, 0, 0, 0}, 0).count == 0);
    CHECK(cubic_roots({0, 0, 0, 0}, 0).count == 0);
}

TEST_CASE("cubic: of two roots of very different size the small one keeps its digits")
{
    for (const double sign : {1.0, -1.0}) {
        // -sign * 1e-8 and -sign * 1e8, to 1e-16
        const RealRoots roots = cubic_roots({1, sign * 1e8, 1, 0}, 0);
        REQUIRE(roots.count == 2);
        CHECK(roots.values[sign > 0 ? 1 : 0] == doctest::Approx(-sign * 1e-8).epsilon(1e-14));
    }
}

TEST_CASE("textbook: on ordinary queries its times are those of exact arithmetic")
{
    Random random(22);
    for (int i = 0; i < 300; ++i) {
        const auto face = step_of<VertexFaceStep>(categories()[0].make(random, false));
        const auto edges = step_of<EdgeEdgeStep>(categories()[0].make(random, true));
        CAPTURE(i);
        const auto vf = textbook_time_of_impact(face), ee = textbook_time_of_impact(edges);
        const auto vf_truth = exact::first_touch(face), ee_truth = exact::first_touch(edges);
        REQUIRE(vf.has_value() == vf_truth.has_value());
        REQUIRE(ee.has_value() == ee_truth.has_value());
        if (vf)
            CHECK(std::abs(*vf - vf_truth->time()) <= 1e-9);
        if (ee)
            CHECK(std::abs(*ee - ee_truth->time()) <= 1e-9);
    }
}

TEST_CASE("textbook: it overlooks at least nine in ten touches of features that stay coplanar")
{
    Random random(23);
    int touching = 0, found = 0;
    for (int i = 0; i < 200; ++i) {
        const auto step = step_of<EdgeEdgeStep>(categories()[3].make(random, true));
        touching += exact::first_touch(step).has_value();
        found += textbook_time_of_impact(step).has_value();
    }
    CHECK(touching > 100);
    CHECK(found <= 0.1 * touching);
}

TEST_CASE("textbook: a tolerance that helps at a corner invents a touch beside it")
{
    const Vec3 f0(0, 0, 0), f1(2, 0, 0), f2(0, 2, 0);
    const double beside = 1e-7;
    const VertexFaceStep step{{-beside, 0.5, 1}, f0, f1, f2, {-beside, 0.5, -1}, f0, f1, f2};
    CHECK_FALSE(exact::first_touch(step));
    CHECK_FALSE(textbook_time_of_impact(step, {1e-12, 1e-9, 0}));
    CHECK(textbook_time_of_impact(step, {1e-12, 1e-6, 0}));
}
