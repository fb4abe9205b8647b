#include "chapters/07_implicit_contact/solver.hpp"
#include "chapters/09_deep_contacts/experiments/draw_crossing.hpp"
#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/inside_scenes.hpp"
#include "chapters/09_deep_contacts/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/report/growing_table.hpp"
#include "common/experiments/run/run.hpp"
#include "common/experiments/run/spring_ledger.hpp"
#include "common/simulation/energy.hpp"

#include <algorithm>

namespace enduring::chapter09 {
namespace {

/// How a body comes out; of several runs the worst of each.
struct Release {
    double height = -1e9;   ///< of the lowest vertex at the end [m]
    double highest = -1e9;  ///< that after any step
    double fastest = 0;     ///< its centre of mass, while a vertex is more than 1 mm deep [m/s]
    double rising = 0;      ///< fastest upwards, while a vertex is more than 1 mm deep [m/s]
    double moving = 0;      ///< last time that it was faster than 1 cm/s [s]
    double energy = -1e9;   ///< of all bodies, at most [J]
    long left = 0;          ///< 1 if a vertex is more than 1 mm deep at the end

    void worsen(const Release& other)
    {
        highest = std::max(highest, other.highest);
        fastest = std::max(fastest, other.fastest);
        rising = std::max(rising, other.rising);
        moving = std::max(moving, other.moving);
        energy = std::max(energy, other.energy);
        left += other.left;
    }
};

/// How many of a run's problems were solved, and how many were not solved to a millionth.
struct Solves {
    long all = 0, unconverged = 0;
};

ImplicitSettings counting(Solves& solves)
{
    ImplicitSettings settings;
    settings.record = [&solves](const SolveRecord& record) {
        ++solves.all;
        solves.unconverged += !record.converged;
    };
    return settings;
}

Release watch(Scene& scene, const Solver& solver, double duration, const std::vector<Probe*>& more = {})
{
    Release release;
    bool inside = true;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        const double speed = world.bodies.back()->mean_velocity().norm();
        release.height = lowest_vertex(world);
        release.highest = std::max(release.highest, release.height);
        release.energy = std::max(release.energy, total_energy(world).total());
        release.moving = speed > 0.01 ? world.time : release.moving;
        inside = inside && deepest_inside(world) > 1e-3;
        release.fastest = std::max(release.fastest, inside ? speed : 0);
        release.rising = std::max(release.rising, inside ? world.bodies.back()->mean_velocity().y() : 0);
    });
    std::vector<Probe*> probes{&watch};
    probes.insert(probes.end(), more.begin(), more.end());
    run(scene, solver, probes, failure_on_purpose({.steps = static_cast<int>(duration / scene.dt + 0.5)}));
    release.left = deepest_inside(scene.world) > 1e-3;
    return release;
}

//! [against_a_twin]
/// How a body comes out, measured against a twin that begins just above and falls to its place of rest:
/// heights over that place, energy over the most that the twin has.
Release release_of(const Surroundings& surroundings, const std::string& body, double depth, double dt,
                   Solves& solves)
{
    constexpr double above = 1e-4;
    Scene twin = scene_inside(surroundings, body, -above, dt),
          scene = scene_inside(surroundings, body, depth, dt);
    const Release landed = watch(twin, chapter09_solver(twin.contact, counting(solves)), 2);
    Release release = watch(scene, chapter09_solver(scene.contact, counting(solves)), 4);
    release.height -= landed.height;
    release.highest -= landed.height;
    release.energy -= landed.energy;
    return release;
}
//! [against_a_twin]

/// How fast the leaning block leaves the floor, in which it is wholly inside, if springs begin at the surface
/// and not at their depth [m/s].
double fastest_without_offset()
{
    Scene scene = scene_inside(all_surroundings()[0], "leaning block", 0.4, 0.01);
    Solves solves;
    Solver solver = chapter09_solver(scene.contact, counting(solves));
    solver.append(StepStage::refresh, "no rest offset", [](World&, Contacts& contacts, double) {
        for (Contact& contact : contacts)
            contact.spring.rest_offset = 0;
    });
    return watch(scene, solver, 2).fastest;
}

