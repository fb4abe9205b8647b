#pragma once

#include <ctime>

namespace enduring {

inline double seconds_of(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// What this thread has had of its processor [s]. Unlike the time of day it
/// does not run on while others have their turn.
inline double processor_seconds() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

/// What all threads of this program have had of their processors [s].
inline double processor_seconds_of_all_threads() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace enduring
