#include "common/experiments/report/subprocess.hpp"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace enduring {
namespace {

/// Our own environment, but one locale on every machine: where there is
/// none, gnuplot cannot convert its degree sign.
std::vector<char*> environment()
{
    static std::string locale = "LC_ALL=C.UTF-8";
    std::vector<char*> variables;
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (!std::string_view(*variable).starts_with("LC_ALL="))
            variables.push_back(*variable);
    variables.insert(variables.end(), {locale.data(), nullptr});
    return variables;
}

}  // namespace

bool is_installed(const std::string& program)
{
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (::access((folder + '/' + program).c_str(), X_OK) == 0)
            return true;
    return false;
}

Subprocess::Subprocess(const std::vector<std::string>& words, const std::string& package) : name_(words.at(0))
{
    // A socket instead of a pipe: writing to a program that has died is then an error, not a signal.
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw std::runtime_error(name_ + ": " + std::strerror(errno));
    input_ = ends[0];

    std::vector<char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    const int failure = ::posix_spawnp(&process_, name_.c_str(), &actions, nullptr, arguments.data(),
                                       environment().data());
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (failure != 0) {
        ::close(input_);
        throw std::runtime_error(name_ + " cannot be run (" + std::strerror(failure) +
                                 "). On Debian: apt-get install " + package);
    }
}

Subprocess::~Subprocess() { wait(); }

void Subprocess::write(std::string_view bytes)
{
    while (!bytes.empty()) {
        const ssize_t sent = ::send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent < 0)
            throw std::runtime_error(name_ + " stopped reading (" + std::strerror(errno) + ")");
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

void Subprocess::finish()
{
    if (const int status = wait(); status != 0)
        throw std::runtime_error(name_ + " failed with exit status " + std::to_string(status));
}

int Subprocess::wait()
{
    if (process_ < 0)
        return 0;
    ::close(input_);
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {}
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace enduring
