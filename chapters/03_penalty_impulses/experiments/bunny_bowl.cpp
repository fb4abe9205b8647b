#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/experiments/pair_film.hpp"
#include "chapters/03_penalty_impulses/experiments/scene_change.hpp"
#include "chapters/03_penalty_impulses/solver.hpp"
#include "common/experiments/run/elements_of.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace enduring::chapter03 {
namespace {

/// Pairs that are inside, on the plane or between bodies.
long count_inside(const World& world, const Contacts& contacts, bool on_plane)
{
    return std::count_if(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.on_plane() == on_plane && contact_geometry(world, contact, 0).depth < 0;
    });
}

/// time_s, pairs (of bunny and bowl), depth_sum_m, depth_max_m (planes
/// counted), plane_depth_m, kinetic_j, total_j, inverted.
class BunnyProbe final : public TableProbe {
public:
    explicit BunnyProbe(double stiffness)
        : TableProbe({"time_s", "pairs", "depth_sum_m", "depth_max_m", "plane_depth_m", "kinetic_j",
                      "total_j", "inverted"}),
          penetration_(stiffness)
    {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        penetration_.observe(world, contacts, dt);
        const std::vector<Cell>& depths = penetration_.table().rows().back();
        const Energy energy = total_energy(world);
        int inverted = 0;
        for (const auto& body : world.bodies)
            inverted += body->inverted_elements();
        table_.add({world.time, count_inside(world, contacts, false), depths[3], depths[4], depths[8],
                    energy.kinetic, energy.total(), static_cast<long>(inverted)});
        if (world.step == 0)
            first_energy_ = energy.total();
        highest_energy_ = std::max(highest_energy_, energy.total() / first_energy_);
        max_inverted_ = std::max(max_inverted_, inverted);
        steps_with_inverted_ += inverted > 0;
        kinetic_ = energy.kinetic;
        deepest_in_ground_ = std::max(deepest_in_ground_, std::get<double>(depths[8]));
        add_levers(world, contacts);
    }

    double highest_energy() const { return highest_energy_; }  ///< over that at the start
    int max_inverted() const { return max_inverted_; }         ///< elements in one step
    int steps_with_inverted() const { return steps_with_inverted_; }
    double kinetic() const { return kinetic_; }                      ///< at the end [J]
    double deepest_in_ground() const { return deepest_in_ground_; }  ///< of all steps [m]
    /// of the impulses that turn the whole by (p - q) x I [m]
    double mean_lever() const { return turned_ / pushed_; }

private:
    void add_levers(const World& world, const Contacts& contacts)
    {
        for (const Contact& contact : contacts)
            if (!contact.on_plane()) {
                const ContactGeometry geometry = contact_geometry(world, contact, 0);
                turned_ += (geometry.p - geometry.q).cross(contact.impulse).norm();
                pushed_ += contact.impulse.norm();
            }
    }

    PenetrationProbe penetration_;
    double turned_ = 0, pushed_ = 1e-300;
    double first_energy_ = 1, highest_energy_ = 0, kinetic_ = 0, deepest_in_ground_ = 0;
    int max_inverted_ = 0, steps_with_inverted_ = 0;
};

nlohmann::json with_elements(int elements)
{
    return {{"/bodies/bunny/shape/file", "bunny_" + std::to_string(elements) + ".msh"}};
}

/// A body whose energy has grown tenfold will not calm down again, and its flying vertices cost queries.
RunLimits until_it_explodes(const BunnyProbe& probe, double duration, double dt)
{
    RunLimits limits;
    limits.steps = static_cast<int>(duration / dt + 0.5);
    limits.stop = [&probe](const World&, const Contacts&) { return probe.highest_energy() > 10; };
    return limits;
}

