#include "chapters/07_implicit_contact/threads.hpp"
#include "common/input/input_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace enduring;

namespace {

/// The environment's number of threads, until this goes.
class WishedThreads {
public:
    explicit WishedThreads(const char* wish)
    {
        if (const char* before = std::getenv("ENDURING_THREADS"))
            before_ = before;
        setenv("ENDURING_THREADS", wish, 1);
    }
    ~WishedThreads()
    {
        if (before_)
            setenv("ENDURING_THREADS", before_->c_str(), 1);
        else
            unsetenv("ENDURING_THREADS");
    }
    WishedThreads(const WishedThreads&) = delete;
    WishedThreads& operator=(const WishedThreads&) = delete;

private:
    std::optional<std::string> before_;
};

/// That this program has.
long threads_now()
{
    const std::filesystem::directory_iterator tasks("/proc/self/task");
    return static_cast<long>(std::distance(begin(tasks), end(tasks)));
}

}  // namespace

TEST_CASE("threads: many short calls leave no more of them than were asked for")
{
    const long at_first = threads_now();  // tests before have some
    for (int i = 0; i < 300; ++i)
        for_each_index(2, 2, [](std::size_t) {});
    CHECK(threads_now() <= at_first + std::max(2, allowed_threads()));
}

TEST_CASE("threads: the environment's number is taken, and what is none is named")
{
    {
        const WishedThreads one("1");
        CHECK(allowed_threads() == 1);
        const WishedThreads most("1024");
        CHECK_NOTHROW(allowed_threads());
    }
    for (const char* wrong : {"", "0", "-1", "two", "2.5", "3 ", "1025", "99999999999999999999"}) {
        const WishedThreads wish(wrong);
        CHECK_THROWS_WITH_AS(
            allowed_threads(),
            ("ENDURING_THREADS is \"" + std::string(wrong) + "\"; it has to be a whole number from 1 to 1024")
                .c_str(),
            InputError);
    }
}

TEST_CASE("threads: each index is worked on once, and an exception comes out")
{
    for (const int threads : {4, 2, 1})  // the first decides how many there are at most
        for (const std::size_t count : {0u, 1u, 2u, 100u}) {
            std::vector<int> calls(count, 0);
            for_each_index(count, threads, [&](std::size_t i) { ++calls[i]; });
            CHECK(calls == std::vector<int>(count, 1));
            if (count > 0)
                CHECK_THROWS_WITH(
                    for_each_index(count, threads,
                                   [](std::size_t) { throw std::runtime_error("an island failed"); }),
                    "an island failed");
        }
}
