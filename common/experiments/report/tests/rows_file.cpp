#include "common/experiments/report/report.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <csignal>

using namespace enduring;

TEST_CASE(
    "rows file: where there is no room for a row the file ends with the one before, and so does a table that grows")
{
    const TemporaryFolder folder;
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    for (rlim_t bytes = 30; bytes < 60; ++bytes) {
        CAPTURE(bytes);
        std::string complaint;
        {
            Report report(folder.path);
            const rlimit small{bytes, before.rlim_max};
            ::setrlimit(RLIMIT_FSIZE, &small);
            try {
                Table table({"run", "depth_m"});  // 12 bytes, and 12 a row
                for (long run = 10; run < 20; ++run) {
                    table.add({run, 0.123456});
                    report.rows_so_far("grown", table);
                }
            } catch (const InputError& mistake) {
                complaint = mistake.what();
            }
            ::setrlimit(RLIMIT_FSIZE, &before);
        }
        CHECK(complaint.find("grown.unfinished.csv: cannot be written to its end (File too large)") !=
              std::string::npos);
        const std::string left = content(folder.path / "grown.unfinished.csv");
        CHECK(left.size() == 12 + (bytes - 12) / 12 * 12);
        CHECK(left.back() == '\n');
    }
    std::signal(SIGXFSZ, SIG_DFL);
}
