#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

int main(int argument_count, char** arguments)
{
    doctest::Context context(argument_count, arguments);
#ifdef ENDURING_SANITIZE
    // Minutes of a soft body's steps: under the sanitizers each would take ten minutes and look at no other
    // memory than its first step does.
    context.addFilter("test-suite-exclude", "long simulation");
#endif
    return context.run();
}
