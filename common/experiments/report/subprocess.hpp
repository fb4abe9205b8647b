#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace enduring {

/// Whether a program of this name lies on PATH.
bool is_installed(const std::string& program);

/// Another program, started without a shell, whose standard input we write.
class Subprocess {
public:
    /// @param words    the program, looked up on PATH, and its arguments
    /// @param package  Debian package that brings it, for the message when it is missing
    /// @throws std::runtime_error  the program is not installed or cannot start
    Subprocess(const std::vector<std::string>& words, const std::string& package);
    ~Subprocess();
    Subprocess(const Subprocess&) = delete;
    Subprocess& operator=(const Subprocess&) = delete;

    /// @throws std::runtime_error  the program no longer reads
    void write(std::string_view bytes);
    /// Ends its input and waits for it.
    /// @throws std::runtime_error  it failed
    void finish();

private:
    int wait();

    std::string name_;
    pid_t process_ = -1;
    int input_ = -1;
};

}  // namespace enduring
