#include "common/input/pending_file.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <csignal>

using namespace enduring;

namespace {

/// As on a full disk: no file of this process grows past `bytes` while this lives.
struct SmallDisk {
    explicit SmallDisk(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before);
        const rlimit small{bytes, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
    }
    ~SmallDisk()
    {
        ::setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, SIG_DFL);
    }
    rlimit before{};
};

}  // namespace

TEST_CASE("pending file: a write that fails half-way leaves the old file and nothing beside it")
{
    const TemporaryFolder folder;
    write_file(folder.path / "table.csv", "old\n");
    {
        const SmallDisk disk(4096);
        CHECK_THROWS_AS(write_file(folder.path / "table.csv", std::string(100'000, 'x')), InputError);
    }
    CHECK(content(folder.path / "table.csv") == "old\n");
    CHECK(folder.count() == 1);
}

TEST_CASE("pending file: until it is published a reader meets the old file")
{
    const TemporaryFolder folder;
    write_file(folder.path / "a", "old");
    PendingFile file(folder.path / "a");
    std::ofstream(file.neighbour()) << "new";
    CHECK(content(folder.path / "a") == "old");
    file.publish();
    CHECK(content(folder.path / "a") == "new");
    CHECK(folder.count() == 1);
}

TEST_CASE("pending file: Ctrl-C in the middle of a write leaves nothing behind and still ends the program")
{
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    if (child == 0) {
        PendingFile::cleaned_on_interrupt();
        const PendingFile file(folder.path / "table.csv");
        std::ofstream(file.neighbour()) << "half a tab" << std::flush;
        std::raise(SIGINT);
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGINT);
    CHECK(folder.count() == 0);
}

TEST_CASE("pending file: a place that is a folder is refused and stays as it was")
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path / "taken" / "inside");
    CHECK_THROWS_AS(write_file(folder.path / "taken", "text"), InputError);
    CHECK(folder.count() == 1);
}
