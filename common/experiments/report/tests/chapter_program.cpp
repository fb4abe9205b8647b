#include "common/experiments/report/chapter_program.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <thread>

using namespace enduring;

namespace {

struct Outcome {
    int code = -1;
    std::string out, err;
};

/// Calls a program as a shell would, and keeps what it says.
Outcome call(std::vector<std::string> words, const ChapterProgram& program)
{
    words.insert(words.begin(), "chapter99");
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    std::ostringstream out, err;
    auto* const real_out = std::cout.rdbuf(out.rdbuf());
    auto* const real_err = std::cerr.rdbuf(err.rdbuf());
    const int code = run_chapter(static_cast<int>(argv.size()), argv.data(), program);
    std::cout.rdbuf(real_out);
    std::cerr.rdbuf(real_err);
    return {code, out.str(), err.str()};
}

ChapterProgram two_experiments()
{
    const auto write_name = [](const std::string& name) {
        return [name](const RunOptions& options, Report& report) {
            Table table({"quick", "scene"});
            table.add({static_cast<long>(options.quick), options.scene.value_or("none").string()});
            report.table(name, table);
        };
    };
    const auto refuse = [](const RunOptions&, Report&) {
        throw InputError("ball.obj:3: expected three numbers");
    };
    const auto fail = [](const RunOptions&, Report&) { throw std::runtime_error("step 7: NaN"); };
    return {"99_trial",
            "A trial",
            {{"drop", "a ball falls", write_name("drop")},
             {"roll", "a ball rolls", write_name("roll"), takes_scene},
             {"refuse", "meets a bad file", refuse},
             {"fail", "ends in a NaN", fail}}};
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("chapter program: named experiments run, others do not, and the progress says what was written")
{
    const TemporaryFolder folder;
    const Outcome outcome = call({"roll", "--quick", "--scene", "s.json", "--out", folder.path.string()},
                                 two_experiments());
    CHECK(outcome.code == 0);
    CHECK(content(folder.path / "roll.csv") == "quick,scene\n1,s.json\n");
    CHECK(folder.count() == 1);
    CHECK(contains(outcome.out, "roll.csv"));
    CHECK(outcome.err.empty());
}

TEST_CASE(
    "chapter program: an unknown experiment or option prints the usage and ends with 2 before anything runs")
{
    const TemporaryFolder folder;
    for (const std::string word : {"rol", "--fast"}) {
        CAPTURE(word);
        const Outcome outcome = call({"drop", word, "--out", folder.path.string()}, two_experiments());
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, word));
        CHECK(contains(outcome.err, "--out"));
        CHECK(contains(outcome.err, "a ball rolls"));
        CHECK(folder.count() == 0);
    }
}

TEST_CASE("chapter program: bad input ends with 2, a failed run with 1, both with their message")
{
    const TemporaryFolder folder;
    const Outcome refused = call({"refuse", "--out", folder.path.string()}, two_experiments());
    CHECK(refused.code == 2);
    CHECK(contains(refused.err, "ball.obj:3: expected three numbers"));
    const Outcome failed = call({"fail", "--out", folder.path.string()}, two_experiments());
    CHECK(failed.code == 1);
    CHECK(contains(failed.err, "step 7: NaN"));
}

TEST_CASE("chapter program: an --out that cannot be written ends with 2 and names it")
{
    const TemporaryFolder folder;
    write_file(folder.path / "file", "kept");
    const std::string out = (folder.path / "file").string();
    const Outcome outcome = call({"drop", "--out", out}, two_experiments());
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, out));
    CHECK(content(out) == "kept");
}

TEST_CASE("chapter program: --list names every experiment, one a line, and runs none")
{
    const Outcome outcome = call({"--list", "--out", "/proc/nowhere"}, two_experiments());
    CHECK(outcome.code == 0);
    CHECK(outcome.out ==
          "  drop    a ball falls\n  roll    a ball rolls\n"
          "  refuse  meets a bad file\n  fail    ends in a NaN\n");
}

TEST_CASE("chapter program: a chapter's own option can replace the experiments")
{
    ChapterProgram program = two_experiments();
    std::string queries;
    program.add_options = [&](CLI::App& app) { app.add_option("--queries", queries); };
    program.instead_of_experiments = [&](const RunOptions&) { return !queries.empty(); };
    const TemporaryFolder folder;
    CHECK(call({"--queries", "q.csv", "--out", folder.path.string()}, program).code == 0);
    CHECK(queries == "q.csv");
    CHECK(folder.count() == 0);
}

