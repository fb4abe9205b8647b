#include "common/input/input_error.hpp"
#include "common/scenes/tests/small_scenes.hpp"
#include "common/simulation/deformable_body.hpp"

#include <doctest/doctest.h>

using namespace enduring;
using namespace enduring::tests;

namespace {

std::string jelly_complaint(const std::string& patch)
{
    return complaint_of([&] { jelly(patch); });
}

}  // namespace

TEST_CASE("scene: a deformable body has the material, basis, motion and supports of the file")
{
    const Scene scene = jelly(
        R"({"/bodies/bar": {"density": null, "mass": 30, "young": 2e5, "poisson": 0.4, "basis": "quadratic",
        "rayleigh": {"mass": 0.5, "stiffness": 0.01}, "fixed": {"max": [-0.5, 9, 9]}, "velocity": [0, 1, 0]}})");
    const auto& body = dynamic_cast<const DeformableBody&>(*scene.world.bodies[0]);
    CHECK(body.mass() == doctest::Approx(30));
    CHECK(body.elastic().material().density == doctest::Approx(120));
    CHECK(body.elastic().material().young == 2e5);
    CHECK(body.elastic().material().poisson == 0.4);
    CHECK(body.elastic().material().mass_damping == 0.5);
    CHECK(body.elastic().material().stiffness_damping == 0.01);
    CHECK(body.elastic().mesh().basis() == Basis::quadratic);
    int fixed = 0;
    for (Eigen::Index node = 0; node < body.elastic().positions().cols(); ++node) {
        const bool at_end = body.elastic().mesh().rest()(0, node) < -0.4999;
        CHECK((body.elastic().inverse_masses()[node] == 0) == at_end);
        fixed += at_end;
    }
    CHECK(fixed == 9);  // four corners, four edges, one diagonal of the end
    CHECK(jelly("").world.bodies[0]->mass() == doctest::Approx(100));
    const auto basis_of = [](const std::string& patch) {
        return dynamic_cast<const DeformableBody&>(*jelly(patch).world.bodies[0]).elastic().mesh().basis();
    };
    CHECK(basis_of("") == Basis::quadratic);
    CHECK(basis_of(R"({"/bodies/bar/basis": "linear"})") == Basis::linear);
    const auto law_of = [](const std::string& patch) {
        return dynamic_cast<const DeformableBody&>(*jelly(patch).world.bodies[0]).elastic().material().law;
    };
    CHECK(law_of("") == ElasticLaw::corotated);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "corotated"})") == ElasticLaw::corotated);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "corotated_at_points"})") == ElasticLaw::corotated_at_points);
    CHECK(law_of(R"({"/bodies/bar/elasticity": "neo_hookean"})") == ElasticLaw::neo_hookean);
    CHECK(jelly(R"({"/bodies/bar/shape/scale": 2})").world.bodies[0]->mass() == doctest::Approx(800));
}

TEST_CASE("scene: elastic constants out of range are named with path, range and value")
{
    CHECK(jelly_complaint(R"({"/bodies/0/young": 0})") ==
          "jelly.json: /bodies/0/young: expected a number from 0.001 to 1e+13 [Pa], found 0");
    CHECK(jelly_complaint(R"({"/bodies/0/poisson": 0.5})") ==
          "jelly.json: /bodies/0/poisson: expected a number from -0.99 to 0.4999, found 0.5");
    CHECK(jelly_complaint(R"({"/bodies/0/poisson": -1})") ==
          "jelly.json: /bodies/0/poisson: expected a number from -0.99 to 0.4999, found -1");
    CHECK(jelly_complaint(R"({"/bodies/0/density": 0})") ==
          "jelly.json: /bodies/0/density: expected a number from 0.001 to 1e+06 [kg/m^3], found 0");
    CHECK(jelly_complaint(R"({"/bodies/0/rayleigh": {"mass": -1}})") ==
          "jelly.json: /bodies/0/rayleigh/mass: expected a number from 0 to 1e+06 [1/s], found -1");
    CHECK(jelly_complaint(R"({"/bodies/0": {"young": null}})") ==
          "jelly.json: /bodies/0: the key \"young\" is missing");
    CHECK(jelly_complaint(R"({"/bodies/0/elasticity": "rubber"})").find("/bodies/0/elasticity") !=
          std::string::npos);
    CHECK(jelly_complaint(R"({"/bodies/0/basis": "cubic"})") ==
          "jelly.json: /bodies/0/basis: expected one of \"linear\", \"quadratic\", found \"cubic\"");
    CHECK(jelly_complaint(R"({"/bodies/0/fixed": {"min": [7, 0, 0]}})") ==
          "jelly.json: /bodies/0/fixed: no node of the shape lies in this region");
    CHECK(jelly_complaint(R"({"/bodies/0/shape": {"bar": null, "sphere": {"radius": 1}}})")
              .find("jelly.json: /bodies/0/shape: expected a shape made of tetrahedra") == 0);
    CHECK(jelly_complaint(R"({"/bodies/0/shape/bar/cells": [100, 100, 100]})") ==
          "jelly.json: /bodies/0/shape/bar: asks for 5000000 elements; at most 300000 are allowed");
}
