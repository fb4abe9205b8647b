#include "common/experiments/report/rows_file.hpp"

#include "common/input/input_error.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>

namespace enduring {

RowsFile::RowsFile(std::filesystem::path file)
    : file_(std::move(file)),
      descriptor_(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666))
{
    if (descriptor_ < 0)
        throw InputError(file_.string() + ": cannot be written (" + std::strerror(errno) + ")");
}

RowsFile::~RowsFile() { ::close(descriptor_); }

void RowsFile::append(const std::string& rows)
{
    std::size_t written = 0;
    while (written < rows.size()) {
        const ssize_t more = ::write(descriptor_, rows.data() + written, rows.size() - written);
        if (more < 0 && errno == EINTR)
            continue;
        if (more <= 0) {
            const std::string reason = std::strerror(errno);
            if (::ftruncate(descriptor_, length_) == 0)
                ::lseek(descriptor_, length_, SEEK_SET);
            throw InputError(file_.string() + ": cannot be written to its end (" + reason + ")");
        }
        written += static_cast<std::size_t>(more);
    }
    length_ += static_cast<long>(rows.size());
}

}  // namespace enduring