/// The leaning block, 30 cm deep: pictures, a film, and the accounts of its energy over time.
void show_leaning_block(const RunOptions& options, Report& report)
{
    Scene scene = scene_inside(all_surroundings()[0], "leaning block", 0.3, 0.01);
    const MarkContacts mark = [](Stage& stage, const World& world, const Contacts&) {
        mark_crossing(stage, world);
    };
    StripProbe pictures(scene, {0, 0.3, 0.6, 2}, mark, 400, 284);
    ClipProbe film(scene, report.file("initial_overlap.webp"), options.quick ? 4 : 20, 480, 344,
                   {.slow_motion = 2, .until = 2, .mark = mark});
    SpringLedger ledger(scene.world, scene.contact.stiffness, scene.contact.max_depenetration_velocity);
    const double before = total_energy(scene.world).total();
    Table table({"time_s", "bodies_j", "lifted_j", "damped_j", "rubbed_j", "brought_j"});
    WatchProbe accounts([&](const World& world, const Contacts& contacts, double dt) {
        if (world.step > 0)
            ledger.add_step(world, contacts, dt);
        const SpringAccounts& sums = ledger.accounts();
        table.add({world.time, total_energy(world).total() - before, sums.lifted, -sums.damped, sums.rubbed,
                   sums.brought()});
    });
    Solves solves;
    watch(scene, chapter09_solver(scene.contact, counting(solves)), 2.2, {&pictures, &film, &accounts});
    write_png(pictures.all(2), report.file("initial_overlap.png"));
    film.finish();
    report.table("depenetration_energy", table);
    report.plot("chapters/09_deep_contacts/plots/depenetration_energy.gp");
    const SpringAccounts& sums = ledger.accounts();
    report.fact("initial_overlap", "lifted", sums.lifted);
    report.fact("initial_overlap", "gained", total_energy(scene.world).total() - before);
    report.fact("initial_overlap", "brought", sums.brought());
}

/// One run in each of the surroundings in which the body begins 30 cm deep.
void show_surroundings(Report& report)
{
    std::vector<StripPicture> rows;
    for (const Surroundings& surroundings : all_surroundings()) {
        Scene scene = scene_inside(surroundings, surroundings.inner.back(), 0.3, 0.01);
        if (surroundings.name == "bowl")
            scene.camera = {{1.2, 2.6, 1.8}, {0, 0.25, 0}, 30};
        StripProbe film(
            scene, {0, 0.4, 2}, [](auto&&...) {}, 320, 220);
        Solves solves;
        watch(scene, chapter09_solver(scene.contact, counting(solves)), 2, {&film});
        rows.push_back({film.all(3), surroundings.name});
    }
    write_png(strip(rows, 1), report.file("surroundings.png"));
}

std::vector<double> depths_for(double height, bool quick)
{
    if (quick)
        return {0.001, 0.4};
    return {0.001, 0.01, 0.05, 0.1, 0.4, height + 0.05};
}

}  // namespace

/// Bodies that begin inside something else, from a millimetre to wholly: what becomes of them.
void initial_overlap(const RunOptions& options, Report& report)
{
    GrowingTable table(report, "initial_overlap",
                       {"inside", "body", "dt_s", "depth_mm", "height_mm", "highest_mm", "fastest_m_per_s",
                        "last_moving_s", "excess_energy_j", "left_inside"});
    Table page({"inside", "body", "runs", "highest_mm", "fastest_m_per_s", "last_moving_s", "excess_energy_j",
                "left_inside"});
    Solves solves;
    Release worst;
    double at_rest = 0;  // of those that do not roll
    for (const Surroundings& surroundings : all_surroundings())
        for (const std::string& body : surroundings.inner) {
            Release of_body;
            long runs = 0;
            for (const double dt :
                 options.quick ? std::vector<double>{0.01} : std::vector<double>{0.01, 1.0 / 60})
                for (const double depth : depths_for(height_of(surroundings, body), options.quick)) {
                    const Release release = release_of(surroundings, body, depth, dt, solves);
                    table.add({surroundings.name, body, dt, 1000 * depth, 1000 * release.height,
                               1000 * release.highest, release.fastest, release.moving, release.energy,
                               release.left});
                    of_body.worsen(release);
                    ++runs;
                }
            page.add({surroundings.name, body, runs, 1000 * of_body.highest, of_body.fastest, of_body.moving,
                      of_body.energy, of_body.left});
            worst.worsen(of_body);
            if (body != "ball")
                at_rest = std::max(at_rest, of_body.moving);
        }
    show_leaning_block(options, report);
    show_surroundings(report);
    report.table("initial_overlap", table);
    report.page_table("initial_overlap", page);
    report.fact("initial_overlap", "thrown", fastest_without_offset());
    report.fact("initial_overlap", "highest_mm", 1000 * worst.highest);
    report.fact("initial_overlap", "fastest", worst.fastest);
    report.fact("initial_overlap", "rising", worst.rising);
    report.fact("initial_overlap", "at_rest", at_rest);
    report.fact("initial_overlap", "energy_over", worst.energy);
    report.fact("initial_overlap", "solves", static_cast<double>(solves.all), 6);
    report.fact("initial_overlap", "unconverged", static_cast<double>(solves.unconverged), 6);
    report.fact("initial_overlap", "left", static_cast<double>(worst.left));
}

}  // namespace enduring::chapter09
