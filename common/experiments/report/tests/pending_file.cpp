#include "common/input/pending_file.hpp"
#include "common/experiments/report/report.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
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

/// How a process ends that does this, and else ends well.
template <class Work>
int status_of_child(const Work& work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        work();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

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

TEST_CASE(
    "pending file: Ctrl-C, or a terminal that is closed, in the middle of a write leaves nothing behind and still ends the program")
{
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        const TemporaryFolder folder;
        const int status = status_of_child([&] {
            std::signal(signal, SIG_DFL);
            PendingFile::cleaned_on_interrupt();
            const PendingFile file(folder.path / "table.csv");
            std::ofstream(file.neighbour()) << "half a tab" << std::flush;
            std::raise(signal);
        });
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(folder.count() == 0);
    }
}

TEST_CASE("pending file: a signal that nohup has the program ignore does not end it")
{
    const int status = status_of_child([] {
        std::signal(SIGHUP, SIG_IGN);
        PendingFile::cleaned_on_interrupt();
        std::raise(SIGHUP);
    });
    CHECK(WIFEXITED(status));
}

TEST_CASE("pending file: a place that is a folder is refused and stays as it was")
{
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path / "taken" / "inside");
    CHECK_THROWS_AS(write_file(folder.path / "taken", "text"), InputError);
    CHECK(folder.count() == 1);
}
