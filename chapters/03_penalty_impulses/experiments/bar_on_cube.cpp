#include "experiments.hpp"

#include "bar_drop.hpp"
#include "chapters/01_particle_plane/particle.hpp"
#include "common/simulation/progress.hpp"
#include "jitter.hpp"
#include "pair_film.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter03 {
namespace {

constexpr std::array<PenaltyMethod, 2> both_methods{PenaltyMethod::discrete, PenaltyMethod::continuous};

void add_force_curve(Table& table, const std::string& figure, const BarDrop& drop, const BarRecord& record)
{
    for (std::size_t i = 0; i < record.time.size(); ++i)
        table.add({figure, short_name(drop.method), drop.dt, drop.stiffness, record.time[i], record.force[i]});
}

double median_jitter(const RunOptions& options, const std::filesystem::path& file, BarDrop drop)
{
    std::vector<double> jitters;
    for (const double turn : nine_turns(options.quick)) {
        drop.turn_deg = turn;
        jitters.push_back(jitter_at_rest(drop_bar(file, drop)));
    }
    return median(jitters);
}

/// Force over time around the largest smooth steps (figure 7.4), and along k dt^2 = const just above them (figure 7.5).
void force_curves(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    Table table({"figure", "method", "dt_s", "stiffness_n_per_m", "time_s", "force_n"});
    for (const PenaltyMethod method : both_methods)
        for (const double dt : {0.008, 0.010, 0.012, 0.014}) {
            const BarDrop drop{method, dt};
            add_force_curve(table, "7.4", drop, drop_bar(file, drop));
        }
    Table pairs({"dt_s", "stiffness_n_per_m", "dpf_jitter_percent", "cpf_jitter_percent"});
    for (const double dt : {0.006, 0.009, 0.012, 0.018}) {
        const double stiffness = std::round(5000 * std::pow(0.011 / dt, 2));
        std::array<double, 2> jitters{};
        for (std::size_t i = 0; i < both_methods.size(); ++i) {
            const BarDrop drop{both_methods[i], dt, stiffness};
            add_force_curve(table, "7.5", drop, drop_bar(file, drop));
            jitters[i] = 100 * median_jitter(options, file, drop);
        }
        pairs.add({dt, stiffness, jitters[0], jitters[1]});
    }
    report.table("bar_force", table);
    report.page_table("bar_pairs", pairs, 3);
    report.table("bar_pairs", pairs);
    report.plot("chapters/03_penalty_impulses/plots/bar_force.gp");
    report.plot("chapters/03_penalty_impulses/plots/bar_force_pairs.gp");
}

struct SweepPoint {
    PenaltyMethod method;
    double dt, jitter;  ///< [s], median over the drops as a share of the weight
};

/// Jitter at rest over the step, for both methods.
std::vector<SweepPoint> sweep(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    const double spacing = options.quick ? 0.001 : 0.00025;
    const int count = options.quick ? 7 : 29;
    std::vector<SweepPoint> points;
    Table table({"method", "dt_s", "median_percent", "smallest_percent", "largest_percent", "smooth_drops", "drops", "pairs",
                 "depth_mm"});
    Progress progress("bar_on_cube: jitter over the step", 2 * count);
    for (const PenaltyMethod method : both_methods)
        for (int i = 0; i < count; ++i) {
            const double dt = 0.007 + spacing * i;
            std::vector<double> jitters, pairs, depths;
            for (const double turn : nine_turns(options.quick)) {
                const BarRecord record = drop_bar(file, {method, dt, 5000, turn});
                jitters.push_back(jitter_at_rest(record));
                pairs.push_back(pairs_at_rest(record));
                depths.push_back(depth_at_rest(record));
            }
            const auto [low, high] = std::minmax_element(jitters.begin(), jitters.end());
            const long smooth = std::count_if(jitters.begin(), jitters.end(), [](double j) { return j < 0.01; });
            table.add({short_name(method), dt, 100 * median(jitters), 100 * *low, 100 * *high, smooth,
                       static_cast<long>(jitters.size()), median(pairs), 1000 * median(depths)});
            points.push_back({method, dt, median(jitters)});
            progress.update(static_cast<int>(points.size()));
        }
    report.table("bar_jitter", table);
    report.plot("chapters/03_penalty_impulses/plots/bar_jitter.gp");
    return points;
}

/// The largest dt up to which the median stays below the limit at every smaller step of the sweep; 0 if none.
double largest_smooth_step(const std::vector<SweepPoint>& points, PenaltyMethod method, double limit)
{
    double largest = 0;
    for (const SweepPoint& point : points) {
        if (point.method != method)
            continue;
        if (point.jitter >= limit)
            break;
        largest = point.dt;
    }
    return largest;
}

void compare_smooth_steps(const std::vector<SweepPoint>& points, Report& report)
{
    Table table({"what counts as smooth", "dpf_s", "cpf_s", "ratio"});
    for (const double percent : {0.3, 1.0, 3.0}) {
        const double dpf = largest_smooth_step(points, PenaltyMethod::discrete, percent / 100);
        const double cpf = largest_smooth_step(points, PenaltyMethod::continuous, percent / 100);
        const std::string text = "jitter below " + std::string(percent < 1 ? "0.3" : percent < 2 ? "1" : "3") + "% of the weight";
        table.add({text, dpf, cpf, dpf > 0 ? cpf / dpf : 0.0});
        if (percent < 1) {
            report.fact("bar_on_cube", "dpf_step", dpf, 3);
            report.fact("bar_on_cube", "cpf_step", cpf, 3);
            report.fact("bar_on_cube", "ratio", cpf / dpf, 3);
        }
    }
    table.add({"the thesis, by eye", 0.008, 0.011, 0.011 / 0.008});
    table.add({"theory of chapter 1", "-", "-", std::sqrt(1.5)});
    report.table("bar_smooth_step", table);
    report.page_table("bar_smooth_step", table, 4);
}

}  // namespace

void bar_on_cube(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bar_on_cube"));
    Scene scene = load_bar_scene(file, {});
    PairFilm film(scene, {0.0, 0.28, 0.4, 0.7, 1.2, 3.6}, report, "bar_on_cube", options.quick);
    drop_bar(file, {}, film.probes());
    film.finish();

    force_curves(options, file, report);
    compare_smooth_steps(sweep(options, file, report), report);
}

}  // namespace enduring::chapter03
