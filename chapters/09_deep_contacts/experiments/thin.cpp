#include "chapters/06_redefinition/solver.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/thin_shots.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>
#include <array>

namespace enduring::chapter09 {
namespace {

using MakeSolver = Solver (*)(const ContactParameters&);

/// Fast shots leave some problems unsolved: how many is counted by what comes of it, not told on stderr.
Solver quiet_chapter08(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter08_solver(parameters, settings);
}

Solver quiet_chapter09(const ContactParameters& parameters)
{
    ImplicitSettings settings;
    settings.record = [](const SolveRecord&) {};
    return chapter09_solver(parameters, settings);
}

struct Hit {
    bool through = false;   ///< the shot came out on the other side
    double max_energy = 0;  ///< kinetic, over that at first, after any step
};

Hit hit_of(ThinShot& shot, MakeSolver make, const std::vector<Probe*>& more = {})
{
    Hit hit;
    double before = 0;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const double energy = total_energy(world).kinetic;
        before = world.step == 0 ? energy : before;
        hit.max_energy = std::max(hit.max_energy, energy / before);
        hit.through = hit.through || is_through(shot, world);
    });
    std::vector<Probe*> probes{&watch};
    probes.insert(probes.end(), more.begin(), more.end());
    run(shot.scene, make(shot.scene.contact), probes, failure_on_purpose());
    return hit;
}

void show_a_shot(Report& report)
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
        hit_of(shot, quiet_chapter09, {&film});
        rows.push_back({film.all(3), thin_targets()[target].name});
    }
    write_png(strip(rows, 1), report.file("thin.png"));
}

/// What many shots of one body at one target came to.
struct Volley {
    long through = 0, gains = 0;
    double max_energy = 0;
};

Volley volley_of(const ThinTarget& target, const std::string& body, MakeSolver make, int trials)
{
    Volley volley;
    std::mt19937_64 random(7);  // the same shots for each solver
    for (int trial = 0; trial < trials; ++trial) {
        ThinShot shot = shot_at_random(target, body, random);
        const Hit hit = hit_of(shot, make);
        volley.through += hit.through;
        volley.max_energy = std::max(volley.max_energy, hit.max_energy);
        volley.gains += hit.max_energy > 1.001;
    }
    return volley;
}

}  // namespace

/// Shots at thin bodies, from both sides: how many come out on the wrong one.
void thin(const RunOptions& options, Report& report)
{
    const int trials = options.quick ? 4 : 120;
    constexpr std::array<MakeSolver, 3> solvers{chapter06_solver, quiet_chapter08, quiet_chapter09};
    const std::size_t bodies = thin_shots().size(), rows = thin_targets().size() * bodies;
    const auto volleys = sweep<Volley>(options, "thin", rows * solvers.size(), [&](std::size_t i) {
        const std::size_t row = i / solvers.size();
        return volley_of(thin_targets()[row / bodies], thin_shots()[row % bodies],
                         solvers[i % solvers.size()], trials);
    });
    if (!volleys)
        return;
    Table table({"target", "shot", "trials", "through_with_6", "through_with_8", "through_with_9",
                 "max_energy_ratio_with_9", "gains_with_9"});
    std::array<long, 3> all{};
    long gains = 0;
    double most = 0;
    for (std::size_t row = 0; row < rows; ++row) {
        const Volley* const by = &(*volleys)[row * solvers.size()];
        table.add({thin_targets()[row / bodies].name, thin_shots()[row % bodies], static_cast<long>(trials),
                   by[0].through, by[1].through, by[2].through, by[2].max_energy, by[2].gains});
        for (std::size_t i = 0; i < solvers.size(); ++i)
            all[i] += by[i].through;
        gains += by[2].gains;
        most = std::max(most, by[2].max_energy);
    }
    const long shots = static_cast<long>(rows) * trials;
    show_a_shot(report);
    report.table("thin", table);
    report.page_table("thin", table);
    report.fact("thin", "shots", static_cast<double>(shots), 6);
    report.fact("thin", "max_energy", most);
    report.fact("thin", "gains", static_cast<double>(gains), 6);
    report.fact("thin", "through_6", static_cast<double>(all[0]), 6);
    report.fact("thin", "through_8", static_cast<double>(all[1]), 6);
    report.fact("thin", "through_9", static_cast<double>(all[2]), 6);
}

}  // namespace enduring::chapter09
