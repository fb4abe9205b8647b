#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/report/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace enduring::chapter08 {
namespace {

/// By how much its own weight strains it, roughly.
double own_strain(const chapter07::SoftCube& cube)
{
    return cube.mass * 9.81 / cube.young;
}  // rho g L / E, L = 1 m

bool is_firm(const chapter07::SoftCube& cube) { return own_strain(cube) < 0.05; }

/// Long enough for its swinging to die away, where its own weight strains it by less than a twentieth [s]. A
/// mode of angular frequency w decays with damping w^2 / 2. Along the cube w^2 is about g over the strain,
/// aside the cube swings half as fast; seven of these times are a factor of a thousand.
double duration_for(const chapter07::SoftCube& cube)
{
    const double decay = 0.5 * chapter07::soft_damping * 0.25 * 9.81 / own_strain(cube);
    return is_firm(cube) ? std::max(4.0, 7 / decay) : 4;
}

std::vector<chapter07::SoftCube> all_cubes(bool quick)
{
    std::vector<chapter07::SoftCube> cubes;
    const std::map<int, std::vector<double>> steps{{2, {0.001, 0.002, 0.005, 0.01}},
                                                   {3, {0.001, 0.002, 0.005, 0.01}},
                                                   {5, {0.002, 0.005, 0.01}},
                                                   {8, {0.005, 0.01}}};  // by the cells; fine ones take long
    for (const auto& [cells, of_cells] : steps)
        for (const double young : {1e4, 1e5, 1e6, 1e7, 1e8})
            for (const double dt : of_cells)
                for (const double mass : {1.0, 10.0, 100.0, 300.0, 1000.0})
                    if (!quick || (cells < 5 && dt >= 0.005 && (mass == 10 || mass == 100) &&
                                   (young == 1e5 || young == 1e7)))
                        cubes.push_back({cells, young, dt, mass});
    return cubes;
}

}  // namespace

/// Does a soft cube creep where it should hold, whatever its mesh, stiffness, mass and step are? Those that
/// their own weight strains by a twentieth or more still swing when the others have long been at rest.
void creep(const RunOptions& options, Report& report)
{
    const std::vector<chapter07::SoftCube> cubes = all_cubes(options.quick);
    const auto outcomes = sweep<chapter07::PileOutcome>(options, "creep", cubes.size(), [&](std::size_t i) {
        Scene scene = chapter07::soft_cube_on_triangles(cubes[i], 0.3);
        return chapter07::watch(scene, duration_for(cubes[i]), chapter08_solver);
    });
    if (!outcomes)
        return;
    Table table({"cells", "young_pa", "dt_s", "mass_kg", "own_strain", "creep_um_per_s", "deepest_mm",
                 "energy_gain_j", "max_newton_steps", "newton_steps_at_rest", "unconverged", "solves"});
    double fastest = 0, deepest = 0;
    long firm = 0, still = 0, shallow = 0, unconverged = 0;
    for (std::size_t i = 0; i < cubes.size(); ++i) {
        const chapter07::SoftCube& cube = cubes[i];
        const chapter07::PileOutcome& outcome = (*outcomes)[i];
        table.add({static_cast<long>(cube.cells), cube.young, cube.dt, cube.mass, own_strain(cube),
                   outcome.drift_um_per_s, outcome.deepest_mm, outcome.energy_gain_j,
                   static_cast<long>(outcome.solves.max_newton_steps), outcome.newton_steps_at_rest,
                   outcome.solves.unconverged, outcome.solves.solves});
        unconverged += outcome.solves.unconverged;
        if (!is_firm(cube))
            continue;
        ++firm;
        fastest = std::max(fastest, outcome.drift_um_per_s);
        deepest = std::max(deepest, outcome.deepest_mm);
        still += outcome.drift_um_per_s < 1;
        shallow += outcome.deepest_mm < 5;
    }
    report.table("creep", table);
    report.fact("creep", "runs", static_cast<double>(table.rows().size()));
    report.fact("creep", "firm", static_cast<double>(firm));
    report.fact("creep", "still", static_cast<double>(still));
    report.fact("creep", "shallow", static_cast<double>(shallow));
    report.fact("creep", "fastest_um_per_s", fastest, 2);
    report.fact("creep", "deepest_mm", deepest, 2);
    report.fact("creep", "unconverged", static_cast<double>(unconverged));
}

}  // namespace enduring::chapter08
