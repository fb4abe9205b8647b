#include "chapters/11_exact_contact/experiments/experiments.hpp"
#include "chapters/11_exact_contact/experiments/solver_outcomes.hpp"
#include "chapters/11_exact_contact/problem_of_step.hpp"
#include "chapters/11_exact_contact/tests/one_block.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"
#include "common/input/json_document.hpp"

#include <doctest/doctest.h>

using namespace enduring;

TEST_CASE(
    "scoreboard: a folder without a problem that can be read is refused, and leaves no table of an earlier run")
{
    const TemporaryFolder problems, results;
    write_file(problems.path / "broken.dat", "3\n1\n0\n");
    write_file(results.path / "yours.csv", "problem\nof an earlier run\n");
    write_file(results.path / "yours_profile.csv", "time_over_best\n1\n");
    Report report(results.path);
    CHECK_THROWS_WITH_AS(chapter11::scoreboard({}, report, problems.path),
                         doctest::Contains("has no problem that can be read"), InputError);
    CHECK_FALSE(std::filesystem::exists(results.path / "yours.csv"));
    CHECK_FALSE(std::filesystem::exists(results.path / "yours_profile.csv"));
}

TEST_CASE("scoreboard: a file that cannot be read has a row with the reason, beside those that are solved")
{
    const TemporaryFolder problems, results;
    write_file(problems.path / "broken.dat", "3\n1\n0\n");
    write_file(problems.path / "slides.dat", siconos_text(hand_solved_blocks()[1].problem));
    Report report(results.path);
    chapter11::scoreboard({}, report, problems.path);
    const std::string table = read_text_file(results.path / "yours.csv");
    CHECK(table.find("slides.dat,1,") != std::string::npos);
    CHECK(table.find("broken.dat") != std::string::npos);
    CHECK(table.find("broken.dat:3: ") != std::string::npos);
}

TEST_CASE(
    "scoreboard: where nothing is solved the run ends with an error, and the table says how far each one came")
{
    const TemporaryFolder problems, results;
    FrictionProblem impossible = hand_solved_blocks()[0].problem;
    impossible.response.setZero();  // it comes in, and nothing moves it
    impossible.response.makeCompressed();
    write_file(problems.path / "impossible.dat", siconos_text(impossible));
    Report report(results.path);
    CHECK_THROWS_WITH_AS(chapter11::scoreboard({}, report, problems.path),
                         doctest::Contains("none of its problems was solved"), InputError);
    CHECK(read_text_file(results.path / "yours.csv").find("impossible.dat") != std::string::npos);
}

TEST_CASE(
    "scoreboard: a file of yours has no result of another one that was measured elsewhere under its name")
{
    const TemporaryFolder problems, results;
    write_file(problems.path / "Rover1039.dat", siconos_text(hand_solved_blocks()[1].problem));
    Report report(results.path);
    chapter11::scoreboard({}, report, problems.path);
    CHECK(read_text_file(results.path / "yours.csv").find("1.54603e-10") == std::string::npos);
}

TEST_CASE(
    "score sets: a row tells how many problems of a set are solved, and a dash where there is nothing to compare")
{
    std::vector<chapter11::NamedProblem> blocks;
    for (const HandSolved& block : hand_solved_blocks())
        blocks.push_back({block.name, block.problem});
    FrictionProblem impossible = blocks[0].problem;
    impossible.response.setZero();  // it comes in, and nothing moves it
    impossible.response.makeCompressed();
    std::vector<chapter11::NamedProblem> with_impossible = blocks;
    with_impossible.push_back({"impossible", impossible});
    const Table table = chapter11::scores_of({{"blocks", blocks}, {"more", with_impossible}});
    REQUIRE(table.rows().size() == 2);
    const auto count = static_cast<long>(blocks.size());
    CHECK(table.rows()[0][1] == Cell(count));
    CHECK(table.rows()[0][2] == Cell(count));
    CHECK(table.rows()[1][1] == Cell(count + 1));
    CHECK(table.rows()[1][2] == Cell(count));
    CHECK(table.rows()[0].back() == Cell("–"));  // none has 20 contacts
}
