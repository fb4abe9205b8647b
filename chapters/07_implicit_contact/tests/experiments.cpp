#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/levers.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

using namespace enduring;

namespace {

std::string content_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("experiments: on the implicit map every drop settles whose weight does not look back")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    RunOptions quick;
    quick.quick = true;
    chapter07::implicit_map(quick, report);
    const std::string facts = content_of(folder.path / "facts_implicit_map.csv");
    CHECK(facts.find("drops,100,") != std::string::npos);
    CHECK(facts.find("settled,100,") != std::string::npos);
}

TEST_CASE("levers: the vertex that carries a rolling wheel is under the centre at the end of the step only")
{
    constexpr double radius = 0.1, spin = 20;
    for (const double dt : {1.0 / 60, 1.0 / 240})
        for (const double tau : {0.0, 0.5, 1.0}) {
            CAPTURE(dt);
            CAPTURE(tau);
            const double ahead = (1 - tau) * radius * std::sin(spin * dt);
            CHECK(std::abs(chapter07::mean_ahead(tau, dt) - ahead) < 1e-3 * radius);
        }
}
