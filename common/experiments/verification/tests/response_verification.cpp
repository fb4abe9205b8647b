#include "common/experiments/verification/response_verification.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace enduring;

TEST_CASE(
    "pushed bar: the implicit response gives all of the push's turn and work, the lumped one gives less, on coarse bars most" *
    doctest::test_suite("long simulation"))
{
    const Table table = verification::pushed_bar();
    CHECK(std::get<double>(table.rows()[0][3]) < 40);  // linear elements, one cell across
    double coarser = 0;
    for (const auto& row : table.rows()) {
        const double angular = std::get<double>(row[3]), kinetic = std::get<double>(row[4]),
                     energy = std::get<double>(row[5]);
        CAPTURE(std::get<std::string>(row[0]));
        CAPTURE(std::get<std::string>(row[1]));
        CAPTURE(std::get<long>(row[2]));
        if (std::get<std::string>(row[0]) == "implicit") {
            CHECK(angular == doctest::Approx(100).epsilon(1e-6));
            CHECK(energy == doctest::Approx(100).epsilon(1e-3));
            continue;
        }
        if (std::get<long>(row[2]) == 1)
            coarser = 0;
        CHECK(angular > coarser);
        CHECK(angular < 90);
        CHECK(kinetic < 90);
        coarser = angular;
    }
}
