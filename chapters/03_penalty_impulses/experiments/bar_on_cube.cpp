#include "chapters/01_particle_plane/particle.hpp"
#include "chapters/03_penalty_impulses/experiments/bar_drop.hpp"
#include "chapters/03_penalty_impulses/experiments/experiments.hpp"
#include "chapters/03_penalty_impulses/experiments/pair_film.hpp"
#include "common/experiments/report/sweep.hpp"
#include "common/experiments/run/elements_of.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter03 {
namespace {

constexpr std::array<PenaltyMethod, 2> both_methods{PenaltyMethod::discrete, PenaltyMethod::continuous};

void add_force_curve(Table& table, const std::string& figure, const BarDrop& drop, const BarRecord& record)
{
    for (std::size_t i = 0; i < record.time.size(); ++i)
        table.add(
            {figure, short_name(drop.method), drop.dt, drop.stiffness, record.time[i], record.force[i]});
}

/// Force over time around the largest smooth steps (figure 7.4), and along
/// k dt^2 = const just above them (figure 7.5).
void force_curves(const RunOptions& options, const std::filesystem::path& file, Report& report)
{
    Table table({"figure", "method", "dt_s", "stiffness_n_per_m", "time_s", "force_n"});
    for (const PenaltyMethod method : both_methods)
        for (const double dt : {0.006, 0.008, 0.010, 0.012}) {
            const BarDrop drop{method, dt};
            add_force_curve(table, "7.4", drop, drop_bar(file, drop));
        }
    Table pairs({"dt_s", "stiffness_n_per_m", "dpf_jitter_percent", "cpf_jitter_percent"});
    for (const double dt : {0.004, 0.005, 0.007, 0.010}) {
        const double stiffness = stiffness_between_limits(dt);
        std::array<double, 2> jitters{};
        for (std::size_t i = 0; i < both_methods.size(); ++i) {
            const BarDrop drop{both_methods[i], dt, stiffness};
            add_force_curve(table, "7.5", drop, drop_bar(file, drop));
            jitters[i] = 100 * drop_nine_times(file, drop, options.quick).jitter;
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
    std::string basis;
    PenaltyMethod method;
    double dt, jitter;  ///< [s], median over the drops as a share of the weight
};

/// Both kinds of elements, both methods, and steps from 5 ms on.
std::vector<BarDrop> drops_over_step(bool quick)
{
    std::vector<BarDrop> drops;
    for (const std::string& basis : both_bases)
        for (const PenaltyMethod method : both_methods)
            for (int i = 0; i < (quick ? 7 : 37); ++i)
                drops.push_back({method, 0.005 + (quick ? 0.0015 : 0.00025) * i, 5000, 45, basis});
    return drops;
}

/// Jitter at rest over the step, for both methods and both kinds of elements; nothing when only a part of it
/// is run.
std::vector<SweepPoint> jitter_over_step(const RunOptions& options, const std::filesystem::path& file,
                                         Report& report)
{
    const std::vector<BarDrop> drops = drops_over_step(options.quick);
    const auto outcomes = sweep<NineDrops>(options, "jitter", drops.size(), [&](std::size_t i) {
        return drop_nine_times(file, drops[i], options.quick);
    });
    if (!outcomes)
        return {};
    std::vector<SweepPoint> points;
    Table table({"elements", "method", "dt_s", "median_percent", "smallest_percent", "largest_percent",
                 "smooth_drops", "drops", "pairs", "depth_mm"});
    for (std::size_t i = 0; i < drops.size(); ++i) {
        const BarDrop& drop = drops[i];
        const NineDrops& of = (*outcomes)[i];
        table.add({drop.basis, short_name(drop.method), drop.dt, 100 * of.jitter, 100 * of.least_jitter,
                   100 * of.max_jitter, of.smooth, of.drops, of.pairs, 1000 * of.depth});
        points.push_back({drop.basis, drop.method, drop.dt, of.jitter});
    }
    report.table("bar_jitter", table);
    report.plot("chapters/03_penalty_impulses/plots/bar_jitter.gp");
    return points;
}

/// The largest dt up to which the median stays below the limit at every smaller step of the sweep; 0 if none.
double largest_smooth_step(const std::vector<SweepPoint>& points, const std::string& basis,
                           PenaltyMethod method, double limit)
{
    double largest = 0;
    for (const SweepPoint& point : points) {
        if (point.basis != basis || point.method != method)
            continue;
        if (point.jitter >= limit)
            break;
        largest = point.dt;
    }
    return largest;
}

/// What may count as smooth: jitter below so much of the weight. The
/// first is where the curves leave their floor.
struct Criterion {
    double percent;
    std::string text, fact;
};
const std::array<Criterion, 3> criteria{{{0.3, "0.3%", ""}, {1, "1%", "_at_1"}, {3, "3%", "_at_3"}}};

void compare_smooth_steps(const std::vector<SweepPoint>& points, Report& report)
{
    Table table({"elements", "what counts as smooth", "dpf_s", "cpf_s", "ratio"});
    for (const std::string& basis : both_bases)
        for (const Criterion& smooth : criteria) {
            const double dpf = largest_smooth_step(points, basis, PenaltyMethod::discrete,
                                                   smooth.percent / 100);
            const double cpf = largest_smooth_step(points, basis, PenaltyMethod::continuous,
                                                   smooth.percent / 100);
            const double ratio = dpf > 0 ? cpf / dpf : 0;
            table.add({basis, "jitter below " + smooth.text + " of the weight", dpf, cpf, ratio});
            report.fact("bar_on_cube", basis + "_dpf_step" + smooth.fact, dpf, 3);
            report.fact("bar_on_cube", basis + "_cpf_step" + smooth.fact, cpf, 3);
            report.fact("bar_on_cube", basis + "_ratio" + smooth.fact, ratio, 3);
        }
    table.add({"quadratic", "the thesis, by eye", 0.008, 0.011, 0.011 / 0.008});
    table.add({"-", "theory of chapter 1", "-", "-", std::sqrt(1.5)});
    report.table("bar_smooth_step", table);
    report.page_table("bar_smooth_step", table, 4);
}

/// The mass that an impulse on the bar's lightest vertex meets [kg].
double lightest_vertex(const std::filesystem::path& file, const std::string& basis)
{
    BarDrop drop;
    drop.basis = basis;
    const Scene scene = load_bar_scene(file, drop);
    const Body& bar = body_named(scene.world, "bar");
    double lightest = bar.mass();
    for (int v = 0; v < bar.surface().vertex_count(); ++v)
        lightest = std::min(lightest, 1 / bar.inverse_mass(v)(0, 0));
    return lightest;
}

}  // namespace

void bar_on_cube(const RunOptions& options, Report& report)
{
    const std::filesystem::path file = options.scene.value_or(scene_file("bar_on_cube"));
    const std::vector<SweepPoint> points = jitter_over_step(options, file, report);
    if (options.share.is_part())
        return;
    for (const std::string& basis : both_bases)
        report.fact("bar_on_cube", basis + "_lightest_g", 1000 * lightest_vertex(file, basis), 3);
    Scene scene = load_bar_scene(file, {});
    report.fact("bar_on_cube", "elements", elements_of(scene.world, "bar"));
    PairFilm film(scene, {0.0, 0.28, 0.4, 0.7, 1.2, 3.6}, report, "bar_on_cube", options.quick);
    drop_bar(file, {}, film.probes());
    film.finish();

    force_curves(options, file, report);
    compare_smooth_steps(points, report);
}

}  // namespace enduring::chapter03
