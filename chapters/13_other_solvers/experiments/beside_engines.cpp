#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/method_table.hpp"
#include "chapters/13_other_solvers/solver.hpp"
#include "chapters/engines/cases.hpp"
#include "chapters/engines/experiments/measured_rows.hpp"
#include "common/experiments/report/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace enduring::chapter13 {
namespace {

using namespace engines;

/// An engine, and the method of its kind with its settings.
struct Beside {
    std::string engine, method;
    int substeps = 1;  ///< whole steps of the method a frame, as many as the engine makes
    MakeMethod make;
};

const std::vector<Beside>& all_beside()
{
    using P = ContactParameters;
    static const std::vector<Beside> all{
        {"MuJoCo of npm", "convex relaxation", 5,
         [](const P& p) { return chapter13_relaxation_solver(p, mujoco_settings()); }},
        {"Rapier", "soft step", 1,
         [](const P& p) { return chapter13_soft_step_solver(p, rapier_settings()); }},
        {"Bullet", "sequential impulses", 1,
         [](const P& p) { return chapter13_sequential_solver(p, bullet_settings()); }},
        {"Jolt", "sequential impulses", 1,
         [](const P& p) { return chapter13_sequential_solver(p, jolt_settings()); }}};
    return all;
}

/// Plain numbers, to be kept by sweep().
struct KeptCase {
    std::array<double, 2> values{};
    std::array<bool, 2> right{};
};

KeptCase run_case(const Case& asked, const Beside& beside)
{
    Engine engine{beside.method, "", "", "", {"default", beside.substeps}, {}, {}};
    engine.run = [&](Scene scene, const Way& way, int steps) {
        return run_solver(std::move(scene), way.substeps, steps,
                          [&](Scene& taken) { return beside.make(taken.contact); });
    };
    const Verdict verdict = try_case(asked, engine, engine.plain);
    KeptCase kept;
    for (std::size_t m = 0; m < verdict.measures.size(); ++m) {
        kept.values.at(m) = verdict.measures[m].value;
        kept.right.at(m) = verdict.measures[m].right;
    }
    return kept;
}

std::vector<Case> cases_beside(bool quick)
{
    const std::vector<Case> theirs = all_cases(false);
    std::vector<Case> cases;
    std::vector<std::string> names{"stack", "ratio_1000", "arch", "wall", "slopes", "overlap"};
    if (!quick)
        names.insert(names.end(), {"ratio_5000", "thin"});
    for (const std::string& name : names)
        cases.push_back(case_named(theirs, name));
    return cases;
}

/// The rows of one engine, by scene, with its default settings.
std::vector<MeasuredRow> rows_of(const std::vector<MeasuredRow>& all, const std::string& engine,
                                 const std::string& scene)
{
    std::vector<MeasuredRow> rows;
    std::copy_if(all.begin(), all.end(), std::back_inserter(rows), [&](const MeasuredRow& row) {
        return row.at("engine") == engine && row.at("scene") == scene && row.at("way") == "default";
    });
    return rows;
}

//! [mujoco_depth]
/// The depth [m] at which MuJoCo's contacts carry a load [N]: four edges a contact, each k s / R.
/// @param inverse_mass  of both bodies together [1/kg]
double mujoco_depth(double load, int contacts, double inverse_mass, double mu)
{
    constexpr double t = 0.95 * 0.02;  // d_max times the time constant
    double depth = 1e-4;
    for (int i = 0; i < 200; ++i) {
        const double x = std::min(1.0, depth / 1e-3),
                     d = 0.9 + 0.05 * (x < 0.5 ? 2 * x * x : 1 - 2 * (1 - x) * (1 - x));
        const double r_edge = 2 * mu * mu * (1 - d) / d * (1 + mu * mu) * inverse_mass, k = d / (t * t);
        depth = 0.5 * (depth + load * r_edge / (4 * contacts * k));
    }
    return depth;
}
//! [mujoco_depth]

/// What closed formulas say of the same rows: cubes of 10 kg, mu 0.5, four pairs on the ground and eight
/// between cubes.
void report_formulas(Report& report)
{
    constexpr double m = 10, g = 9.81, mu = 0.5;
    report.fact("beside_engines", "formula_stack_MuJoCo_um", 1e6 * mujoco_depth(10 * m * g, 4, 1 / m, mu), 4);
    for (const double ratio : {1000.0, 5000.0}) {
        const double heavy = ratio * m, sunk = mujoco_depth((heavy + 2 * m) * g, 4, 1 / m, mu) +
                                               mujoco_depth((heavy + m) * g, 8, 2 / m, mu) +
                                               mujoco_depth(heavy * g, 8, 1 / m + 1 / heavy, mu);
        report.fact("beside_engines", "formula_ratio_" + std::to_string(std::lround(ratio)) + "_MuJoCo_mm",
                    1e3 * sunk, 4);
    }
}

/// 5000 : 1 under MuJoCo's settings after so many seconds: the heavy cube stands on two light ones, each
/// turned by an angle against the one below. A tilt of two edges is larger in the normal across them, by 1 /
/// sin of this angle.
void report_ratio_5000(Report& report)
{
    constexpr double dt = 0.002, seconds = 3;
    for (const int turn_deg : {7, 45}) {
        Scene scene = chapter07::scene_of(chapter07::stack_of(3, 10, 50000, turn_deg), dt);
        const Solver solver = chapter13_relaxation_solver(scene.contact, mujoco_settings());
        Contacts contacts;
        for (int step = 0; step < std::lround(seconds / dt); ++step)
            advance(scene.world, contacts, solver, dt);
        const Vec3 top = scene.world.bodies.back()->centre();
        const std::string word = "ratio_5000_turned_" + std::to_string(turn_deg);
        report.fact("beside_engines", word + "_sunk_mm", 1e3 * (2.5 - top.y()));
        report.fact("beside_engines", word + "_aside_mm", 1e3 * std::hypot(top.x(), top.z()), 2);
    }
}

}  // namespace

