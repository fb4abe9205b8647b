#include "common/experiments/run/progress.hpp"

#include <unistd.h>
#include <cstdio>
#include <utility>

namespace enduring {
using namespace std::chrono_literals;

Progress::Progress(std::string what, int count)
    : what_(std::move(what)), count_(count), terminal_(isatty(STDERR_FILENO) != 0), begin_(Clock::now()),
      next_(begin_ + (terminal_ ? Clock::duration(1s) : Clock::duration(10s)))
{}

Progress::~Progress()
{
    if (shown_ && terminal_)
        std::fputs("\r\033[K", stderr);
}

void Progress::update(int done)
{
    const Clock::time_point now = Clock::now();
    if (now < next_)
        return;
    next_ = now + (terminal_ ? Clock::duration(200ms) : Clock::duration(10s));
    shown_ = true;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    std::fprintf(stderr, terminal_ ? "\r\033[K%s: %d of %d, %.0f s" : "%s: %d of %d, %.0f s\n", what_.c_str(),
                 done, count_, seconds);
    std::fflush(stderr);
}

}  // namespace enduring
