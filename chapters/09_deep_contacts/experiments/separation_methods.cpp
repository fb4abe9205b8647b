#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/experiments/other_methods.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/run.hpp"
#include "common/experiments/run/spring_ledger.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace enduring::chapter09 {
namespace {

struct ComparedWay {
    std::string name;
    SeparationMethod ways;
};
const std::vector<ComparedWay>& all_ways()
{
    static const std::vector<ComparedWay> all{{"vector area", overlap_direction},
                                              {"from the border", ways_from_the_border},
                                              {"to the boundary", ways_to_the_boundary}};
    return all;
}

/// A body in a floor, over the corner of a ledge, or wholly in it: everywhere the way out is up.
struct Place {
    std::string name, body;
    Surroundings surroundings;
    double depth;
};

std::vector<Place> places()
{
    const Surroundings floor = {"floor",
                                "",
                                R"({"name": "floor", "type": "static", "position": [0, -0.5, 0],
                                    "shape": {"box": {"size": [2, 1, 2], "cells": [19, 9, 19]}}}, )",
                                {}},
                       ledge = {"ledge",
                                "",
                                R"({"name": "floor", "type": "static", "position": [0.4, -0.5, 0.4],
                                    "shape": {"box": {"size": [1, 1, 1], "cells": [9, 9, 9]}}}, )",
                                {}};
    return {{"cube in a floor", "fine block", floor, 0.1},
            {"cube's corner in a floor", "block on a corner", floor, 0.2},
            {"cube over a ledge's corner", "fine block", ledge, 0.1},
            {"cube wholly in a floor", "fine block", floor, 0.45}};
}

/// The directions that vertices of both bodies get at the start.
struct Directions {
    struct Arrow {
        Vec3 from, way;
        bool wrong;  ///< more than 45 degrees off
    };
    std::vector<Arrow> of_vertices;
    long wrong = 0, none = 0;  ///< none: without a direction
};

/// The cube's vertices should go up, and those of what it is in down.
Directions directions_at_start(const Scene& scene, const SeparationMethod& ways)
{
    Directions directions;
    const Vec3* const cube = scene.world.bodies[1]->positions_t0().data();
    const SeparationMethod noting = [&](const StillSurface& inner, const std::vector<int>& vertices,
                                        const StillSurface& outer, const Vec3& separation_direction) {
        const std::vector<Vec3> chosen = ways(inner, vertices, outer, separation_direction);
        const double up = inner.positions.data() == cube ? 1 : -1;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const Vec3& way = chosen[i];
            directions.of_vertices.push_back(
                {inner.positions[vertices[i]], way, up * way.y() < std::sqrt(0.5)});
            directions.none += way.isZero(0);
            directions.wrong += !way.isZero(0) && directions.of_vertices.back().wrong;
        }
        return chosen;
    };
    Contacts contacts;
    InsidePairs(noting).append_missing(scene.world, contacts);
    return directions;
}

/// What letting the body out takes and brings.
struct Costs {
    double fastest = 0, lifted = 0, brought = 0, gained = 0, off = 0;
    bool out = false, broke = false;
};

Costs costs_of(Scene scene, const SeparationMethod& ways, double duration)
{
    const Solver solver = chapter09_solver(scene.contact, {}, ways);
    SpringLedger ledger(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity);
    const double before = total_energy(scene.world).total();
    const Vec3 start = scene.world.bodies[1]->centre();
    Costs costs;
    WatchProbe watch([&](const World& world, const Contacts& contacts, double dt) {
        costs.fastest = std::max(costs.fastest, world.bodies[1]->mean_velocity().norm());
        if (world.step > 0)
            ledger.add_step(world, contacts, dt);
    });
    try {
        run(scene, solver, {&watch}, failure_on_purpose({.steps = static_cast<int>(duration / scene.dt)}));
    } catch (const std::runtime_error&) {
        // wrong directions wind springs up against each other, until they throw the body
        costs.broke = true;
    }
    const Vec3 way = scene.world.bodies[1]->centre() - start;
    costs.lifted = ledger.accounts().lifted;
    costs.brought = ledger.accounts().brought();
    costs.gained = total_energy(scene.world).total() - before;
    costs.off = std::hypot(way.x(), way.z());
    costs.out = deepest_inside(scene.world) < 1e-3;
    return costs;
}

/// The start over the ledge's corner with each of the ways: both bodies pale, and an arrow for each vertex inside.
void show_starts(Report& report)
{
    // The same corner and the same cells, with less of the ledge behind them: all of it is in the picture.
    const Surroundings ledge = {
        "ledge",
        "",
        R"({"name": "floor", "type": "static", "position": [0.177777777777778, -0.166666666666667, 0.177777777777778],
            "shape": {"box": {"size": [0.555555555555556, 0.333333333333333, 0.555555555555556], "cells": [5, 3, 5]}}}, )",
        {}};
    constexpr int width = 480, height = 400;
    std::vector<Moment> starts;
    for (const ComparedWay& compared : all_ways()) {
        const Scene scene = scene_inside(ledge, "fine block", 0.1, 0.01);
        Stage stage = stage_of(scene.world, scene);
        for (Drawable& body : stage.bodies)
            body.opacity = 0.35;
        for (const auto& [from, way, wrong] : directions_at_start(scene, compared.ways).of_vertices) {
            const Vec3& color = wrong ? palette::colliding_vertex : palette::colliding_face;
            stage.segments.push_back({from, from + 0.08 * way, color, 3, true});
            stage.dots.push_back({from, color, 3});
        }
        starts.push_back({std::move(stage), compared.name});
    }
    frame_together(starts, {-1.1, 0.5, 1.3}, static_cast<double>(width) / height);
    write_png(draw_moments(starts, 3, width, height), report.file("separation_methods.png"));
}

}  // namespace

/// Three choices of the way out in the same scenes: wrong directions at the start, and what each costs.
void separation_methods(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "separation_methods",
                       {"scene", "ways", "vertices", "wrong", "without", "fastest_m_per_s", "lifted_j",
                        "gained_j", "brought_j", "aside_mm", "out"});
    std::map<std::string, Costs> worst;
    std::map<std::string, long> wrong, asked;
    for (const Place& place : places())
        for (const ComparedWay& compared : all_ways()) {
            Scene scene = scene_inside(place.surroundings, place.body, place.depth, 0.01);
            const Directions directions = directions_at_start(scene, compared.ways);
            const Costs costs = costs_of(std::move(scene), compared.ways, options.quick ? 0.5 : 2.5);
            table.add({place.name, compared.name, static_cast<long>(directions.of_vertices.size()),
                       directions.wrong, directions.none, costs.fastest, costs.lifted, costs.gained,
                       costs.brought, 1000 * costs.off,
                       std::string(costs.broke ? "breaks"
                                   : costs.out ? "yes"
                                               : "no")});
            wrong[compared.name] += directions.wrong;
            asked[compared.name] += static_cast<long>(directions.of_vertices.size());
            worst[compared.name].fastest = std::max(worst[compared.name].fastest, costs.fastest);
        }
    show_starts(report);
    report.table("separation_methods", table);
    report.page_table("separation_methods", table);
    for (const ComparedWay& compared : all_ways()) {
        const std::string word = compared.name.substr(compared.name.rfind(' ') + 1);
        report.fact(
            "separation_methods", word + "_wrong",
            100.0 * static_cast<double>(wrong[compared.name]) / static_cast<double>(asked[compared.name]));
        report.fact("separation_methods", word + "_fastest", worst[compared.name].fastest);
    }
}

}  // namespace enduring::chapter09
