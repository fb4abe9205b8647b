// The cases that test_judge.py runs one by one, as a student's answers leave them.
#include "exercises/checking.hpp"
#include "exercises/judged_main.cpp"
#include "exercises/not_implemented_yet.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

namespace enduring {

TEST_CASE("right")
{
    expect("speed", 9.81, 9.81, 0, "m/s");
    expect("push", Vec3(1, 2, 3), Vec3(1, 2, 3), 1e-12, "N s");
    expect_that("the sun rises", true);
    say("speed ", 9.81, " m/s");
}

TEST_CASE("wrong number")
{
    given("t = ", 1, " s");
    given("t = ", 2, " s");
    expect("speed", -9.81, 9.81, 1e-9, "m/s");
}

TEST_CASE("wrong vector") { expect("push", Vec3(1, 2, 3), Vec3(1, 2, 4), 1e-9, "N s"); }

TEST_CASE("close number") { expect("speed", 0.9 + 3e-9, 0.9, 1e-12, "m/s"); }

TEST_CASE("close vector") { expect("push", Vec3(1, 2, 3.00000001), Vec3(1, 2, 3), 1e-12, "N s"); }

TEST_CASE("not a number") { expect("speed", std::nan(""), 9.81, 1e9, "m/s"); }

TEST_CASE("wrong sentence") { expect_that("the sun rises", false); }

TEST_CASE("plain check") { CHECK(1 + 1 == 3); }

TEST_CASE("untouched") { not_implemented_yet("9.1"); }

TEST_CASE("throws") { throw std::runtime_error("out of paper"); }

TEST_CASE("loop")
{
    for (volatile int i = 0; i < 1;)
        i = 0;
}

volatile int one = 1;

int deeper(int depth) { return deeper(depth + one) + depth; }

TEST_CASE("recursion") { expect("depth", deeper(0), 0, 0); }

TEST_CASE("leaves") { std::exit(0); }

/// Where the report goes, as anybody can find out.
std::string report()
{
    std::ifstream line("/proc/self/cmdline");
    std::string words((std::istreambuf_iterator<char>(line)), {});
    return words.substr(words.find("--out=") + 6).c_str();
}

TEST_CASE("forges")
{
    std::ofstream(report()) << "<doctest><TestSuite><TestCase name=\"forges\"/></TestSuite></doctest>"
                            << std::flush;
    _exit(0);
}

TEST_CASE("forges and goes on")
{
    std::ofstream(report()) << "<doctest><TestSuite><TestCase name=\"forges\"/></TestSuite></doctest><!--";
}

TEST_CASE("chosen text")
{
    const volatile bool flat = true;
    given("a plate", flat ? ", flat" : "");
    expect("thickness", 1.0, 0.0, 0, "m");
}

TEST_CASE("index")
{
    const std::vector<int> three(3);
    expect("entry", three[static_cast<std::size_t>(doctest::getContextOptions()->count) + 3], 0, 0);
}

}  // namespace enduring
