#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/query_files.hpp"
#include "chapters/02_collision_detection/tests/exact_oracle.hpp"
#include "chapters/02_collision_detection/tests/step_generators.hpp"
#include "common/input/source_directory.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace enduring;
using namespace enduring::generated;

namespace {

/// What the certified query got wrong, judged by exact arithmetic.
struct Record {
    int queries = 0, touching = 0, missed = 0, late = 0, early = 0, false_alarms = 0;

    void add(const std::optional<double>& answer, const std::optional<exact::FirstTouch>& truth)
    {
        ++queries;
        touching += truth.has_value();
        missed += truth && !answer;
        false_alarms += answer && !truth;
        if (answer && truth) {
            late += *answer > truth->time() + 0x1p-52;  // one rounding of the answer, one of the truth
            early += *answer < truth->time() - 1.01 * time_of_impact_slack;
        }
    }
};

template <class Step>
Record judged(const Category& category, bool edges, int count)
{
    Random random(2015);
    Record record;
    for (int i = 0; i < count; ++i) {
        const Step step = step_of<Step>(category.make(random, edges));
        record.add(time_of_impact(step), exact::first_touch(step));
    }
    return record;
}

void require_certified(const Record& record)
{
    CAPTURE(record.queries);
    CAPTURE(record.touching);
    CHECK(record.missed == 0);
    CHECK(record.late == 0);
    // A near miss that 106 bits cannot tell from a touch counts as one.
    // Coordinates nudged by single roundings make some.
    CHECK(record.false_alarms + record.early <= 0.02 * record.queries);
}

std::vector<std::filesystem::path> data_files()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(source_directory() / "chapters/02_collision_detection/data"))
        if (entry.path().extension() == ".csv")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

TEST_CASE("certified query: no vertex-face touch is missed or told late, in any category")
{
    for (const Category& category : categories()) {
        CAPTURE(category.name);
        require_certified(judged<VertexFaceStep>(category, false, 300));
    }
}

TEST_CASE("certified query: no edge-edge touch is missed or told late, in any category")
{
    for (const Category& category : categories()) {
        CAPTURE(category.name);
        require_certified(judged<EdgeEdgeStep>(category, true, 300));
    }
}

TEST_CASE(
    "certified query: every answer on the hard queries of the data folder is right, and the oracle agrees with theirs")
{
    REQUIRE(data_files().size() == 32);
    for (const auto& file : data_files()) {
        CAPTURE(file.filename().string());
        const bool edges = file.stem().string().ends_with("_ee");
        Record record;
        for (const FileQuery& query : read_queries(file)) {
            const auto truth = edges ? exact::first_touch(query.edge_edge())
                                     : exact::first_touch(query.vertex_face());
            CHECK(truth.has_value() == query.collides.value());
            record.add(edges ? time_of_impact(query.edge_edge()) : time_of_impact(query.vertex_face()),
                       truth);
        }
        CHECK(record.missed == 0);
        CHECK(record.false_alarms == 0);
        CHECK(record.late == 0);
        CHECK(record.early == 0);
    }
}
