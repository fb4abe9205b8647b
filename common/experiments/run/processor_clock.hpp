#pragma once

#include <ctime>

namespace enduring {

/// What this thread has had of its processor [s]. Unlike the time of day it
/// does not run on while others have their turn.
inline double processor_seconds()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace enduring
