// The main program of a check in the page: it writes doctest's report to descriptor 3, so what
// the answer prints is apart from it, and what was reported before a crash is not lost.
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_NO_POSIX_SIGNALS  // a browser has none
#include <doctest/doctest.h>

#include <unistd.h>
#include <cstdlib>
#include <ostream>
#include <streambuf>

namespace {

constexpr int report_descriptor = 3;

/// Writes without a buffer.
class Report : public std::streambuf {
    std::streamsize xsputn(const char* text, std::streamsize length) override
    {
        return write(report_descriptor, text, static_cast<std::size_t>(length));
    }

    int_type overflow(int_type sign) override
    {
        const char one = traits_type::to_char_type(sign);
        return xsputn(&one, 1) == 1 ? sign : traits_type::eof();
    }
};

}  // namespace

/// In the place of the C library's, which ends a program as exit(1) does: this one is a crash.
void abort() { __builtin_trap(); }

int main()
{
    Report report;
    std::ostream stream(&report);
    doctest::Context context;
    context.setOption("reporters", "xml");
    context.setOption("no-breaks", true);
    context.setCout(&stream);
    return context.run();
}
