#include "chapters/11_exact_contact/experiments/experiments.hpp"
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

TEST_CASE("score sets: each set has a row, with what our solver solves of it")
{
    const TemporaryFolder problems, results;
    for (const int block : {0, 1})
        write_file(problems.path / (std::to_string(block) + ".dat"),
                   siconos_text(hand_solved_blocks()[static_cast<std::size_t>(block)].problem));
    Report report(results.path);
    RunOptions options;
    options.quick = true;
    chapter11::score_sets(options, report, problems.path, 1);
    const std::string table = read_text_file(results.path / "score_sets.csv");
    CHECK(table.find("\nyours,2,2,") != std::string::npos);
    for (const char* set : {"\npublic,", "\nour_scenes,", "\nrules_tried,", "\nrules_held_out,"})
        CHECK(table.find(set) != std::string::npos);
}