/// How heavy the bunny's surface vertices are against an impulse, and how many are too light
/// for the step: chapter 1's k dt^2 < 2 m for each. Before the first step each answers with
/// the mass of its nodes alone, later through its elements.
void tell_masses(const Scene& scene, const std::string& when, Report& report)
{
    const Body& bunny = body_named(scene.world, "bunny");
    const double limit = 0.5 * scene.contact.stiffness * scene.dt * scene.dt;
    std::vector<double> masses;
    for (int v = 0; v < bunny.surface().vertex_count(); ++v)
        masses.push_back(1 / bunny.inverse_mass(v)(0, 0));
    std::sort(masses.begin(), masses.end());
    const auto too_light = std::lower_bound(masses.begin(), masses.end(), limit) - masses.begin();
    report.fact("bunny_bowl", "light_below_g", 1000 * limit, 2);
    report.fact("bunny_bowl", "lightest_" + when + "_g", 1000 * masses.front(), 1);
    report.fact("bunny_bowl", "heaviest_" + when + "_g", 1000 * masses.back(), 2);
    report.fact("bunny_bowl", "light_" + when + "_percent",
                100 * static_cast<double>(too_light) / static_cast<double>(masses.size()), 2);
}

/// How the bunny lies in the bowl and the bowl on the ground at the end, and
/// whether either contact is too stiff for the step.
void tell_rest(const Scene& scene, const Contacts& contacts, const BunnyProbe& probe, Report& report)
{
    const World& world = scene.world;
    const std::vector<Cell>& end = probe.table().rows().back();
    const double bunny = body_named(world, "bunny").mass(), bowl = body_named(world, "bowl").mass(),
                 reduced = bunny * bowl / (bunny + bowl);
    const double nk = static_cast<double>(std::get<long>(end[1])) * scene.contact.stiffness;
    report.fact("bunny_bowl", "pairs_at_end", static_cast<double>(std::get<long>(end[1])), 3);
    report.fact("bunny_bowl", "nk_at_end", nk / 1000, 2);
    report.fact("bunny_bowl", "step", scene.dt, 3);
    report.fact("bunny_bowl", "k_dt2_kg", scene.contact.stiffness * scene.dt * scene.dt, 2);
    report.fact("bunny_bowl", "stable_step_at_end", std::sqrt(2 * reduced / nk), 2);
    report.fact("bunny_bowl", "deepest_at_end_mm", 1000 * std::get<double>(end[3]), 2);
    report.fact("bunny_bowl", "ground_at_end_mm", 1000 * std::get<double>(end[4]), 2);
    report.fact("bunny_bowl", "ground_at_most_mm", 1000 * probe.deepest_in_ground(), 2);
    if (world.planes.empty())
        return;
    const double feet = static_cast<double>(count_inside(world, contacts, true)),
                 k = world.planes[0].stiffness.value_or(scene.contact.stiffness);
    report.fact("bunny_bowl", "feet", feet, 3);
    report.fact("bunny_bowl", "ground_stiffness", k, 3);
    report.fact("bunny_bowl", "ground_share", feet * k * scene.dt * scene.dt / bowl, 2);
}

/// Cost and outcome of one run; the only numbers of this experiment that a clock takes part in.
void add_cost(Table& costs, int elements, const RunResult& result, double dt, const BunnyProbe& probe)
{
    const double per_step = 1000.0 / result.steps;
    const Timings& timings = result.timings;
    const double contact = timings.total() - timings.of("predict") - timings.of("update prediction") -
                           timings.of("commit");
    costs.add({static_cast<long>(elements), per_step * timings.of("predict"),
               per_step * timings.of("update prediction"), per_step * timings.of("broad phase"),
               per_step * timings.of("queries"), per_step * timings.of("impulses"), per_step * contact,
               per_step * timings.total(), result.steps * dt / timings.total(),
               static_cast<long>(probe.max_inverted())});
}

struct ResponseCase {
    std::string basis, response;
    double dt;
};

