#include "chapters/06_redefinition/experiments/experiments.hpp"
#include "chapters/06_redefinition/experiments/inverted_elements.hpp"
#include "chapters/06_redefinition/solver.hpp"
#include "common/experiments/render/film_probes.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/run/run.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace enduring::chapter06 {
namespace {

/// At rest: this share of the kinetic energy with which the bunny hit the bowl.
constexpr double rest_share = 0.001;

/// time_s, kinetic_j, share (of the impact's; 0 before it), total_j, pairs, held, inverted, depth_max_m
/// (planes counted), plane_depth_m.
class RestProbe final : public TableProbe {
public:
    explicit RestProbe(double stiffness)
        : TableProbe({"time_s", "kinetic_j", "share", "total_j", "pairs", "held", "inverted", "depth_max_m",
                      "plane_depth_m"}),
          penetration_(stiffness)
    {}
    void observe(const World& world, const Contacts& contacts, double dt) override
    {
        penetration_.observe(world, contacts, dt);
        deepest_ = std::get<double>(penetration_.table().rows().back()[4]);
        in_ground_ = std::get<double>(penetration_.table().rows().back()[8]);
        deepest_in_ground_ = std::max(deepest_in_ground_, in_ground_);
        const Energy energy = total_energy(world);
        const auto touches = [](const Contact& contact) { return !contact.on_plane(); };
        if (impact_ == 0 && std::any_of(contacts.begin(), contacts.end(), touches))
            impact_ = last_kinetic_;
        last_kinetic_ = energy.kinetic;
        last_share_ = impact_ > 0 ? energy.kinetic / impact_ : 0;
        if (impact_ == 0 || last_share_ >= rest_share)
            rest_since_ = world.time;
        const int inverted = count_inverted(world);
        max_inverted_ = std::max(max_inverted_, inverted);
        steps_with_inverted_ += inverted > 0;
        if (world.step == 0)
            first_energy_ = energy.total();
        highest_energy_ = std::max(highest_energy_, energy.total() / first_energy_);
        table_.add({world.time, energy.kinetic, last_share_, energy.total(),
                    static_cast<long>(contacts.size()),
                    static_cast<long>(std::count_if(contacts.begin(), contacts.end(),
                                                    [](const Contact& contact) { return contact.held(); })),
                    static_cast<long>(inverted), deepest_, in_ground_});
    }

    /// kinetic energy of all before the bunny touches the bowl [J]
    double impact() const { return impact_; }
    double share() const { return last_share_; }  ///< of it that is left at the end
    /// last time at which more than rest_share was left [s]
    double rest_since() const { return rest_since_; }
    double highest_energy() const { return highest_energy_; }  ///< over that at the start
    int max_inverted() const { return max_inverted_; }
    int steps_with_inverted() const { return steps_with_inverted_; }
    /// pair or vertex in the ground, at the end [m]
    double deepest() const { return deepest_; }
    /// deepest vertex in the ground, at the end [m]
    double in_ground() const { return in_ground_; }
    double deepest_in_ground() const { return deepest_in_ground_; }  ///< of all steps [m]

private:
    PenetrationProbe penetration_;
    double deepest_ = 0, in_ground_ = 0, deepest_in_ground_ = 0;
    double impact_ = 0, last_kinetic_ = 0, last_share_ = 0, rest_since_ = 0, first_energy_ = 1,
           highest_energy_ = 0;
    int max_inverted_ = 0, steps_with_inverted_ = 0;
};

/// The bowl's vertices in the ground would hide the pairs of bunny and bowl.
void mark_feature_pairs(Stage& stage, const World& world, const Contacts& contacts)
{
    Contacts pairs;
    std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(pairs),
                 [](const Contact& contact) { return !contact.on_plane() && !contact.held(); });
    mark_contacts(stage, world, pairs);
}

std::string mesh_change(int elements)
{
    return nlohmann::json{{"/bodies/bunny/shape/file", "bunny_" + std::to_string(elements) + ".msh"}}.dump();
}

/// How fast one size of the bunny runs, and what became of it. The
/// only table here that a clock takes part in.
void add_size(Table& sizes, int elements, const Scene& scene, const RunResult& result, const RestProbe& probe)
{
    const Timings& timings = result.timings;
    const auto per_step = [&](std::initializer_list<const char*> passes) {
        double sum = 0;
        for (const char* pass : passes)
            sum += timings.of(pass);
        return 1000 * sum / result.steps;
    };
    int unknowns = 0;
    for (const auto& body : scene.world.bodies)
        if (const auto* deformable = dynamic_cast<const DeformableBody*>(body.get()))
            unknowns += 3 * deformable->elastic().node_count();
    sizes.add(
        {static_cast<long>(elements), static_cast<long>(unknowns),
         std::get<long>(probe.table().rows().back()[4]), per_step({"predict"}),
         per_step({"update prediction"}),
         per_step({"broad phase", "queries", "categorise new", "admit new pairs", "edge pairs of entries"}),
         per_step({"drop resolved pairs", "redefine vertices", "dismiss edges", "edge pairs of redefinitions",
                   "drop dismissed pairs", "resolve vertices", "edge pairs of exits", "resolve edges"}),
         per_step({"impulses", "friction", "apply impulses", "move friction anchors"}),
         1000 * timings.total() / result.steps, result.steps * scene.dt / timings.total(),
         100 * probe.share(), static_cast<long>(probe.max_inverted())});
}

Table sizes_table()
{
    return Table({"elements", "unknowns", "pairs at the end", "predict [ms]", "answer [ms]", "detect [ms]",
                  "follow, resolve [ms]", "impulses, friction [ms]", "step [ms]", "real-time factor",
                  "kinetic energy left [%]", "most inverted"});
}