/// Rows of the page on engines, as measured there, beside the method of the same kind with that engine's
/// settings.
void beside_engines(const RunOptions& options, Report& report)
{
    const std::vector<Case> cases = cases_beside(options.quick);
    const std::vector<Beside>& all = all_beside();
    const auto found = sweep<KeptCase>(
        options, "beside_engines", cases.size() * all.size(),
        [&](std::size_t i) { return run_case(cases[i / all.size()], all[i % all.size()]); });
    if (!found)
        return;
    std::vector<std::string> head{"scene", "measured"};
    for (const Beside& beside : all) {
        head.push_back(beside.engine);
        head.push_back(beside.method + ", as " + beside.engine);
    }
    Table page(head), table({"scene", "quantity", "engine", "value", "method", "value_of_method"});
    const std::vector<MeasuredRow> measured = measured_rows("rows.csv");
    for (std::size_t c = 0; c < cases.size(); ++c) {
        const std::size_t quantities = rows_of(measured, all[0].engine, cases[c].name).size();
        for (std::size_t q = 0; q < quantities; ++q) {
            std::vector<Cell> line{cases[c].name};
            for (std::size_t b = 0; b < all.size(); ++b) {
                const MeasuredRow row = rows_of(measured, all[b].engine, cases[c].name).at(q);
                const KeptCase& kept = (*found)[c * all.size() + b];
                const double theirs = measured_number(row.at("value"));
                if (b == 0)
                    line.emplace_back(with_unit(row.at("quantity")));
                line.emplace_back(cell_of(theirs, row.at("right") == "yes"));
                line.emplace_back(cell_of(kept.values.at(q), kept.right.at(q)));
                table.add({cases[c].name, row.at("quantity"), all[b].engine, theirs, all[b].method,
                           kept.values.at(q)});
                const std::string word = cases[c].name + "_" + fact_word(all[b].engine) + "_" +
                                         row.at("quantity");
                report.fact("beside_engines", word, theirs);
                report.fact("beside_engines", word + "_of_method", kept.values.at(q));
            }
            page.add(line);
        }
    }
    report.table("beside_engines", table);
    report.page_table("beside_engines", page);
    report_formulas(report);
    report_ratio_5000(report);
}

}  // namespace enduring::chapter13
