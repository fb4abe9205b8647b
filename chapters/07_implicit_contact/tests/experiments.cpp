#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "common/experiments/report/tests/temporary_folder.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <sstream>

using namespace enduring;

namespace {

std::string content_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("experiments: on the implicit map every drop settles whose weight does not look back")
{
    const TemporaryFolder folder;
    Report report(folder.path);
    RunOptions quick;
    quick.quick = true;
    chapter07::implicit_map(quick, report);
    const std::string facts = content_of(folder.path / "facts_implicit_map.csv");
    CHECK(facts.find("drops,100,") != std::string::npos);
    CHECK(facts.find("settled,100,") != std::string::npos);
}