/// Six seconds of the scene as it stands, filmed.
void come_to_rest(const RunOptions& options, const std::filesystem::path& file, Report& report, Table& sizes)
{
    Scene scene = load_scene(file);
    RestProbe rest(scene.contact.stiffness);
    StripProbe strip(scene, {0.0, 0.36, 0.5, 0.9, 1.7, scene.duration}, mark_feature_pairs, 560, 400);
    ClipProbe clip(scene, report.file("bunny_bowl.mp4"), options.quick ? 2 : 20);
    const RunResult result = run(scene, chapter06_solver(scene.contact), {&rest, &strip, &clip});
    write_png(strip.all(3), report.file("bunny_bowl.png"));
    clip.finish();
    report.table("bunny_bowl", rest.table());
    report.plot("chapters/06_redefinition/plots/bunny_bowl.gp");
    const Table passes = result.timings.table(scene.world.time, result.steps);
    report.table("bunny_passes", passes);
    report.page_table("bunny_passes", passes, 3);
    add_size(sizes, 785, scene, result, rest);
    report.fact("bunny_bowl", "impact_j", rest.impact());
    report.fact("bunny_bowl", "left_percent", 100 * rest.share(), 2);
    report.fact("bunny_bowl", "rest_since_s", rest.rest_since(), 2);
    report.fact("bunny_bowl", "max_inverted", rest.max_inverted());
    report.fact("bunny_bowl", "steps_with_inverted", rest.steps_with_inverted());
    report.fact("bunny_bowl", "real_time_factor", result.steps * scene.dt / result.timings.total(), 2);
    report.fact("bunny_bowl", "deepest_at_end_mm", 1000 * rest.deepest(), 2);
    report.fact("bunny_bowl", "ground_at_end_mm", 1000 * rest.in_ground(), 2);
    report.fact("bunny_bowl", "ground_at_most_mm", 1000 * rest.deepest_in_ground(), 2);
    report.fact("bunny_bowl", "highest_energy", rest.highest_energy(), 4);
}

void compare_sizes(const std::filesystem::path& file, Report& report, Table& sizes)
{
    for (const int elements : {363, 1452}) {
        Scene scene = load_scene(file, mesh_change(elements));
        RestProbe rest(scene.contact.stiffness);
        const RunResult result = run(scene, chapter06_solver(scene.contact), {&rest});
        add_size(sizes, elements, scene, result, rest);
        report.fact("bunny_bowl", "real_time_factor_" + std::to_string(elements),
                    result.steps * scene.dt / result.timings.total(), 2);
    }
}

struct InversionCase {
    std::string response;
    double dt, stiffness, duration;
};

/// The impact at several stiffnesses, with either response; a picture of the thesis' at its worst moment.
void count_inversions(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    std::vector<InversionCase> cases;
    for (const double stiffness : {50.0, 100.0, 200.0, 400.0, 800.0, 1600.0, 3200.0})
        cases.push_back({"implicit", 0.01, stiffness, 1.0});
    for (const double stiffness : {100.0, 200.0, 400.0})
        cases.push_back({"lumped", 0.002, stiffness, 0.6});
    cases.push_back({"lumped", 0.01, 200, 0.6});
    if (options.quick)
        cases = {{"implicit", 0.01, 200, 0.6}, {"lumped", 0.01, 200, 0.56}};

    const nlohmann::json close_up{
        {"eye", {1.4, 0.9, 1.9}}, {"target", {0, 0.5, 0}}, {"field_of_view_deg", 34}};
    Table table({"response", "dt_s", "stiffness_n_per_m", "most inverted", "steps with inverted [%]",
                 "highest energy / first"});
    Picture worst;
    for (const InversionCase& c : cases) {
        Scene scene = load_scene(file, nlohmann::json{{"dt", c.dt},
                                                      {"contact", {{"stiffness", c.stiffness}}},
                                                      {"/bodies/bunny/impulse_response", c.response},
                                                      {"camera", close_up}}
                                           .dump());
        RestProbe rest(scene.contact.stiffness);
        const bool pictured = c.response == "lumped" && c.stiffness == 200 &&
                              (c.dt == 0.002 || options.quick);
        Stage stage;
        int most = 0;
        WatchProbe watch([&](const World& world, const Contacts&, double) {
            if (pictured && count_inverted(world) > most) {
                most = count_inverted(world);
                stage = stage_of_inverted(scene);
            }
        });
        RunLimits limits = failure_on_purpose();
        limits.steps = static_cast<int>(c.duration / c.dt + 0.5);
        limits.stop = [&rest](const World&, const Contacts&) { return rest.highest_energy() > 10; };
        const RunResult result = run(scene, chapter06_solver(scene.contact), {&rest, &watch}, limits);
        table.add({c.response, c.dt, c.stiffness, static_cast<long>(rest.max_inverted()),
                   100.0 * rest.steps_with_inverted() / result.steps, rest.highest_energy()});
        if (pictured && most > 0) {
            Renderer renderer(960, 640);
            worst = renderer.draw(stage);
            report.fact("bunny_bowl", "inverted_in_picture", most);
        }
    }
    write_png(worst, report.file("bunny_inverted.png"));
    report.table("bunny_inversions", table);
    report.page_table("bunny_inversions", table, 3);
}

}  // namespace

void bunny_bowl(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bunny_at_rest"));
    Table sizes = sizes_table();
    come_to_rest(options, file, report, sizes);
    if (!options.quick)
        compare_sizes(file, report, sizes);
    report.table("bunny_sizes", sizes);
    report.page_table("bunny_sizes", sizes, 3);
    count_inversions(options, file, report);
}

}  // namespace enduring::chapter06
