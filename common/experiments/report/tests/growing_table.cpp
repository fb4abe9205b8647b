#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/pending_file.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <stdexcept>

using namespace enduring;

namespace {

/// Runs in another process, which this signal ends within its work.
template <class Work>
void end_by(int signal, const Work& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        PendingFile::cleaned_on_interrupt();  // as every program of the course
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    REQUIRE(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
}

/// Of "runs: 2 of 8, about 3 s left".
int seconds_left(const std::string& line)
{
    const std::string before = "2 of 8, about ";
    const std::size_t at = line.find(before);
    REQUIRE(at != std::string::npos);
    return std::stoi(line.substr(at + before.size()));
}

}  // namespace

TEST_CASE(
    "growing table: a run that is killed leaves a header and every row that was added, and no whole table")
{
    const TemporaryFolder folder;
    write_file(folder.path / "sweep.csv", "of the run before\n");
    for (const int signal : {SIGKILL, SIGTERM}) {
        CAPTURE(signal);
        end_by(signal, [&] {
            Report report(folder.path);
            GrowingTable table(report, "sweep", {"run", "depth_m"}, 100);
            for (long run = 1; run <= 3; ++run)
                table.add({run, 0.5 * static_cast<double>(run)});
            std::raise(signal);
        });
        CHECK(content(folder.path / "sweep.unfinished.csv") == "run,depth_m\n1,0.5\n2,1\n3,1.5\n");
        CHECK(content(folder.path / "sweep.csv") == "of the run before\n");
        CHECK(folder.count() == 2);
    }
    Report report(folder.path);
    GrowingTable table(report, "sweep", {"run", "depth_m"});
    CHECK(content(folder.path / "sweep.unfinished.csv") == "run,depth_m\n");
    table.add({1L, 0.5});
    report.table("sweep", table);
    CHECK(content(folder.path / "sweep.csv") == "run,depth_m\n1,0.5\n");
    CHECK(folder.count() == 1);
}

TEST_CASE("growing table: it ends as the same bytes as a table that is written at once")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    Table whole({"who", "how, many", "x_m"});
    GrowingTable growing(report, "grown", whole.columns());
    for (long i = 0; i < 50; ++i) {
        const std::vector<Cell> row{std::string(i % 7 == 0 ? "a \"b\", c" : "d"), i,
                                    1 / (3.0 + static_cast<double>(i))};
        whole.add(row);
        growing.add(row);
    }
    CHECK(content(folder.path / "grown.unfinished.csv") == csv(whole));
    report.table("grown", growing);
    report.table("whole", whole);
    CHECK(content(folder.path / "grown.csv") == content(folder.path / "whole.csv"));
}

TEST_CASE(
    "growing table: an experiment that fails before its first row leaves nothing, one that fails later its rows")
{
    const TemporaryFolder folder;
    for (const bool with_row : {false, true}) {
        try {
            Report report(folder.path / "results");
            GrowingTable table(report, "sweep", {"run"});
            if (with_row)
                table.add({1L});
            throw std::runtime_error("step 7: NaN");
        } catch (const std::runtime_error&) {}
        CHECK(std::filesystem::exists(folder.path / "results") == with_row);
    }
    CHECK(content(folder.path / "results/sweep.unfinished.csv") == "run\n1\n");
}

TEST_CASE("progress: work in other work is told behind it, and what is left is reckoned from what was done")
{
    CHECK(progress_line().empty());
    const Progress sweep("creep");
    {
        Progress runs("runs", 8), steps("scene, chapter 7", 100, " steps");
        runs.update(2);
        steps.update(50);
        CHECK(progress_line() == "creep, 0 s; runs: 2 of 8; scene, chapter 7: 50 of 100 steps");
        ::usleep(1'050'000);
        const int alike = seconds_left(progress_line());  // two of eight parts took a second
        CHECK(alike >= 3);
        runs.update(2, 0.1);  // the first ones were the quick ones
        CHECK(seconds_left(progress_line()) >= 3 * alike - 2);
    }
    CHECK(progress_line().find("creep, ") == 0);
    CHECK(progress_line().find(';') == std::string::npos);
}

TEST_CASE("progress: durations are as rough as an estimate is")
{
    CHECK(rough_duration(0.4) == "0 s");
    CHECK(rough_duration(99) == "99 s");
    CHECK(rough_duration(100) == "2 min");
    CHECK(rough_duration(5900) == "98 min");
    CHECK(rough_duration(6000) == "1 h 40 min");
}
