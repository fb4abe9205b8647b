#include "common/experiments/report/share.hpp"

#include "common/input/input_error.hpp"

#include <charconv>

namespace enduring {
namespace {

/// 0 for what is no whole number above 0.
std::size_t counted(const std::string& text)
{
    std::size_t number = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc() && read.ptr == end ? number : 0;
}

}  // namespace

Share read_share(const std::string& folder, const std::string& part)
{
    Share share{folder};
    if (part.empty())
        return share;
    const std::size_t slash = part.find('/');
    share.which = counted(part.substr(0, slash));
    share.of = slash == std::string::npos ? 0 : counted(part.substr(slash + 1));
    if (share.which < 1 || share.which > share.of)
        throw InputError("--part " + part + ": should be K/N with 1 <= K <= N, as in 2/8");
    return share;
}

}  // namespace enduring
