#include "common/experiments/report/report.hpp"
#include "common/experiments/report/subprocess.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <stdexcept>

using namespace enduring;

namespace {

std::filesystem::path script(const TemporaryFolder& folder, const std::string& text)
{
    write_file(folder.path / "script.gp", text);
    return folder.path / "script.gp";
}

}  // namespace

TEST_CASE("plots: a script reads a table of the report and leaves an SVG without a background" *
          doctest::skip(!is_installed("gnuplot")))
{
    const TemporaryFolder folder;
    Report report(folder.path / "it's here");
    Table table({"dt_s", "radius"});
    for (const double dt : {0.1, 0.2, 0.3})
        table.add({dt, dt * dt});
    report.table("radius", table);
    report.plot(
        script(folder, "load style\nset xlabel 'dt [s]'\nplot folder.'/radius.csv' using 1:2 with lines\n"),
        "radius");
    const std::string svg = content(folder.path / "it's here" / "radius.svg");
    CHECK(svg.find("</svg>") != std::string::npos);
    CHECK(svg.find("dt [s]") != std::string::npos);
    CHECK(svg.find("<script") == std::string::npos);
    CHECK(report.written().size() == 2);
}

TEST_CASE("plots: a script that fails or draws nothing leaves no picture" *
          doctest::skip(!is_installed("gnuplot")))
{
    const TemporaryFolder folder, results;
    Report report(results.path);
    CHECK_THROWS_AS(report.plot(script(folder, "load style\nplot folder.'/missing.csv'\n"), "a"),
                    std::runtime_error);
    CHECK_THROWS_AS(report.plot(script(folder, "x = 1\n"), "a"), std::runtime_error);
    CHECK_THROWS_AS(report.plot(folder.path / "none.gp", "a"), InputError);
    CHECK(results.count() == 0);
}

TEST_CASE("plots: gnuplot has nothing to complain about where the reader's locale knows no degree sign" *
          doctest::skip(!is_installed("gnuplot")))
{
    const TemporaryFolder folder;
    const std::string said = (folder.path / "said").string();
    const char* before = std::getenv("LC_ALL");
    const std::string locale = before ? before : "";
    ::setenv("LC_ALL", "C", 1);
    Subprocess gnuplot({"sh", "-c", "gnuplot -e 'set encoding utf8' 2>'" + said + "'"}, "gnuplot-nox");
    gnuplot.finish();
    before ? ::setenv("LC_ALL", locale.c_str(), 1) : ::unsetenv("LC_ALL");
    CHECK(content(said) == "");
}

TEST_CASE("plots: without gnuplot the tables stay, an old plot does not, and the run goes on")
{
    const TemporaryFolder folder, results;
    const std::string path = std::getenv("PATH");
    write_file(results.path / "a.svg", "of an earlier run");
    Report report(results.path);
    report.table("radius", Table({"dt_s", "radius"}));
    ::setenv("PATH", folder.path.c_str(), 1);
    CHECK_NOTHROW(report.plot(script(folder, "load style\nplot folder.'/radius.csv' using 1:2\n"), "a"));
    CHECK_THROWS_AS(report.plot(folder.path / "none.gp", "a"), InputError);
    ::setenv("PATH", path.c_str(), 1);
    CHECK_FALSE(std::filesystem::exists(results.path / "a.svg"));
    CHECK(std::filesystem::exists(results.path / "radius.csv"));
}

TEST_CASE("plots: a missing program is named with the package that brings it")
{
    try {
        Subprocess missing({"no-such-program-here"}, "its-package");
        FAIL("it started");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()).find("no-such-program-here") != std::string::npos);
        CHECK(std::string(error.what()).find("apt-get install its-package") != std::string::npos);
    }
}

TEST_CASE("subprocess: a program on PATH is installed, what is none is not")
{
    const TemporaryFolder folder;
    CHECK(is_installed("sh"));
    CHECK_FALSE(is_installed("no-such-program-here"));
    const std::string path = std::getenv("PATH");
    write_file(folder.path / "sh", "not a program");
    ::setenv("PATH", folder.path.c_str(), 1);
    CHECK_FALSE(is_installed("sh"));
    ::setenv("PATH", path.c_str(), 1);
}

TEST_CASE("subprocess: all that is written arrives, and a program that stops reading is an error")
{
    const TemporaryFolder folder;
    const std::string file = (folder.path / "copy").string();
    const std::string text(300'000, 'e');
    Subprocess copy({"dd", "of=" + file, "status=none"}, "coreutils");
    copy.write(text);
    copy.finish();
    CHECK(content(file) == text);

    Subprocess closed({"true"}, "coreutils");
    CHECK_THROWS_AS(for (int i = 0; i < 1000; ++i) closed.write(text), std::runtime_error);
}
