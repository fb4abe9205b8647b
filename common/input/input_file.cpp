#include "common/input/input_file.hpp"

#include "common/input/input_error.hpp"

#include <cerrno>
#include <cstring>

namespace enduring {

std::ifstream open_file(const std::filesystem::path& file)
{
    const auto refuse = [&](const std::string& reason) { throw InputError(file.string() + ": " + reason); };
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(file, failure);
    if (status.type() == std::filesystem::file_type::not_found)
        refuse("no such file");
    if (std::filesystem::is_directory(status))
        refuse("is a folder, and a file is needed");
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
        refuse("is a pipe or a device, and only a file can be read");
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
        refuse(std::string("cannot be opened (") + std::strerror(errno) + ")");
    return stream;
}

}  // namespace enduring
