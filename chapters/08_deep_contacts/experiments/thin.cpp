#include "chapters/06_redefinition/solver.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/thin_shots.hpp"
#include "chapters/08_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <array>

namespace enduring::chapter08 {
namespace {

using MakeSolver = Solver (*)(const ContactParameters&);

/// Fast shots leave some problems unsolved: how many is counted by what comes of it, not told on stderr.
Solver quiet_chapter07(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter07_solver(parameters, settings);
}

Solver quiet_chapter08(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter08_solver(parameters, settings);
}

struct Hit {
    bool through = false;    ///< the shot came out on the other side
    double most_energy = 0;  ///< kinetic, over that at first, after any step
};

Hit hit_of(ThinShot& shot, MakeSolver make, const std::vector<Probe*>& more = {})
{
    Hit hit;
    double before = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const double energy = total_energy(world).kinetic;
        before = world.step == 0 ? energy : before;
        hit.most_energy = std::max(hit.most_energy, energy / before);
        hit.through = hit.through || is_through(shot, world);
    });
    std::vector<Probe*> probes{&watch};
    probes.insert(probes.end(), more.begin(), more.end());
    run(shot.scene, make(shot.scene.contact), probes, failure_on_purpose());
    return hit;
}

void show(Report& report)
{
    std::vector<StripPicture> rows;
    for (const std::size_t target : {0U, 3U}) {
        std::mt19937_64 random(4);
        ThinShot shot = shot_at_random(thin_targets()[target], "cube", random);
        while (shot.side < 0)
            shot = shot_at_random(thin_targets()[target], "cube", random);
        shot.scene.camera = {{0.6, 2.6, 1.2}, {0, 0, 0}, 34};
        const double end = shot.scene.duration;
        StripProbe film(shot.scene, {0, end / 3, end}, mark_contacts, 360, 250);
        hit_of(shot, quiet_chapter08, {&film});
        rows.push_back({film.all(3), thin_targets()[target].name});
    }
    write_png(strip(rows, 1), report.file("thin.png"));
}

}  // namespace

/// Shots at thin bodies, from both sides: how many come out on the wrong one.
void thin(const RunOptions& options, Report& report)
{
    constexpr std::array<MakeSolver, 3> solvers{chapter06_solver, quiet_chapter07, quiet_chapter08};
    GrowingTable table(report, "thin",
                       {"target", "shot", "trials", "through_with_6", "through_with_7", "through_with_8",
                        "most_energy_ratio_with_8", "gains_with_8"},
                       thin_targets().size() * thin_shots().size());
    const int trials = options.quick ? 4 : 120;
    std::array<long, 3> all{};
    long shots = 0, gains = 0;
    double most = 0;
    for (const ThinTarget& target : thin_targets())
        for (const std::string& body : thin_shots()) {
            std::array<long, 3> through{};
            long gains_here = 0;
            double most_here = 0;
            for (std::size_t i = 0; i < solvers.size(); ++i) {
                std::mt19937_64 random(7);
                for (int trial = 0; trial < trials; ++trial) {
                    ThinShot shot = shot_at_random(target, body, random);
                    const Hit hit = hit_of(shot, solvers[i]);
                    through[i] += hit.through;
                    if (i == 2) {
                        most_here = std::max(most_here, hit.most_energy);
                        gains_here += hit.most_energy > 1.001;
                    }
                }
                all[i] += through[i];
            }
            table.add({target.name, body, static_cast<long>(trials), through[0], through[1], through[2],
                       most_here, gains_here});
            shots += trials;
            gains += gains_here;
            most = std::max(most, most_here);
        }
    show(report);
    report.table("thin", table);
    report.page_table("thin", table);
    report.fact("thin", "shots", static_cast<double>(shots), 6);
    report.fact("thin", "most_energy", most);
    report.fact("thin", "gains", static_cast<double>(gains), 6);
    report.fact("thin", "through_6", static_cast<double>(all[0]), 6);
    report.fact("thin", "through_7", static_cast<double>(all[1]), 6);
    report.fact("thin", "through_8", static_cast<double>(all[2]), 6);
}

}  // namespace enduring::chapter08
