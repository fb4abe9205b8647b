#include "common/experiments/own_scene/own_scene.hpp"
#include "chapters/solvers/chapter_solver.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"
#include "common/scenes/scene.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

using namespace enduring;

namespace {

/// A ball that falls 0.75 m onto the ground, from the text of the page on scenes.
const char* const ball = R"({"name": "ball", "dt": 0.01, "duration": 0.6, "contact": {"stiffness": 500},
    "planes": [{"name": "ground"}],
    "bodies": [{"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25}}, "mass": 5, "position": [0, 1, 0]}]})";

struct Outcome {
    std::string said, warned;
    std::string broke{};  ///< why, empty if it did not
};

MakeSolver solver_of(int chapter)
{
    return [chapter](const ContactParameters& parameters) {
        return solvers::chapter_solver(chapter, parameters);
    };
}

/// Runs a scene given as text, quickly, and keeps what it says.
Outcome run_own(const TemporaryFolder& folder, const std::string& text, int chapter = solvers::chapters,
                const OwnSceneOptions& choice = {})
{
    write_file(folder.path / "scene.json", text);
    RunOptions options;
    options.scene = folder.path / "scene.json";
    options.quick = true;
    Report report(folder.path / "out");
    Outcome outcome;
    std::ostringstream out, err;
    auto* const real_out = std::cout.rdbuf(out.rdbuf());
    auto* const real_err = std::cerr.rdbuf(err.rdbuf());
    try {
        own_scene(options, report, solver_of(chapter), choice);
    } catch (const std::runtime_error& failure) {
        outcome.broke = failure.what();
    }
    std::cout.rdbuf(real_out);
    std::cerr.rdbuf(real_err);
    outcome.said = out.str();
    outcome.warned = err.str();
    return outcome;
}

/// The rows of a CSV file below its head, as text.
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
    REQUIRE(!all.empty());
    all.erase(all.begin());
    return all;
}

}  // namespace

TEST_CASE("own scene: the tables hold one row a step, and the ball falls as symplectic Euler says")
{
    const TemporaryFolder folder;
    const Outcome outcome = run_own(folder, ball);
    CHECK(outcome.broke.empty());
    CHECK_FALSE(std::filesystem::exists(folder.path / "out/failed.txt"));
    CHECK(outcome.said.find("60 steps of 0.01 s, solver of chapter " + std::to_string(solvers::chapters)) !=
          std::string::npos);
    for (const char* name : {"energy.csv", "motion.csv", "penetration.csv", "contacts.csv"}) {
        CAPTURE(name);
        CHECK(rows(folder.path / "out" / name).size() == 61);
    }
    CHECK(rows(folder.path / "out/steps.csv").size() == 60);
    const auto motion = rows(folder.path / "out/motion.csv");
    const int n = 30;  // 0.3 s: still in the air
    CHECK(motion[n][1] == "ball");
    CHECK(std::stod(motion[n][3]) == doctest::Approx(1 - 9.81 * 1e-4 * n * (n + 1) / 2).epsilon(1e-12));
    CHECK(std::stod(motion[n][6]) == doctest::Approx(-9.81 * 0.01 * n).epsilon(1e-12));
    for (const char* name : {"energy.svg", "scene.png"})
        CHECK(std::filesystem::file_size(folder.path / "out" / name) > 1000);
}

TEST_CASE("own scene: the contacts' kinds add up to the pairs, and their force is what slows the ball")
{
    const TemporaryFolder folder;
    run_own(folder, ball);
    const auto contacts = rows(folder.path / "out/contacts.csv"),
               penetration = rows(folder.path / "out/penetration.csv"),
               motion = rows(folder.path / "out/motion.csv");
    int touching = 0;
    for (std::size_t i = 1; i < contacts.size(); ++i) {
        CAPTURE(i);
        long pairs = 0;
        for (std::size_t kind = 1; kind <= 7; ++kind)
            pairs += std::stol(contacts[i][kind]);
        CHECK(pairs == std::stol(penetration[i][1]));
        const double pushed = std::stod(motion[i][6]) - std::stod(motion[i - 1][6]) + 9.81 * 0.01;
        CHECK(std::stod(contacts[i][9]) == doctest::Approx(5 * pushed / 0.01).epsilon(1e-6).scale(1));
        touching += pairs > 0;
    }
    CHECK(touching > 3);
}

TEST_CASE("own scene: a run that breaks leaves what it saw until then, and a series of it")
{
    const TemporaryFolder folder;
    const std::string between_floor_and_ceiling =
        R"({"name": "trap", "dt": 0.1, "duration": 60, "contact": {"stiffness": 1e12},
        "planes": [{"name": "floor"}, {"name": "ceiling", "point": [0, 2, 0], "normal": [0, -1, 0]}],
        "bodies": [{"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25}}, "mass": 5, "position": [0, 1, 0]}]})";
    OwnSceneOptions choice;
    choice.paraview = (folder.path / "series").string();
    const Outcome outcome = run_own(folder, between_floor_and_ceiling, 6, choice);
    CHECK_FALSE(outcome.broke.empty());
    CHECK(rows(folder.path / "out/energy.csv").size() > 3);
    CHECK(rows(folder.path / "out/energy.csv").size() < 601);
    CHECK(std::filesystem::exists(folder.path / "series/surfaces.pvd"));
}

TEST_CASE(
    "own scene: ten cubes on springs too stiff for the step are warned of, end with a sentence, and leave their tables and a note")
{
    const TemporaryFolder folder;
    std::string cubes;
    for (int i = 0; i < 10; ++i)
        cubes += (i ? ", " : "") + (R"({"name": "cube )" + std::to_string(i)) +
                 R"(", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}}, "mass": 10, "position": [)" +
                 std::to_string(0.07 * (i % 2)) + ", " + std::to_string(0.5 + 1.001 * i) + ", " +
                 std::to_string(0.05 * (i % 3)) + "]}";
    const auto stack = [&](const std::string& stiffness, const std::string& dt) {
        return R"({"name": "stack", "dt": )" + dt + R"(, "duration": 0.5, "contact": {"stiffness": )" +
               stiffness + R"(}, "planes": [{"name": "ground"}], "bodies": [)" + cubes + "]}";
    };
    constexpr int with_given_stiffness = 6;
    const Outcome stiff = run_own(folder, stack("30000", "0.01"), with_given_stiffness);
    CAPTURE(stiff.broke);
    CHECK(stiff.warned.find("/contact/stiffness: too stiff for the step where 'cube 0' meets 'cube 1'") !=
          std::string::npos);
    for (const char* part : {"stack, chapter 6: step ", "energy out of nothing",
                             " pairs, n k = ", "stable up to dt = ", "Make dt shorter"})
        CHECK(stiff.broke.find(part) != std::string::npos);
    std::ifstream note(folder.path / "out/failed.txt");
    std::string why;
    std::getline(note, why);
    CHECK(why == stiff.broke);
    const auto energy = rows(folder.path / "out/energy.csv");
    CHECK(energy.size() > 2);
    CHECK(energy.size() < 51);
    // the step that broke it is in them
    CHECK(stiff.broke.find("step " + std::to_string(energy.size() - 1) + ",") != std::string::npos);
    CHECK(std::abs(std::stod(energy.back()[4])) < 1e6);  // ended long before 10^12 J

    const Outcome calm = run_own(folder, stack("30000", "0.002"), with_given_stiffness);
    CAPTURE(calm.broke);
    CHECK(calm.broke.empty());
    CHECK(calm.warned.find("warning") == std::string::npos);
    // the note of the run before is gone
    CHECK_FALSE(std::filesystem::exists(folder.path / "out/failed.txt"));

    // a solver that finds the stiffness does not read the scene's
    CHECK(run_own(folder, stack("1e12", "0.01")).broke.empty());
}

TEST_CASE("own scene: a cube that begins inside a meshed floor is warned of, with both names and the depth")
{
    const TemporaryFolder folder;
    for (const auto& [name, floor] :
         {std::pair<std::string, std::string>{
              "floor", R"("box": {"size": [10, 1, 10], "cells": [5, 1, 5]}}, "position": [0, -0.5, 0])"},
          std::pair<std::string, std::string>{"sheet",
                                              R"("plane_grid": {"size": [10, 10], "cells": [5, 5]}})"}}) {
        const Outcome outcome = run_own(
            folder,
            R"({"name": "sunk", "dt": 0.01, "duration": 0.1, "contact": {"stiffness": 100000}, "bodies": [
            {"name": ")" +
                name + R"(", "type": "static", "shape": {)" + floor +
                R"(}, {"name": "cube", "type": "rigid", "shape": {"box": {"size": [1, 1, 1]}},
             "mass": 1000, "position": [0, 0.49, 0]}]})");
        CHECK(outcome.warned.find("'cube' begins inside '" + name + "', 0.01 m deep") != std::string::npos);
    }
}

TEST_CASE("own scene: every chapter has a solver to choose")
{
    for (int chapter = 1; chapter <= solvers::last_chapter; ++chapter)
        CHECK(solvers::chapter_solver(chapter, {}).name == "chapter " + std::to_string(chapter));
    CHECK_THROWS_WITH_AS(solvers::chapter_solver(13, {}), "chapter 13 has no solver; 1 to 12 have",
                         InputError);
}
