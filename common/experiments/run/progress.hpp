#pragma once

#include <chrono>
#include <string>

namespace enduring {

/// Shows on stderr how far long work has come: one line that renews itself on a terminal, a line every ten
/// seconds elsewhere, and nothing for what takes less than a second.
class Progress {
public:
    Progress(std::string what, int count);
    ~Progress();  ///< clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void update(int done);

private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    int count_;
    bool terminal_, shown_ = false;
    Clock::time_point begin_, next_;
};

}  // namespace enduring
