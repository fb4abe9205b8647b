#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/experiments/harsh_scenes.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/render/renderer.hpp"
#include "common/experiments/render/scene_view.hpp"
#include "common/experiments/render/strip.hpp"
#include "common/experiments/report/quantile.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace enduring::chapter08 {
namespace {

/// The seeds of a run: two hundred, or twelve that take less than a second each, where others take a minute.
struct HarshSeeds {
    unsigned first = 1, count = 200;
};
constexpr HarshSeeds quick_seeds{24, 12};
/// One scene in four has soft bodies.
bool has_soft_bodies(unsigned seed) { return seed % 4 == 0; }

/// Between slow scenes and fast ones: the middle of the speeds, as their logarithms are spread [m/s].
constexpr double harsh_split = 32;
constexpr int harsh_classes = 4;
int class_of(const HarshOutcome& outcome)
{
    return 2 * static_cast<int>(outcome.soft) + static_cast<int>(outcome.speed >= harsh_split);
}
std::string class_name(int index)
{
    constexpr std::array<const char*, harsh_classes> names{"rigid, 10 to 32 m/s", "rigid, 32 to 100 m/s",
                                                           "with soft ones, 10 to 32 m/s",
                                                           "with soft ones, 32 to 100 m/s"};
    return names.at(static_cast<std::size_t>(index));
}

/// What many runs came to.
struct HarshSummary {
    long scenes = 0, gaining = 0, deep = 0, stopped = 0;  ///< deep: by more than a centimetre
    long bodies = 0, lost = 0, max_inverted = 0;
    long unsolved = 0, solves = 0, steps = 0, parts = 0;
    double max_gain_j = 0, max_gain = 0, free_gain = 0, deepest_m = 0, deepest = 0, at_end_m = 0;
    double longest_step_s = 0, all_steps_s = 0;
    std::vector<int> newton;  ///< of all steps

