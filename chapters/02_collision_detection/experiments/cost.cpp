// What one query costs over the pairs that survive the boxes in two
// scenes of the course, for the textbook's and ours.
#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/experiments/cpu_time.hpp"
#include "chapters/02_collision_detection/experiments/experiments.hpp"
#include "chapters/02_collision_detection/experiments/recorded_queries.hpp"
#include "chapters/02_collision_detection/textbook.hpp"

namespace enduring::chapter02 {
namespace {

struct Cost {
    long touching = 0;
    double nanoseconds = 0;  ///< a query
};

template <class Step, class Query>
Cost measure(const std::vector<Step>& steps, const Query& query)
{
    Cost cost;
    const double seconds = best_cpu_seconds([&] {
        cost.touching = 0;
        for (const Step& step : steps)
            cost.touching += query(step).has_value();
    });
    cost.nanoseconds = 1e9 * seconds / static_cast<double>(steps.size());
    return cost;
}

/// One row: both queries over the same pairs. Returns what the certified one took in all [ns].
template <class Step>
double add_row(Table& table, const std::string& scene, const std::string& kind,
               const std::vector<Step>& steps)
{
    if (steps.empty())
        return 0;
    const Cost textbook = measure(steps, [](const Step& step) { return textbook_time_of_impact(step); });
    const Cost certified = measure(steps, [](const Step& step) { return time_of_impact(step); });
    table.add({scene, kind, static_cast<long>(steps.size()), textbook.touching, certified.touching,
               textbook.nanoseconds, certified.nanoseconds});
    return certified.nanoseconds * static_cast<double>(steps.size());
}

}  // namespace

void cost(const RunOptions& options, Report& report)
{
    Table table({"scene", "kind", "queries", "textbook_touching", "certified_touching", "textbook_ns",
                 "certified_ns"});
    for (const std::string scene : {"bar_on_cube", "bunny_bowl"}) {
        const RecordedQueries queries = record_queries(scene, options.quick ? 12 : 120);
        const double spent = add_row(table, scene, "vertex-face", queries.vertex_face) +
                             add_row(table, scene, "edge-edge", queries.edge_edge);
        const auto count = static_cast<double>(queries.vertex_face.size() + queries.edge_edge.size());
        report.fact("cost", scene + "_ns", count > 0 ? spent / count : 0, 3);
        report.fact("cost", scene + "_queries_per_detection",
                    queries.detections > 0 ? count / queries.detections : 0, 3);
    }
    report.table("cost", table);
    report.page_table("cost", table);
}

}  // namespace enduring::chapter02
