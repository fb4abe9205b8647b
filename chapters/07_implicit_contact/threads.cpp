#include "chapters/07_implicit_contact/threads.hpp"

#include "common/input/input_error.hpp"

#ifdef ENDURING_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

namespace enduring {
namespace {

constexpr int most_threads = 1024;
#ifdef ENDURING_TBB
constexpr bool has_threads = true;
#else
constexpr bool has_threads = false;
#endif

}  // namespace

int allowed_threads()
{
    int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    if (const char* text = std::getenv("ENDURING_THREADS")) {
        const char* const end = text + std::strlen(text);
        const auto [read, error] = std::from_chars(text, end, threads);
        if (error != std::errc{} || read != end || threads < 1 || threads > most_threads)
            throw InputError("ENDURING_THREADS is \"" + std::string(text) +
                             "\"; it has to be a whole number from 1 to " + std::to_string(most_threads));
    }
    return has_threads ? threads : 1;
}

void for_each_index(std::size_t count, [[maybe_unused]] int threads,
                    const std::function<void(std::size_t)>& work)
{
#ifdef ENDURING_TBB
    using namespace oneapi;
    if (threads > 1 && count > 1) {
        // The library makes no more threads than there are cores, unless it is asked for them; asked anew in
        // each call, its threads would go to sleep in between. And no more than these: a call that ends
        // before its thread has come would leave it behind, and soon there are a thousand.
        static const int most = std::max(threads, allowed_threads());
        static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                               static_cast<std::size_t>(most));
        tbb::task_arena arena(std::min(threads, most));
        arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, work); });
        return;
    }
#endif
    for (std::size_t i = 0; i < count; ++i)
        work(i);
}

}  // namespace enduring