    void add(const HarshOutcome& run)
    {
        ++scenes;
        gaining += run.gains();
        deep += run.deepest_m > 0.01;
        stopped += run.stopped();
        bodies += run.bodies;
        lost += run.lost;
        max_inverted = std::max<long>(max_inverted, run.max_inverted);
        unsolved += run.unsolved;
        solves += run.solves;
        steps += run.tried();
        parts += run.parts;
        max_gain_j = std::max(max_gain_j, run.gain_j);
        max_gain = std::max(max_gain, run.gain());
        free_gain = std::max(free_gain, run.free_gain_j / run.start_j);
        deepest_m = std::max(deepest_m, run.deepest_m);
        deepest = std::max(deepest, run.deepest_m / run.size_m);
        at_end_m = std::max(at_end_m, run.at_end_m);
        longest_step_s = std::max(longest_step_s, run.longest_step_s);
        all_steps_s += run.all_steps_s;
        newton.insert(newton.end(), run.newton.begin(), run.newton.begin() + run.tried());
    }
    /// Newton steps that this part of all steps does not exceed.
    long newton_quantile(double part) const { return newton.empty() ? 0 : quantile(newton, part); }
};

HarshSummary summary_of(const std::vector<HarshOutcome>& found, int of_class = -1)
{
    HarshSummary sum;
    for (const HarshOutcome& run : found)
        if (of_class < 0 || class_of(run) == of_class)
            sum.add(run);
    return sum;
}

void report_harsh(const std::vector<HarshOutcome>& found, Report& report)
{
    Table bodies({"bodies", "scenes", "that gain", "most gain in a step [%]", "deeper than 1 cm",
                  "deepest [mm]", "over the smallest body [%]", "deepest at the end [mm]", "bodies lost"});
    Table solves({"bodies", "runs that stop", "parts of a step", "solves", "unsolved", "Newton steps, median",
                  "99 % of all steps", "most", "elements inverted"});
    for (int i = 0; i < harsh_classes; ++i) {
        const HarshSummary sum = summary_of(found, i);
        bodies.add({class_name(i), sum.scenes, sum.gaining, 100 * sum.max_gain, sum.deep, 1e3 * sum.deepest_m,
                    100 * sum.deepest, 1e3 * sum.at_end_m, sum.lost});
        solves.add({class_name(i), sum.stopped,
                    static_cast<double>(sum.parts) / static_cast<double>(std::max(1L, sum.steps)), sum.solves,
                    sum.unsolved, sum.newton_quantile(0.5), sum.newton_quantile(0.99), sum.newton_quantile(1),
                    sum.max_inverted});
    }
    report.table("harsh", bodies);
    report.page_table("harsh", bodies, 2);
    report.table("harsh_solves", solves);
    report.page_table("harsh_solves", solves, 2);

    const HarshSummary all = summary_of(found);
    const auto tell = [&](const std::string& name, double value, int digits = 3) {
        report.fact("harsh", name, value, digits);
    };
    tell("scenes", static_cast<double>(all.scenes), 4);
    tell("gaining", static_cast<double>(all.gaining), 4);
    tell("max_gain_percent", 100 * all.max_gain, 2);
    tell("max_gain_j", all.max_gain_j, 2);
    tell("free_gain_percent", 100 * all.free_gain, 2);
    tell("deep", static_cast<double>(all.deep), 4);
    tell("deepest_mm", 1e3 * all.deepest_m, 2);
    tell("at_the_end_mm", 1e3 * all.at_end_m, 2);
    tell("bodies", static_cast<double>(all.bodies), 6);
    tell("lost", static_cast<double>(all.lost), 6);
    tell("stopped", static_cast<double>(all.stopped), 4);
    tell("solves", static_cast<double>(all.solves), 9);
    tell("unsolved", static_cast<double>(all.unsolved), 9);
    tell("newton_median", static_cast<double>(all.newton_quantile(0.5)), 6);
    tell("newton_most", static_cast<double>(all.newton_quantile(1)), 9);
    std::cout << "harsh: " << readable(1e3 * all.all_steps_s / static_cast<double>(all.steps), 3)
              << " ms a step, the longest " << readable(1e3 * all.longest_step_s, 3) << " ms\n";
}

/// Every run in a row, to find the worst ones by their seeds.
void report_runs(const std::vector<HarshOutcome>& found, Report& report)
{
    Table runs({"seed", "soft", "speed_m_per_s", "dt_ms", "gain_j", "gain_percent", "gain_step",
                "free_gain_j", "deepest_mm", "end_mm", "lost", "inverted", "steps", "parts", "solves",
                "unsolved"});
    for (const HarshOutcome& run : found)
        runs.add({static_cast<long>(run.seed), static_cast<long>(run.soft), run.speed, 1e3 * run.dt,
                  run.gain_j, 100 * run.gain(), static_cast<long>(run.gain_step), run.free_gain_j,
                  1e3 * run.deepest_m, 1e3 * run.at_end_m, static_cast<long>(run.lost),
                  static_cast<long>(run.max_inverted), static_cast<long>(run.steps), run.parts, run.solves,
                  run.unsolved});
    report.table("harsh_runs", runs);
}

/// By bits: corner 5 is the last along x, the first along y, the last along z.
std::vector<Vec3> corners_of(const Eigen::AlignedBox3d& room)
{
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    return corners;
}

/// The moving bodies of a world, and the edges of the room instead of its slabs.
Stage stage_in_room(const HarshScene& harsh)
{
    const World& world = harsh.scene.world;
    Stage all = stage_of(world, harsh.scene), stage;
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
        if (!world.bodies[i]->is_static())
            stage.bodies.push_back(all.bodies[i]);
    stage.grounds.push_back({});
    const std::vector<Vec3> corners = corners_of(harsh.room);
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (const std::size_t bit : {1U, 2U, 4U})
            if ((i & bit) == 0)
                stage.segments.push_back({corners[i], corners[i | bit], palette::slate, 1.5});
    return stage;
}

void draw_harsh(Report& report)
{
    constexpr int width = 380, height = 300;
    std::vector<StripPicture> pictures;
    for (const unsigned seed : {29U, 24U}) {
        HarshScene harsh = harsh_scene(seed, has_soft_bodies(seed));
        Camera camera;
        {
            Stage empty;
            for (int i = 0; i < 8; ++i)
                empty.dots.push_back({harsh.room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))});
            camera = frame(points_of(empty), {0.5, 0.35, 1}, static_cast<double>(width) / height, 0.03);
        }
        run_harsh(harsh, chapter08_solver, [&](const World& world) {
            const double flight = 0.3 * harsh.room.sizes().x() / harsh.speed;  // to the middle
            const bool meets = world.step == static_cast<int>(std::ceil(flight / harsh.scene.dt));
            if (world.step != 0 && !meets && world.step != harsh_steps)
                return;
            Stage stage = stage_in_room(harsh);
            stage.camera = camera;
            pictures.push_back({Renderer(width, height).draw(stage),
                                (has_soft_bodies(seed) ? "with soft boxes, " : "rigid, ") +
                                    readable(1e3 * world.time, 2) + " ms"});
        });
    }
    write_png(strip(pictures, 3), report.file("harsh.png"));
}

}  // namespace

/// Random scenes as harsh as a stranger's: what every step does to the energy, how deep bodies truly are, and
/// how the steps are solved.
void harsh(const RunOptions& options, Report& report)
{
    const auto [first, count] = options.quick ? quick_seeds : HarshSeeds{};
    const auto found = sweep<HarshOutcome>(options, "harsh", count, [&, first = first](std::size_t i) {
        const unsigned seed = first + static_cast<unsigned>(i);
        return run_harsh(seed, has_soft_bodies(seed), chapter08_solver);
    });
    if (!found)
        return;
    report_harsh(*found, report);
    report_runs(*found, report);
    if (options.pictures)
        draw_harsh(report);
}

}  // namespace enduring::chapter08
