#include "common/experiments/report/sweep.hpp"

#include "common/experiments/report/tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace enduring;

namespace {

struct Outcome {
    double value;
    long run;
    bool odd;
};

constexpr std::size_t count = 23;

Outcome outcome_of(std::size_t i)
{
    return {std::sin(static_cast<double>(i)) / 3, static_cast<long>(i), i % 2 == 1};
}

std::optional<std::vector<Outcome>> swept(const std::string& folder, const std::string& part, int& made,
                                          std::size_t runs = count)
{
    RunOptions options;
    options.share = read_share(folder, part);
    return sweep<Outcome>(options, "waves", runs, [&](std::size_t i) {
        ++made;
        return outcome_of(i);
    });
}

void check_all(const std::vector<Outcome>& found)
{
    REQUIRE(found.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
        const Outcome expected = outcome_of(i);
        CHECK(std::memcmp(&found[i].value, &expected.value, sizeof expected.value) == 0);
        CHECK(found[i].run == expected.run);
        CHECK(found[i].odd == expected.odd);
    }
}

}  // namespace

TEST_CASE("sweep: parts of any number, joined, are the whole to the last bit, and each run is made once")
{
    for (const int parts : {1, 2, 5, 23, 40}) {
        CAPTURE(parts);
        const TemporaryFolder folder;
        int made = 0;
        for (int part = parts; part > 0; --part)  // in any order
            if (parts > 1)
                CHECK_FALSE(
                    swept(folder.path.string(), std::to_string(part) + "/" + std::to_string(parts), made));
        CHECK(made == (parts > 1 ? static_cast<int>(count) : 0));
        check_all(swept(folder.path.string(), "", made).value());
        CHECK(made == static_cast<int>(count));
    }
}

TEST_CASE("sweep: without a folder every run is made, in order, and nothing is kept")
{
    int made = 0;
    check_all(swept("", "", made).value());
    CHECK(made == static_cast<int>(count));
}

TEST_CASE("sweep: what was stopped goes on with the run that is missing")
{
    const TemporaryFolder folder;
    int made = 0;
    swept(folder.path.string(), "1/2", made);
    const int half = made;
    std::filesystem::remove(folder.path / "waves.4");
    swept(folder.path.string(), "1/2", made);
    CHECK(made == half + 1);
}

TEST_CASE("sweep: an outcome of another size is refused, and the file is named")
{
    const TemporaryFolder folder;
    write_file(folder.path / "waves.3", "short");
    int made = 0;
    CHECK_THROWS_WITH_AS(swept(folder.path.string(), "", made), doctest::Contains("waves.3"), InputError);
}

TEST_CASE("share: a part that is none is refused")
{
    for (const std::string part : {"0/4", "5/4", "1", "/", "1/", "/2", "a/b", "-1/2", "1/2/3", "1/0"}) {
        CAPTURE(part);
        CHECK_THROWS_AS(read_share("folder", part), InputError);
    }
    const Share share = read_share("folder", "2/3");
    CHECK(share.is_part());
    CHECK(share.holds(1));
    CHECK_FALSE(share.holds(2));
    CHECK(share.holds(4));
}
