#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/run/run.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace enduring::chapter09 {
namespace {

struct RammedWith {
    std::string name;
    Solver (*make)(const ContactParameters&);
};
const std::vector<RammedWith> all_solvers{{"chapter 6", chapter06_solver},
                                          {"chapter 7", chapter07_solver},
                                          {"chapter 8", chapter08_solver},
                                          {"chapter 9", chapter09_solver}};

/// What becomes of the kinetic energy with which the cube rams the block, weightless.
struct Ram {
    double after = 0, most = 0;  ///< at the end and after any step, over that at first
    double across = 0;           ///< of the last velocity [m/s]: off the line on which the cube came
};

struct Variant {
    double speed, dt, z;  ///< z: how far the cube comes beside the middle of the block [m]
};

Scene ram_scene(const Variant& variant)
{
    return load_scene(scene_file("deep"), R"({"dt": )" + shortest(variant.dt) +
                                              R"(, "/bodies/cube/velocity": [)" + shortest(variant.speed) +
                                              R"(, 0, 0], "/bodies/cube/position": [-0.22, -0.15, )" +
                                              shortest(variant.z) + "]}");
}

/// @param times  time_s, solver, energy_ratio: gets a row a step, if there is one
Ram ram(const RammedWith& compared, const Variant& variant, Table* times = nullptr)
{
    Scene scene = ram_scene(variant);
    Ram result;
    double before = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const Body& cube = body_named(world, "cube");
        const double energy = cube.energy(world.gravity).kinetic;
        before = world.step == 0 ? energy : before;
        result.after = energy / before;
        result.most = std::max(result.most, result.after);
        const Vec3 velocity = cube.mean_velocity();
        result.across = std::hypot(velocity.y(), velocity.z());
        if (times != nullptr)
            times->add({world.time, compared.name, result.after});
    });
    run(scene, compared.make(scene.contact), {&watch}, failure_on_purpose());
    return result;
}

/// The ram at 3 m/s under chapter 6's solver and under this chapter's.
void show_ram(Report& report)
{
    constexpr Variant shown{3, 0.005, 0.03};
    Table times({"time_s", "solver", "energy_ratio"});
    std::vector<StripPicture> rows;
    for (const RammedWith& compared : {all_solvers.front(), all_solvers.back()}) {
        ram(compared, shown, &times);
        Scene scene = ram_scene(shown);
        StripProbe film(scene, {0, 0.06, 0.3}, mark_contacts, 420, 300);
        run(scene, compared.make(scene.contact), {&film}, failure_on_purpose());
        rows.push_back({film.all(3), compared.name});
    }
    write_png(strip(rows, 1), report.file("deep.png"));
    report.table("deep_energy", times);
    report.plot("chapters/09_deep_contacts/plots/deep_energy.gp");
}

std::vector<Variant> variants(double speed, bool quick)
{
    std::vector<Variant> all;
    for (const double dt : {0.005, 0.01})
        for (const double z : {0.03, 0.13, -0.27})
            if (!quick || (dt == 0.005 && z == 0.03))
                all.push_back({speed, dt, z});
    return all;
}

}  // namespace

/// A cube that rams a block, under one solver after the other.
void deep(const RunOptions& options, Report& report)
{
    Table table({"speed_m_per_s", "solver", "energy_ratio", "max_energy_ratio", "across_m_per_s"});
    std::map<std::string, double> worst;
    for (const double speed : {0.5, 1.0, 2.0, 3.0, 5.0, 10.0})
        for (const RammedWith& compared : all_solvers) {
            Ram most;
            for (const Variant& variant : variants(speed, options.quick)) {
                const Ram result = ram(compared, variant);
                most.after = std::max(most.after, result.after);
                most.most = std::max(most.most, result.most);
                most.across = std::max(most.across, result.across);
            }
            table.add({speed, compared.name, most.after, most.most, most.across});
            worst[compared.name] = std::max(worst[compared.name], most.after);
        }
    show_ram(report);
    report.table("deep", table);
    report.page_table("deep", table, 3);
    for (const auto& [name, ratio] : worst) {
        std::string word = name;
        std::erase_if(word, [](char c) { return c == ',' || c == ' '; });
        report.fact("deep", word + "_worst", ratio, 3);
    }
}

}  // namespace enduring::chapter09
