#include "common/geometry/tests/complaint.hpp"
#include "common/scenes/scene_reader.hpp"

#include <doctest/doctest.h>

using namespace enduring;

namespace {

FrictionParameters friction(const std::string& object)
{
    const std::string text =
        R"({"name": "s", "dt": 0.1, "duration": 1, "contact": {"stiffness": 5000, "friction": )" + object +
        R"(},
                                 "bodies": [{"name": "b", "type": "static", "shape": {"tetrahedron": {"edge": 1}}}]})";
    return read_scene(text, "", "s.json", {}).contact.friction;
}

std::string complaint(const std::string& object)
{
    return complaint_of([&] { friction(object); });
}

}  // namespace

TEST_CASE("scene: friction arrives as the file says it")
{
    const auto printed = std::get<YamaneNakamura>(friction(
        R"({"model": "yamane_nakamura", "mu_s": 0.4, "mu_d": 0.1, "spring": 7, "damper": 8, "weighting": 9})"));
    CHECK(printed.mu_s == 0.4);
    CHECK(printed.mu_d == 0.1);
    CHECK(printed.spring == 7);
    CHECK(printed.damper == 8);
    CHECK(printed.weighting == 9);
    CHECK(std::get<MassSplitting>(friction(R"({"model": "mass_splitting", "damping_ratio": 3})"))
              .damping_ratio == 3);
    CHECK(std::holds_alternative<NoFriction>(
        friction(R"({"model": "none", "damper": 3, "damping_ratio": 2})")));
}

TEST_CASE("scene: what friction leaves out depends on its model")
{
    const auto printed = std::get<YamaneNakamura>(friction(R"({"model": "yamane_nakamura"})"));
    const auto mass_splitting = std::get<MassSplitting>(friction(R"({"model": "mass_splitting"})"));
    CHECK(printed.spring == 100);
    CHECK(printed.damper == 25);
    CHECK(printed.weighting == 10000);
    CHECK(mass_splitting.spring == 5000);
    CHECK(mass_splitting.damping_ratio == 20);
    CHECK(mass_splitting.weighting == 20);
    CHECK((printed.mu_s == 0.5 && printed.mu_d == 0.3));
    CHECK((mass_splitting.mu_s == 0.5 && mass_splitting.mu_d == 0.3));
    CHECK(std::get<MassSplitting>(friction(R"({"model": "mass_splitting", "mu_s": 0.2})")).mu_d == 0.2);
}

TEST_CASE("scene: mistakes of friction are named with path, range and value")
{
    const std::string at = "s.json: /contact/friction";
    CHECK(complaint("{}") == at + ": the key \"model\" is missing");
    CHECK(complaint("0.3").find(at + ": expected an object") == 0);
    CHECK(complaint(R"({"model": "coulomb"})") ==
          at +
              "/model: expected one of \"none\", \"yamane_nakamura\", \"mass_splitting\", found \"coulomb\"");
    CHECK(complaint(R"({"model": "mass_splitting", "mu_s": -0.1})") ==
          at + "/mu_s: expected a number from 0 to 10, found -0.1");
    CHECK(complaint(R"({"model": "mass_splitting", "mu_d": 11})") ==
          at + "/mu_d: expected a number from 0 to 10, found 11");
    CHECK(complaint(R"({"model": "mass_splitting", "mu_s": 0.1, "mu_d": 0.2})")
              .find(at + ": \"mu_d\" is above \"mu_s\"") == 0);
    CHECK(complaint(R"({"model": "mass_splitting", "spring": 0})") ==
          at + "/spring: expected a number above 0 up to 1e+12 [N/m], found 0");
    CHECK(complaint(R"({"model": "yamane_nakamura", "damper": -1})") ==
          at + "/damper: expected a number from 0 to 1e+12 [N s/m], found -1");
    CHECK(complaint(R"({"model": "mass_splitting", "weighting": 0})") ==
          at + "/weighting: expected a number above 0 up to 1e+09 [s/m], found 0");
    CHECK(complaint(R"({"model": "mass_splitting", "damper": 5})")
              .find(at + "/damper: the model \"mass_splitting\" knows no \"damper\"") == 0);
    CHECK(complaint(R"({"model": "none", "damper": -1})") ==
          at + "/damper: expected a number from 0 to 1e+12 [N s/m], found -1");
    CHECK(complaint(R"({"model": "yamane_nakamura", "damping_ratio": 5})").find(at + "/damping_ratio: ") ==
          0);
    CHECK(complaint(R"({"model": "mass_splitting", "nu_s": 5})")
              .find(at + "/nu_s: unknown key; did you mean \"mu_s\"?") == 0);
}
