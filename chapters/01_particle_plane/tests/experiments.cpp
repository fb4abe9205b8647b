#include "chapters/01_particle_plane/experiments/experiments.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

using namespace enduring;

namespace {

std::vector<std::string> lines_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    return lines;
}

}  // namespace

TEST_CASE("experiments: critical_step leaves method, analytic and measured, within 1% of each other")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    chapter01::critical_step({}, report);
    const std::vector<std::string> lines = lines_of(folder.path / "critical_step.csv");
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "method,analytic,measured");
    for (std::size_t row : {1u, 2u}) {
        std::istringstream cells(lines[row]);
        std::string method, analytic, measured;
        std::getline(cells, method, ',');
        std::getline(cells, analytic, ',');
        std::getline(cells, measured, ',');
        CHECK((method == "DPF" || method == "CPF"));
        CHECK(std::stod(measured) == doctest::Approx(std::stod(analytic)).epsilon(0.01));
    }
}

TEST_CASE("experiments: on the stability map eigenvalues and simulation never disagree")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    RunOptions quick;
    quick.quick = true;
    chapter01::stability_map(quick, report);
    const std::vector<std::string> lines = lines_of(folder.path / "stability_map.csv");
    REQUIRE(lines.size() == 121);
    int settle = 0;
    for (std::size_t row = 1; row < lines.size(); ++row) {
        CAPTURE(lines[row]);
        const bool both_settle = lines[row].find(",settles,settles,") != std::string::npos;
        CHECK((both_settle || lines[row].find(",keeps bouncing,keeps bouncing,") != std::string::npos));
        settle += both_settle;
    }
    CHECK(settle > 60);
    CHECK(settle < 100);
}
