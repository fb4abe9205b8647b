#include "common/experiments/report/report.hpp"
#include "common/experiments/report/column_words.hpp"
#include "common/experiments/report/table.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"
#include "common/input/input_error.hpp"
#include "common/input/number_text.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <stdexcept>

using namespace enduring;

TEST_CASE("report: every double in a CSV reads back as the same double")
{
    std::mt19937_64 random(7);
    Table table({"value"});
    std::vector<double> values{0.0,    -0.0,  0.1, 1.0 / 3,
                               5e-324, 1e-15, 1e9, std::numeric_limits<double>::max()};
    while (values.size() < 2000)
        if (const double value = std::bit_cast<double>(random()); std::isfinite(value))
            values.push_back(value);
    for (const double value : values)
        table.add({value});

    std::istringstream lines(csv(table));
    std::string line;
    std::getline(lines, line);
    CHECK(line == "value");
    for (const double value : values) {
        std::getline(lines, line);
        CAPTURE(line);
        CHECK(std::bit_cast<std::uint64_t>(std::strtod(line.c_str(), nullptr)) ==
              std::bit_cast<std::uint64_t>(value));
    }
}

TEST_CASE("report: numbers for reading keep their significant digits and nothing more")
{
    CHECK(readable(0.14, 3) == "0.14");
    CHECK(readable(1.0 / 3, 3) == "0.333");
    CHECK(readable(1234.6, 3) == "1235");
    CHECK(readable(9.996, 3) == "10");
    CHECK(readable(-0.00123456, 3) == "-0.00123");
    CHECK(readable(3.2e-7, 3) == "3.2·10⁻⁷");
    CHECK(readable(9.996e5, 2) == "1·10⁶");
    CHECK(readable(0, 3) == "0");
    CHECK(readable(std::nan(""), 3) == "nan");
}

namespace {

/// How numbers look in German: 12.345,5.
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// The program's own locale, for a while.
struct Locale {
    std::locale before;
    explicit Locale(const std::locale& other) : before(std::locale::global(other)) {}
    ~Locale() { std::locale::global(before); }
};

}  // namespace

TEST_CASE("report: a program whose own numbers have a decimal comma writes tables with a point")
{
    Table table({"steps", "dt_s"});
    table.add({12345L, 1234.5});
    const Locale german(std::locale(std::locale::classic(), new GermanNumbers));
    std::ostringstream shown;
    shown << 1234.5;
    CHECK(shown.str() == "1.234,5");  // the locale is in force
    CHECK(csv(table) == "steps,dt_s\n12345,1234.5\n");
    CHECK(readable(1234.5, 5) == "1234.5");
}

TEST_CASE("report: text with a comma or a quote stays one CSV cell, and a bar does not break a Markdown row")
{
    Table table({"method", "count", "dt_s"});
    table.add({std::string("says \"no\", twice"), 3L, 0.1});
    table.add({std::string("a|b"), -1L, 1e-7});
    CHECK(csv(table) == "method,count,dt_s\n\"says \"\"no\"\", twice\",3,0.1\na|b,-1,1e-07\n");
    CHECK(markdown(table, 3) ==
          "| method | count | Δt [s] |\n|---|---:|---:|\n"
          "| says \"no\", twice | 3 | 0.1 |\n| a\\|b | -1 | 1·10⁻⁷ |\n");
}

TEST_CASE("report: a page names columns in words, with the unit in brackets")
{
    CHECK(column_words("dt_s") == "Δt [s]");
    CHECK(column_words("stiffness_n_per_m") == "stiffness [N/m]");
    CHECK(column_words("speed_m_per_s") == "speed [m/s]");
    CHECK(column_words("dpf_depth_mm") == "DPF depth [mm]");
    CHECK(column_words("p95_percent") == "p95 [%]");
    CHECK(column_words("minus_mg_over_k_mm") == "minus mg/k [mm]");
    CHECK(column_words("turn_deg") == "turn [°]");
    CHECK(column_words("certified_tau") == "certified τ");
    CHECK(column_words("cells_along") == "cells along");
    CHECK(column_words("steps") == "steps");  // ends like a unit, but is none
    CHECK(column_words("s") == "s");
    CHECK(column_words("over_n") == "over [N]");
    CHECK(column_words("thesis k [N/m]") == "thesis k [N/m]");
    CHECK(column_words("n_s in words") == "n_s in words");
}

TEST_CASE("report: a row of the wrong length is refused")
{
    Table table({"a", "b"});
    CHECK_THROWS_AS(table.add({1L}), std::logic_error);
    CHECK(table.rows().empty());
}

TEST_CASE("report: a table takes the rows of one with the same columns, and of no other")
{
    Table all({"dt_s", "depth_m"}), more({"dt_s", "depth_m"});
    all.add({0.01, 1.0});
    more.add({0.02, 2.0});
    more.add({0.03, 3.0});
    all.append(more);
    REQUIRE(all.rows().size() == 3);
    CHECK(std::get<double>(all.rows()[2][1]) == 3);
    CHECK_THROWS_AS(all.append(Table({"dt_s"})), std::logic_error);
}

TEST_CASE("report: a fact told again replaces itself, and facts keep their order")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    report.fact("damping", "kept", 0.5);
    report.fact("damping", "method", "cpf");
    report.fact("damping", "kept", 0.98765);
    CHECK(content(folder.path / "facts_damping.csv") == "name,value,text\nkept,0.98765,0.988\nmethod,,cpf\n");
    CHECK(report.written().size() == 1);
}

TEST_CASE("report: a folder that it made and left empty goes again, any other stays")
{
    const TemporaryFolder folder;
    const std::filesystem::path made = folder.path / "made", used = folder.path / "used";
    {
        Report unused(made), empty_before(folder.path), writing(used);
        writing.fact("drop", "depth", 1.0);
    }
    CHECK_FALSE(std::filesystem::exists(made));
    CHECK(std::filesystem::exists(folder.path));
    CHECK(std::filesystem::exists(used / "facts_drop.csv"));
}

TEST_CASE("report: a folder that cannot be made is the user's mistake")
{
    const TemporaryFolder folder;
    write_file(folder.path / "file", "");
    CHECK_THROWS_AS(Report(folder.path / "file" / "results"), InputError);
    CHECK_THROWS_AS(Report("/proc/results"), InputError);
}
