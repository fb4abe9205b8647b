#include "chapters/03_penalty_impulses/solver.hpp"
#include "chapters/06_redefinition/baseline/discrete_solver.hpp"
#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/experiments/stage_clock.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/run/run.hpp"

#include <nlohmann/json.hpp>

namespace enduring::chapter06 {
namespace {

constexpr double larger_step = 1.22;  ///< of CPF over DPF, as thesis 7.1.2 gives it

StageTimes mean(const std::vector<PairTimes>& runs, StageTimes PairTimes::*kind)
{
    StageTimes sum;
    const double share = 1.0 / static_cast<double>(runs.size());
    for (const PairTimes& run : runs)
        for (double StageTimes::*stage :
             {&StageTimes::resolve, &StageTimes::categorise, &StageTimes::redefine, &StageTimes::cpf,
              &StageTimes::dpf, &StageTimes::friction})
            sum.*stage += share * (run.*kind.*stage);
    return sum;
}

std::vector<PairTimes> timed_runs(const std::filesystem::path& file, const std::string& change, int count,
                                  int steps, int from = 0)
{
    std::vector<PairTimes> runs;
    for (int i = 0; i < count; ++i) {
        Scene scene = load_scene(file, change);
        runs.push_back(time_stages(scene, steps, from));
    }
    return runs;
}

void add_stages(Table& table, const std::string& pair, const std::string& run, const StageTimes& t)
{
    table.add({pair, run, t.resolve, t.categorise, t.redefine, t.friction, t.cpf, t.dpf, t.with_cpf(),
               t.with_dpf(), t.with_cpf() / t.with_dpf()});
}

/// Figure 7.17, as the thesis made it: several runs of 200 steps, DPF for the clock only.
void compose(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    Table table({"pair", "run", "resolve", "categorise", "redefine", "friction", "cpf", "dpf", "with_cpf",
                 "with_dpf", "ratio"});
    for (const std::string model : {"mass_splitting", "yamane_nakamura"}) {
        const std::string change = nlohmann::json{{"contact", {{"friction", {{"model", model}}}}}}.dump();
        const std::vector<PairTimes> runs = timed_runs(file, change, options.quick ? 1 : 5,
                                                       options.quick ? 60 : 200);
        const StageTimes vf = mean(runs, &PairTimes::vertex_face), ee = mean(runs, &PairTimes::edge_edge);
        const std::string friction = model == "mass_splitting" ? "mass_splitting" : "thesis";
        add_stages(table, "VF", friction, vf);
        add_stages(table, "EE", friction, ee);
        if (model == "yamane_nakamura") {  // the friction that the thesis timed
            const double ratio = 0.5 * (vf.with_cpf() / vf.with_dpf() + ee.with_cpf() / ee.with_dpf());
            report.fact("cost", "ratio", ratio);
            report.fact("cost", "left_percent", 100 * (larger_step / ratio - 1), 2);
            report.fact("cost", "vf_ns", vf.with_cpf());
            report.fact("cost", "ee_ns", ee.with_cpf());
            report.fact("cost", "cpf_adds_ns", 0.5 * (vf.cpf - vf.dpf + ee.cpf - ee.dpf), 2);
        }
    }
    if (!options.quick) {  // the impact is over, and almost every pair lies inside for the whole step
        const std::vector<PairTimes> rest = timed_runs(file, "", 1, 600, 500);
        add_stages(table, "VF", "at rest", rest[0].vertex_face);
        add_stages(table, "EE", "at rest", rest[0].edge_edge);
    }
    report.table("pair_cost", table);
    report.page_table("pair_cost", table, 3);
    report.plot("chapters/06_redefinition/plots/pair_cost.gp");
}

void grow(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    Table table({"elements", "pairs a step", "VF [ns]", "EE [ns]"});
    for (const int elements : options.quick ? std::vector<int>{363} : std::vector<int>{363, 785, 1452}) {
        const std::string change =
            nlohmann::json{{"/bodies/bunny/shape/file", "bunny_" + std::to_string(elements) + ".msh"}}.dump();
        const std::vector<PairTimes> runs = timed_runs(file, change, 1, options.quick ? 60 : 200);
        table.add({static_cast<long>(elements), runs[0].pairs_per_step, runs[0].vertex_face.with_cpf(),
                   runs[0].edge_edge.with_cpf()});
    }
    report.table("cost_growth", table);
    report.page_table("cost_growth", table, 3);
}

struct WholeStep {
    double detect = 0, handle = 0, step = 0, pairs = 0;  ///< [ms]
};

WholeStep time_steps(const std::filesystem::path& file, const std::string& change,
                     Solver (*make)(const ContactParameters&), int steps)
{
    Scene scene = load_scene(file, change);
    double pairs = 0;
    WatchProbe watch([&](const World&, const Contacts& contacts, double) {
        pairs += static_cast<double>(contacts.size());
    });
    const RunResult result = run(scene, make(scene.contact), {&watch}, {.steps = steps});
    const Timings& t = result.timings;
    const double per_step = 1000.0 / result.steps;
    WholeStep whole;
    whole.detect = per_step *
                   (t.of("broad phase") + t.of("queries") + t.of("categorise new") + t.of("admit new pairs") +
                    t.of("edge pairs of entries") + t.of("closest points") + t.of("detect planes"));
    whole.step = per_step * t.total();
    whole.handle = whole.step - whole.detect -
                   per_step * (t.of("predict") + t.of("update prediction") + t.of("commit"));
    whole.pairs = pairs / (steps + 1);
    return whole;
}

/// What the thesis wanted and could not do: DPF on discrete detection with the closest point against CPF on
/// continuous detection, in the same scenes without friction.
void compare_whole_steps(const RunOptions& options, Report& report)
{
    struct Method {
        std::string name;
        Solver (*make)(const ContactParameters&);
    };
    const std::vector<Method> methods{{"DPF, discrete, closest point", discrete_solver},
                                      {"CPF, continuous (chapter 3)", chapter03_solver},
                                      {"CPF, continuous, redefinition", chapter06_solver}};
    Table table({"scene", "method", "pairs", "detect [ms]", "handle [ms]", "contact [ms]", "step [ms]",
                 "contact / DPF's", "step / DPF's"});
    for (const std::string scene : {"bunny_at_rest", "hooked"}) {
        WholeStep discrete;
        for (const Method& method : methods) {
            nlohmann::json change{{"contact", {{"friction", {{"model", "none"}}}}}};
            // two of the methods let the bunny through the bowl: the ground is as soft for it as the bowl
            if (scene == "bunny_at_rest")
                change["/planes/ground/stiffness"] = load_scene(scene_file(scene)).contact.stiffness;
            const WholeStep whole = time_steps(scene_file(scene), change.dump(), method.make,
                                               options.quick       ? 30
                                               : scene == "hooked" ? 300
                                                                   : 200);
            const double contact = whole.detect + whole.handle;
            if (method.make == discrete_solver)
                discrete = whole;
            const double ratio = contact / (discrete.detect + discrete.handle);
            table.add({scene, method.name, whole.pairs, whole.detect, whole.handle, contact, whole.step,
                       ratio, whole.step / discrete.step});
            if (method.make == chapter06_solver)
                report.fact("cost", scene + "_contact_ratio", ratio, 2);
        }
    }
    report.table("whole_steps", table);
    report.page_table("whole_steps", table, 3);
}

}  // namespace

void cost(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bunny_at_rest"));
    compose(options, file, report);
    grow(options, file, report);
    compare_whole_steps(options, report);
}

}  // namespace enduring::chapter06
