#include "common/experiments/own_scene/own_scene.hpp"
#include "common/experiments/render/picture.hpp"
#include "common/experiments/report/pictures_wanted.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iostream>
#include <set>
#include <sstream>

using namespace enduring;

namespace {

/// A ball that nothing stops, without a camera.
std::string falling_ball(double duration)
{
    return R"({"name": "ball", "dt": 0.01, "duration": )" + std::to_string(duration) + R"(,
    "bodies": [{"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25}}, "mass": 5, "position": [0, 1, 0]}]})";
}

/// What a chapter does with its solver; this one lets everything fall.
int chapter(std::vector<std::string> words)
{
    words.insert(words.begin(), "chapter99");
    std::vector<char*> argv;
    for (std::string& word : words)
        argv.push_back(word.data());
    return run_chapter(static_cast<int>(argv.size()), argv.data(), {"99_trial", "A trial", {}},
                       [](const ContactParameters&) { return Solver("nobody", {}, {}, {}); });
}

/// The cells of a CSV file below its head, as text.
std::vector<std::vector<std::string>> rows(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<std::vector<std::string>> all;
    for (std::string line; std::getline(in, line);) {
        all.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            all.back().push_back(cell);
    }
    if (!all.empty())
        all.erase(all.begin());
    return all;
}

std::set<std::string> names_in(const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

}  // namespace

TEST_CASE(
    "own scene: a run that is killed leaves the rows of its steps so far, and says that it is not finished")
{
    const TemporaryFolder folder;
    const std::filesystem::path out = folder.path / "out", motion = out / "motion.unfinished.csv";
    write_file(folder.path / "scene.json", falling_ball(3600));
    for (const int signal : {SIGTERM, SIGKILL}) {
        CAPTURE(signal);
        std::filesystem::remove_all(out);
        const pid_t child = ::fork();
        if (child == 0) {
            std::cout.setstate(std::ios::failbit);  // what it prints is not this test's
            ::_exit(chapter({"--scene", (folder.path / "scene.json").string(), "--out", out.string()}));
        }
        const auto begin = std::chrono::steady_clock::now();
        while (rows(motion).size() < 100 &&
               std::chrono::steady_clock::now() - begin < std::chrono::seconds(60))
            ::usleep(1000);
        ::kill(child, signal);
        int status = 0;
        ::waitpid(child, &status, 0);
        REQUIRE(WIFSIGNALED(status));

        const auto fell = rows(motion);
        REQUIRE(fell.size() >= 100);
        for (int n = 0; n < 100; ++n)  // as symplectic Euler has it
            CHECK(std::stod(fell[n][3]) == doctest::Approx(1 - 9.81 * 1e-4 * n * (n + 1) / 2).epsilon(1e-12));
        CHECK(names_in(out) == std::set<std::string>{"contacts.unfinished.csv", "energy.unfinished.csv",
                                                     "motion.unfinished.csv", "penetration.unfinished.csv",
                                                     "scene.progress.txt", "steps.unfinished.csv"});
        CHECK(content(out / "scene.progress.txt").find("Not finished. scene, ") == 0);
        CHECK(rows(out / "energy.unfinished.csv").size() + 1 >= fell.size());
    }
}

TEST_CASE("own scene: without pictures there are the same tables under their names, and nothing else")
{
    const TemporaryFolder folder;
    const std::filesystem::path with = folder.path / "with", without = folder.path / "without";
    write_file(folder.path / "scene.json", falling_ball(0.1));
    std::ostringstream said;
    auto* const real_out = std::cout.rdbuf(said.rdbuf());
    auto* const real_err = std::cerr.rdbuf(said.rdbuf());
    const std::string scene = (folder.path / "scene.json").string();
    int failed = chapter({"--scene", scene, "--out", with.string()});
    std::filesystem::copy(with, without);  // old pictures, which would belie new tables
    failed += chapter({"--scene", scene, "--out", without.string(), "--no-pictures"});
    want_pictures(true);
    std::cout.rdbuf(real_out);
    std::cerr.rdbuf(real_err);
    CAPTURE(said.str());
    CHECK(failed == 0);
    CHECK(said.str().find("10 steps of 0.01 s, solver of nobody") != std::string::npos);
    const std::set<std::string> tables{"contacts.csv", "energy.csv", "motion.csv", "penetration.csv",
                                       "steps.csv"};
    CHECK(names_in(without) == tables);
    for (const std::string& name : tables)
        CHECK(content(with / name) == content(without / name));
    if (pictures_are_on)
        CHECK(std::filesystem::exists(with / "scene.png"));
}

TEST_CASE("own scene: one that asks for exact contact is refused as a mistake, and leaves no tables")
{
    const TemporaryFolder folder;
    const std::filesystem::path scene = folder.path / "scene.json", out = folder.path / "out";
    write_file(scene, "{\"contact\": {\"exact\": true}, " + falling_ball(0.1).substr(1));
    std::ostringstream said;
    auto* const real_err = std::cerr.rdbuf(said.rdbuf());
    const int code = chapter({"--scene", scene.string(), "--out", out.string()});
    std::cerr.rdbuf(real_err);
    CHECK(code == 2);
    CHECK(said.str().find("scene.json: /contact/exact: the springs of nobody give under a load") !=
          std::string::npos);
    CHECK_FALSE(std::filesystem::exists(out / "energy.csv"));
    CHECK_FALSE(std::filesystem::exists(out / "failed.txt"));
}

TEST_CASE(
    "own scene: a run that is saved and goes on writes the rows that it would have written, to the byte")
{
    const TemporaryFolder folder;
    const std::string scene = (folder.path / "scene.json").string();
    write_file(folder.path / "scene.json", falling_ball(0.2));
    std::ostringstream said;
    auto* const real_out = std::cout.rdbuf(said.rdbuf());
    auto* const real_err = std::cerr.rdbuf(said.rdbuf());
    const auto run_with = [&](std::vector<std::string> words, const std::string& out,
                              bool can_resume = true) {
        words.insert(words.begin(),
                     {"chapter99", "--no-pictures", "--scene", scene, "--out", (folder.path / out).string()});
        std::vector<char*> argv;
        for (std::string& word : words)
            argv.push_back(word.data());
        return run_chapter(static_cast<int>(argv.size()), argv.data(), {"99_trial", "A trial", {}},
                           [can_resume](const ContactParameters&) {
                               Solver solver("nobody", {}, {}, {});
                               solver.can_resume = can_resume;
                               return solver;
                           });
    };
    CHECK(run_with({"--save", "8"}, "whole") == 0);
    const std::string state = (folder.path / "whole" / "state.json").string();
    CHECK(run_with({"--resume", state}, "rest") == 0);
    CHECK(run_with({"--resume", state}, "whole") == 2);  // beside its own tables
    CHECK(run_with({"--resume", scene}, "other") == 2);
    CHECK(run_with({"--save", "0"}, "other") == 2);
    CHECK(run_with({"--save", "8"}, "other", false) == 2);
    want_pictures(true);
    std::cout.rdbuf(real_out);
    std::cerr.rdbuf(real_err);
    CAPTURE(said.str());
    CHECK(said.str().find("lies beside the tables of its run") != std::string::npos);
    CHECK(said.str().find("the solver of nobody remembers more than world and pairs hold") !=
          std::string::npos);
    for (const std::string table : {"motion.csv", "energy.csv", "contacts.csv"}) {
        CAPTURE(table);
        const auto whole = rows(folder.path / "whole" / table), rest = rows(folder.path / "rest" / table);
        REQUIRE(whole.size() == 21);
        REQUIRE(rest.size() == 5);  // saved last after 16 of 20 steps
        for (std::size_t i = 0; i < rest.size(); ++i)
            CHECK(rest[i] == whole[16 + i]);
    }
}