TEST_CASE(
    "chapter program: --scene without a word is a scene of one's own, with a word that experiment's scene")
{
    ChapterProgram program = two_experiments();
    std::filesystem::path ran, into;
    program.own_scene = [&](const RunOptions& options, Report& report) {
        ran = options.scene.value(), into = report.folder();
    };
    const TemporaryFolder folder;
    const std::string out = folder.path.string();

    CHECK(call({"--scene", "some/jelly.json", "--out", out}, program).code == 0);
    CHECK(ran == "some/jelly.json");
    CHECK(into == folder.path);
    CHECK(folder.count() == 0);  // no experiment ran

    ran.clear();
    CHECK(call({"roll", "--scene", "s.json", "--out", out}, program).code == 0);
    CHECK(ran.empty());
    CHECK(content(folder.path / "roll.csv") == "quick,scene\n0,s.json\n");

    CHECK(call({"drop", "--out", out}, program).code == 0);
    CHECK(ran.empty());
}

TEST_CASE("chapter program: a part of an experiment that has none, or a part that is none, ends with 2")
{
    const TemporaryFolder folder, parts;
    const std::vector<std::string> words{
        "drop", "--out", folder.path.string(), "--parts", parts.path.string(), "--part"};
    for (const auto& [part, says] : {std::pair{"1/2", "drop has no parts"}, std::pair{"3/2", "--part 3/2"}}) {
        std::vector<std::string> with_part = words;
        with_part.emplace_back(part);
        const Outcome outcome = call(with_part, two_experiments());
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, says));
    }
    CHECK(call({"drop", "--part", "1/2"}, two_experiments()).code == 2);
}

TEST_CASE("chapter program: a scene for what reads none ends with 2, names what does, and nothing runs")
{
    const TemporaryFolder folder;
    const std::string out = folder.path.string();
    ChapterProgram program = two_experiments();
    for (const bool own : {false, true}) {
        CAPTURE(own);
        if (own)
            program.own_scene = [](const RunOptions&, Report&) {};
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"drop"}, {"roll", "drop"}, {"fail"}}) {
            std::vector<std::string> line = words;
            line.insert(line.end(), {"--scene", "s.json", "--out", out});
            const Outcome outcome = call(line, program);
            CHECK(outcome.code == 2);
            CHECK(contains(outcome.err, "'" + words.back() + "' reads no scene file; these do: roll"));
            CHECK(contains(outcome.err, "Without an experiment named, the scene itself is run") == own);
        }
    }
    program.own_scene = {};
    const Outcome unnamed = call({"--scene", "s.json", "--out", out}, program);
    CHECK(unnamed.code == 2);
    CHECK(contains(unnamed.err, "name the experiment that reads it. These do: roll"));
    CHECK(folder.count() == 0);
}

TEST_CASE("chapter program: an experiment says how far it is in a file, which is gone when it ends")
{
    const TemporaryFolder folder;
    std::string told;
    ChapterProgram program = two_experiments();
    program.experiments = {{"sweep", "many runs", [&](const RunOptions&, Report& report) {
                                GrowingTable table(report, "sweep", {"run"}, 3);
                                for (const long run : {1, 2}) {
                                    table.add({run});
                                    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
                                    told += content(report.folder() / "sweep.progress.txt");
                                }
                                report.table("sweep", table);
                            }}};
    CHECK(call({"--out", folder.path.string()}, program).code == 0);
    CAPTURE(told);
    CHECK(contains(told, "Not finished. sweep, "));
    for (const std::string row : {"1", "2"})
        CHECK(contains(told, " s; " + row + " of 3 rows of sweep"));
    CHECK(contains(told, " rows of sweep, about "));  // once a row has taken a time that a clock can tell
    CHECK(content(folder.path / "sweep.csv") == "run\n1\n2\n");
    CHECK(folder.count() == 1);
}

TEST_CASE("chapter program: without pictures an experiment leaves no plot, and an old one goes")
{
    const TemporaryFolder folder;
    ChapterProgram program = two_experiments();
    program.experiments = {{"plot", "draws", [](const RunOptions& options, Report& report) {
                                CHECK_FALSE(options.pictures);
                                report.plot("chapters/04_friction/plots/slope.gp");
                            }}};
    write_file(folder.path / "slope.svg", "old");
    CHECK(call({"--no-pictures", "--out", folder.path.string()}, program).code == 0);
    CHECK(folder.count() == 0);
    program.experiments[0].run = [](const RunOptions& options, Report&) { CHECK(options.pictures); };
    CHECK(call({"--out", folder.path.string()}, program).code == 0);
}