/// The same fall where each node takes its impulse by its own mass alone, as the thesis
/// does, and through the elasticity. A quadratic bunny has four times as many faces in
/// contact, so a pair of it has a quarter of the stiffness.
void compare_responses(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    std::vector<ResponseCase> cases;
    for (const std::string basis : {"linear", "quadratic"})
        for (const std::string response : {"lumped", "implicit"})
            for (const double dt : {0.01, 0.005, 0.002})
                if (dt == 0.01 || (!options.quick && (basis == "linear" || dt == 0.005)))
                    cases.push_back({basis, response, dt});
    if (options.quick)
        cases.resize(2);
    Table table({"elements", "response", "dt_s", "stiffness_n_per_m", "outcome", "highest energy / first",
                 "most inverted", "steps with inverted", "deepest at 1.5 s [mm]"});
    const double of_linear = load_scene(file).contact.stiffness;
    for (const ResponseCase& c : cases) {
        nlohmann::json change{
            {"/bodies/bunny",
             {{"impulse_response", c.response}, {"basis", c.basis}, {"solver_tolerance", 1e-5}}}};
        const double stiffness = c.basis == "linear" ? of_linear : of_linear / 4;
        change.update(contact_change(PenaltyMethod::continuous, stiffness, c.dt));
        Scene scene = load_scene(file, change.dump());
        BunnyProbe probe(stiffness);
        run(scene, chapter03_solver(scene.contact), {&probe},
            failure_on_purpose(until_it_explodes(probe, 1.5, c.dt)));
        const bool exploded = probe.highest_energy() > 10;
        table.add({c.basis, c.response, c.dt, stiffness, exploded ? "explodes" : "bounces",
                   probe.highest_energy(), static_cast<long>(probe.max_inverted()),
                   static_cast<long>(probe.steps_with_inverted()),
                   exploded ? Cell("-") : Cell(1000 * std::get<double>(probe.table().rows().back()[3]))});
    }
    report.table("bunny_responses", table);
    report.page_table("bunny_responses", table, 3);
}

}  // namespace

void bunny_bowl(const RunOptions& options, Report& report, int elements)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bunny_bowl"));
    std::vector<int> sizes{elements};
    if (elements == 785 && !options.quick)
        sizes = {363, 785, 1452};

    Table costs({"elements", "predict [ms]", "answer [ms]", "boxes [ms]", "queries [ms]", "impulses [ms]",
                 "all contact [ms]", "step [ms]", "real-time factor", "most inverted"});
    for (const int size : sizes) {
        Scene scene = load_scene(file, with_elements(size).dump());
        BunnyProbe probe(scene.contact.stiffness);
        std::vector<Probe*> probes{&probe};
        std::unique_ptr<PairFilm> film;
        if (size == elements) {
            film = std::make_unique<PairFilm>(scene, std::vector<double>{0.0, 0.3, 0.46, 0.7, 1.2, 2.9},
                                              report, "bunny_bowl", options.quick);
            for (Probe* probe_of_film : film->probes())
                probes.push_back(probe_of_film);
        }
        if (film)
            tell_masses(scene, "alone", report);
        const RunResult result = run(scene, chapter03_solver(scene.contact), probes);
        add_cost(costs, size, result, scene.dt, probe);
        if (!film)
            continue;
        film->finish();
        report.table("bunny_bowl", probe.table());
        report.plot("chapters/03_penalty_impulses/plots/bunny_bowl.gp");
        const Table passes = result.timings.table(scene.world.time, result.steps);
        report.table("bunny_passes", passes);
        report.page_table("bunny_passes", passes, 3);
        report.fact("bunny_bowl", "real_time_factor", result.steps * scene.dt / result.timings.total(), 2);
        report.fact("bunny_bowl", "step_ms", 1000 * result.timings.total() / result.steps, 2);
        report.fact("bunny_bowl", "max_inverted", probe.max_inverted());
        report.fact("bunny_bowl", "kinetic_at_end", probe.kinetic(), 2);
        tell_masses(scene, "together", report);
        report.fact("bunny_bowl", "elements", elements_of(scene.world, "bunny"));
        report.fact("bunny_bowl", "mean_lever_mm", 1000 * probe.mean_lever(), 2);
        tell_rest(scene, result.contacts, probe, report);
    }
    report.table("bunny_costs", costs);
    report.page_table("bunny_costs", costs, 3);
    if (elements == 785)
        compare_responses(options, file, report);
}

}  // namespace enduring::chapter03
