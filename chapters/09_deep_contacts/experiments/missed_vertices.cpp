#include "chapters/06_redefinition/contact_index.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/overlaps.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "chapters/motivating_scenes/buried_vertex.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace enduring::chapter09 {
namespace {

/// A vertex that is less deep is on the surface, but for rounding [m].
constexpr double least_depth = 1e-6;

/// Vertices inside a body with which they have no pair, over the steps of a run.
struct Unpaired {
    long steps = 0, steps_with_some = 0;
    double deepest = 0;  ///< [m]
    int longest = 0;     ///< steps in a row after which the same vertex is
};

/// A scene, perhaps with another beginning.
struct Start {
    std::string name, scene_name, patch;
};

class UnpairedProbe final : public Probe {
public:
    void observe(const World& world, const Contacts& contacts, double) override
    {
        if (world.step == 0)
            return;
        in_contact_.fill(contacts);
        deepest_ = 0;
        std::map<Place, int> now;
        for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
            for (int j = 0; j < i; ++j)
                if (world.bodies[i]->surface().is_closed() && world.bodies[j]->surface().is_closed())
                    note_overlaps(world, i, j, now);
        in_a_row_ = std::move(now);
        ++found.steps;
        found.steps_with_some += !in_a_row_.empty();
        found.deepest = std::max(found.deepest, deepest_);
    }
    Unpaired found;

private:
    using Place = std::tuple<int, int, int>;  ///< body, vertex, the body that it is in

    void note_overlaps(const World& world, int i, int j, std::map<Place, int>& now)
    {
        const Body &a = *world.bodies[i], &b = *world.bodies[j];
        FaceTree tree_a(a.surface(), a.contact_t0()), tree_b(b.surface(), b.contact_t0());
        tree_a.refit({a.surface(), a.contact_t0(), a.contact_t0()});
        tree_b.refit({b.surface(), b.contact_t0(), b.contact_t0()});
        for (const Overlap& overlap :
             find_overlaps({a.surface(), a.contact_t0(), tree_a}, {b.surface(), b.contact_t0(), tree_b})) {
            for (const int vertex : overlap.vertices_of_a)
                note(world, {i, vertex, j}, now);
            for (const int vertex : overlap.vertices_of_b)
                note(world, {j, vertex, i}, now);
        }
    }

    void note(const World& world, const Place& place, std::map<Place, int>& now)
    {
        const auto [body, vertex, other] = place;
        const double depth = motivating::depth_inside(*world.bodies[other],
                                                      world.bodies[body]->contact_t0()[vertex]);
        if (depth <= least_depth || in_contact_.find(body, vertex, other) >= 0)
            return;
        deepest_ = std::max(deepest_, depth);
        const auto before = in_a_row_.find(place);
        now[place] = before == in_a_row_.end() ? 1 : before->second + 1;
        found.longest = std::max(found.longest, now[place]);
    }

    double deepest_ = 0;             ///< after this step [m]
    std::map<Place, int> in_a_row_;  ///< steps, of what has none after this one
    VertexContacts in_contact_;
};

}  // namespace

/// The course's scenes: after how many steps a vertex is inside without a pair, of surfaces for contact.
void missed_vertices(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "missed_vertices",
                       {"scene", "steps", "steps_with_some", "deepest_mm", "in_a_row"});
    long steps = 0, some = 0;
    int longest = 0;
    std::vector<Start> starts;
    for (const char* scene : {"hooked", "deep", "shifted", "false_resolution", "through_the_side", "tumble",
                              "bar_on_cube", "bunny_bowl"})
        starts.push_back({scene, scene, ""});
    starts.push_back({"bunny in the wall", "bunny_bowl", R"({"/bodies/bunny/position": [0.3, 0.12, 0.1]})"});
    for (const auto& [name, scene_name, patch] : starts) {
        Scene scene = load_scene(scene_file(scene_name), patch);
        UnpairedProbe probe;
        run(scene, chapter09_solver(scene.contact), {&probe},
            failure_on_purpose({.steps = options.quick ? std::optional(20) : std::nullopt}));
        const Unpaired& found = probe.found;
        table.add({name, found.steps, found.steps_with_some, 1000 * found.deepest,
                   static_cast<long>(found.longest)});
        steps += found.steps;
        some += found.steps_with_some;
        longest = std::max(longest, found.longest);
    }
    report.table("missed_vertices", table);
    report.page_table("missed_vertices", table);
    report.fact("missed_vertices", "steps", static_cast<double>(steps), 6);
    report.fact("missed_vertices", "some", static_cast<double>(some), 6);
    report.fact("missed_vertices", "longest", static_cast<double>(longest));
}

}  // namespace enduring::chapter09
