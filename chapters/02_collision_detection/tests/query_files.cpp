#include "chapters/02_collision_detection/query_files.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "common/experiments/report/report.hpp"
#include "common/input/input_error.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>
#include <boost/multiprecision/cpp_int.hpp>

#include <iostream>
#include <limits>
#include <sstream>

using namespace enduring;

namespace {

std::string lines(int count, const std::string& line)
{
    std::string text;
    for (int i = 0; i < count; ++i)
        text += line + "\n";
    return text;
}

std::vector<FileQuery> read(const std::string& text)
{
    std::istringstream stream(text);
    return read_queries(stream, "queries.csv");
}

std::string mistake_in(const std::string& text)
{
    try {
        read(text);
    } catch (const InputError& mistake) {
        return mistake.what();
    }
    return "";
}

const std::string good = "1,2,-3,4,0,1";

/// Exit code and output of the program, as the command line gives it.
struct Outcome {
    int code;
    std::string out, err;
};

Outcome run(const std::vector<std::string>& words)
{
    chapter02::QueryMode queries;
    std::vector<std::string> arguments{"chapter02"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    std::vector<char*> pointers;
    for (std::string& argument : arguments)
        pointers.push_back(argument.data());
    std::ostringstream out, err;
    std::streambuf* const old_out = std::cout.rdbuf(out.rdbuf());
    std::streambuf* const old_err = std::cerr.rdbuf(err.rdbuf());
    const int code = run_chapter(
        static_cast<int>(pointers.size()), pointers.data(),
        {.folder = "02_collision_detection",
         .title = "",
         .experiments = {},
         .add_options = [&](CLI::App& app) { queries.add_options(app); },
         .instead_of_experiments = [&](const RunOptions&) { return queries.run(); }});
    std::cout.rdbuf(old_out);
    std::cerr.rdbuf(old_err);
    return {code, out.str(), err.str()};
}

const std::string data = (source_directory() / "chapters/02_collision_detection/data/").string();

}  // namespace

TEST_CASE("query files: eight lines make a query, with or without an answer")
{
    const auto queries = read(lines(8, good) + "\n" + lines(8, good + ",1") + lines(8, good + ",0\r"));
    REQUIRE(queries.size() == 3);
    CHECK(queries[0].points[7] == Vec3(0.5, -0.75, 0));
    CHECK_FALSE(queries[0].collides);
    CHECK(queries[1].collides == true);
    CHECK(queries[2].collides == false);
}

TEST_CASE("query files: integers of any length give the double they stand for")
{
    const std::string zeros(40, '0'), smallest = (boost::multiprecision::cpp_int(1) << 1074).str();
    const auto queries = read(
        lines(8, "-1" + zeros + ",2" + zeros + ",1," + smallest + ",3602879701896397,36028797018963968"));
    REQUIRE(queries.size() == 1);
    CHECK(queries[0].points[0] == Vec3(-0.5, std::numeric_limits<double>::denorm_min(), 0.1));
}

TEST_CASE("query files: a mistake is told with file and line")
{
    CHECK(mistake_in("").find("queries.csv") == 0);
    CHECK(
        mistake_in(lines(3, good) + "1,2,3\n") ==
        "queries.csv:4: expected num,den for x, y and z, and at most an answer: 6 or 7 fields, but there are 3");
    CHECK(mistake_in(lines(9, good)).find("queries.csv:9: the file ends inside a query") == 0);
    CHECK(mistake_in("1,2,0.5,1,0,1\n").find("queries.csv:1: ") == 0);
    CHECK(mistake_in("1,2,0.5,1,0,1\n").find("not an integer") != std::string::npos);
    CHECK(mistake_in("1,2,,1,0,1\n").find("not an integer") != std::string::npos);
    CHECK(mistake_in("1,0,1,1,0,1\n").find("queries.csv:1: a denominator is 0") == 0);
    CHECK(mistake_in("1,3,1,1,0,1\n").find("is not a double") != std::string::npos);
    CHECK(mistake_in("1" + std::string(400, '0') + ",1,1,1,0,1\n").find("is not a double") !=
          std::string::npos);
    CHECK(mistake_in("1,1,1,1,0,1,2\n").find("queries.csv:1: the answer must be 0 or 1") == 0);
    CHECK(
        mistake_in(lines(1, good + ",1") + lines(7, good + ",0")).find("queries.csv:2: the answer differs") ==
        0);
}

TEST_CASE("query files: the program answers each query with one line")
{
    const Outcome outcome = run({"--queries", data + "time_boundary_vf.csv", "--kind", "vf"});
    CHECK(outcome.code == 0);
    std::istringstream answers(outcome.out);
    std::string line;
    for (const FileQuery& query : read_queries(data + "time_boundary_vf.csv")) {
        REQUIRE(std::getline(answers, line));
        CHECK(line.substr(0, 1) == (query.collides.value() ? "1" : "0"));
        if (*query.collides) {
            const double time = std::stod(line.substr(2));
            CHECK(time >= 0);
            CHECK(time <= 1);
        }
    }
    CHECK_FALSE(std::getline(answers, line));
}

TEST_CASE("query files: what the user gave wrong ends the program with 2 and a reason")
{
    CHECK(run({"--queries", "no/such.csv", "--kind", "vf"}).code == 2);
    CHECK(run({"--queries", "no/such.csv", "--kind", "vf"}).err.find("no/such.csv: no such file") !=
          std::string::npos);
    CHECK(run({"--queries", data + "random_vf.csv"}).code == 2);
    CHECK(run({"--queries", data + "random_vf.csv", "--kind", "vv"})
              .err.find("--kind must be vf or ee, not 'vv'") != std::string::npos);
    CHECK(run({"--kind", "vf"}).code == 2);
    CHECK(run({"--queries", (source_directory() / "README.md").string(), "--kind", "vf"}).code == 2);
}
