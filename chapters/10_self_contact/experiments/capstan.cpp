#include "chapters/10_self_contact/experiments/experiments.hpp"
#include "chapters/10_self_contact/experiments/round_turn.hpp"
#include "common/experiments/render/film_probes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace enduring::chapter10 {
namespace {

constexpr double rough = 0.5, slippery = 0.02;
constexpr double slipped = 0.02;  ///< displacement of a rope that slips, at which a run ends [m]
constexpr double begun = 0.001;   ///< and of one that begins to [m]

/// How a rope is pulled.
struct Load {
    double dt, force, ratio, cell;
    double halved = 0;  ///< so long it takes to hold back half as hard [s]
};

/// The first is the usual one; each other differs from it in one number.
constexpr std::array loads{Load{0.002, 0.3, 4, 0.004}, Load{0.001, 0.3, 4, 0.004},
                           Load{0.005, 0.3, 4, 0.004}, Load{0.002, 0.15, 4, 0.004},
                           Load{0.002, 0.6, 4, 0.004}, Load{0.002, 0.3, 2, 0.004},
                           Load{0.002, 0.3, 8, 0.004}, Load{0.002, 0.3, 4, 0.003}};

RoundTurn shape_of(const Load& load)
{
    RoundTurn shape;
    shape.cell = load.cell;
    return shape;
}

RoundTurnRun rope(const Load& load, double mu)
{
    const SoftVariant variant{.young = 1e6, .cells = 1, .dt = load.dt, .mu = mu};
    RoundTurnRun turn = round_turn(shape_of(load), variant, load.force, load.ratio);
    turn.soft.pulls[0].halved = load.halved;
    return turn;
}

/// What becomes of a rope.
struct PullOutcome {
    double displacement = 0;  ///< of the middle of the turn [m]
    double creep = 0;         ///< most displacement between two moments of the second half of the time [m]
    double time = 0;          ///< when the run ends [s]
    Folded found;
};

/// @param enough  displacement at which the run ends [m]
PullOutcome pull(RoundTurnRun& turn, const Load& load, double duration, double enough,
                 std::vector<Probe*> probes = {})
{
    PullOutcome outcome;
    const RoundTurn shape = shape_of(load);
    const double start = displacement_of_turn(shape, turn);
    double least = 1e9, most = -1e9;
    WatchProbe watch([&](const World& world, const Contacts&, double) {
        outcome.displacement = displacement_of_turn(shape, turn) - start;
        outcome.time = world.time;
        if (world.time < duration / 2)
            return;
        least = std::min(least, outcome.displacement);
        most = std::max(most, outcome.displacement);
    });
    probes.insert(probes.begin(), &watch);
    outcome.found = fold(turn.soft, static_cast<int>(duration / load.dt + 0.5), probes,
                         [&](const World&, const Contacts&) { return outcome.displacement > enough; });
    outcome.creep = std::max(0.0, most - least);
    return outcome;
}

/// All outcomes, row by row and the worst of them.
struct CollectedPulls {
    Table table{{"dt_s", "pull_n", "ratio", "cell_mm", "friction", "displacement_mm", "creep_um", "time_s",
                 "crossings", "deepest_um", "inverted", "unconverged"}};
    PullOutcome held, coarse,
        slid{.displacement = 1e9, .found = {}};  ///< coarse: held, with a longer step than the usual one

    void add(const Load& load, double mu, const PullOutcome& o)
    {
        table.add({load.dt, load.force, load.ratio, 1000 * load.cell, mu, 1000 * o.displacement,
                   1e6 * o.creep, o.time, o.found.crossings, 1e6 * o.found.depth, o.found.inverted,
                   o.found.unconverged});
        PullOutcome& worst = mu == slippery ? slid : load.dt > loads[0].dt ? coarse : held;
        worst.displacement = mu == slippery ? std::min(worst.displacement, o.displacement)
                                            : std::max(worst.displacement, std::abs(o.displacement));
        worst.creep = std::max(worst.creep, o.creep);
        worst.time = std::max(worst.time, o.time);
        worst.found.depth = std::max(worst.found.depth, o.found.depth);
    }
};

/// The same forces on a rough and on a slippery rope.
void hold_or_slip(bool quick, Report& report)
{
    CollectedPulls all;
    std::vector<StripPicture> rows;
    for (const Load& load : loads)
        for (const double mu : {slippery, rough}) {
            const bool usual = &load == &loads[0];
            if (quick && !usual)
                continue;
            RoundTurnRun turn = rope(load, mu);
            StripProbe film(
                turn.soft.scene, {load.dt, 0.01, 0.015, 0.02}, [](auto&&...) {}, 400, 284);
            const auto probes = usual ? std::vector<Probe*>{&film} : std::vector<Probe*>{};
            const double duration = quick ? 0.1 : load.dt > loads[0].dt ? 0.6 : 0.2;  // until it rests
            all.add(load, mu, pull(turn, load, duration, slipped, probes));
            if (usual)
                rows.push_back({film.all(4), mu == rough ? "friction 0.5" : "friction 0.02"});
        }
    write_png(strip(rows, 1), report.file("round_turn.png"));
    report.table("capstan", all.table);
    report.page_table("capstan", all.table, 3);
    report.fact("capstan", "held_mm", 1000 * all.held.displacement, 2);
    report.fact("capstan", "held_creep_um", 1e6 * all.held.creep, 2);
    report.fact("capstan", "held_depth_um", 1e6 * all.held.found.depth, 2);
    report.fact("capstan", "coarse_mm", 1000 * all.coarse.displacement, 2);
    report.fact("capstan", "coarse_creep_um", 1e6 * all.coarse.creep, 2);
    report.fact("capstan", "coarse_depth_mm", 1000 * all.coarse.found.depth, 2);
    report.fact("capstan", "slid_mm", 1000 * all.slid.displacement, 2);
    report.fact("capstan", "slid_ms", 1000 * all.slid.time, 2);
    report.fact("capstan", "slid_depth_mm", 1000 * all.slid.found.depth, 2);
}

/// A rope is held back less and less, until it slides.
void let_go(bool quick, Report& report)
{
    Table table({"friction", "ratio", "capstan_ratio", "deviation_percent", "deepest_um"});
    double off = 0, smooth = 0, last = 0;
    for (const double mu : {0.0, 0.02, 0.1, 0.2, rough}) {
        if (quick && mu > 0.1)
            continue;
        const Load load{0.002, 0.3, 1, 0.004, 0.2};
        RoundTurnRun turn = rope(load, mu);
        const double expected = std::exp(mu * shape_of(load).angle()),
                     longest = load.halved * std::log2(4 * expected);
        const PullOutcome o = pull(turn, load, longest, begun);
        last = std::exp2(o.time / load.halved);
        table.add({mu, last, expected, 100 * (last / expected - 1), 1e6 * o.found.depth});
        off = std::max(off, std::abs(last / expected - 1));
        if (mu == 0)
            smooth = last;
    }
    report.table("let_go", table);
    report.page_table("let_go", table, 3);
    report.fact("capstan", "smooth_ratio", smooth);
    report.fact("capstan", "rough_ratio", last);
    report.fact("capstan", "rough_capstan", std::exp(rough * RoundTurn().angle()));
    report.fact("capstan", "slippery_capstan", std::exp(slippery * RoundTurn().angle()));
    report.fact("capstan", "off_percent", 100 * off, 2);
}

}  // namespace

/// A rope with one turn around its own end: friction holds it or lets it slip.
void capstan(const RunOptions& options, Report& report)
{
    hold_or_slip(options.quick, report);
    let_go(options.quick, report);
}

}  // namespace enduring::chapter10
