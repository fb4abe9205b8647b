#include "chapters/07_implicit_contact/experiments/experiments.hpp"
#include "chapters/07_implicit_contact/experiments/rest_runs.hpp"
#include "chapters/07_implicit_contact/experiments/soft_scenes.hpp"
#include "chapters/07_implicit_contact/solver.hpp"
#include "common/input/number_text.hpp"

#include <algorithm>

namespace enduring::chapter07 {
namespace {

/// Upward force of the last second: how much it changes, as a part of its mean [%].
class Steadiness {
public:
    void observe(const ForceProbe& force, double end)
    {
        const auto& row = force.table().rows().back();
        if (std::get<double>(row[0]) < end - 1)
            return;
        const double upwards = std::get<double>(row[2]);
        least_ = std::min(least_, upwards);
        most_ = std::max(most_, upwards);
        sum_ += upwards;
        ++count_;
    }
    double changes_percent() const { return 100 * (most_ - least_) * count_ / sum_; }

private:
    double least_ = 1e300, most_ = -1e300, sum_ = 0;
    int count_ = 0;
};

int inverted_elements(const World& world)
{
    int inverted = 0;
    for (const auto& body : world.bodies)
        inverted += body->inverted_elements();
    return inverted;
}

void blocks(RestRuns& runs, const RunOptions& options)
{
    for (const double dt : {0.01, 1.0 / 60})
        for (const double mass : {100, 1})
            for (const double young : {1e6, 1e7}) {
                if (options.quick && (dt != 0.01 || mass != 1 || young != 1e7))
                    continue;
                RestRuns::Case c{
                    "1 t on a block of " + readable(mass, 3) + " kg, " + readable(young / 1e6, 3) + " MPa",
                    ton_on_block({mass, young, 3}, dt), options.quick ? 3.0 : 8.0,
                    dt == 0.01 && mass == 1 && young == 1e7};
                runs.run(c);
            }
}

std::string in_words(const Bunnies& bunnies)
{
    return (bunnies.count == 1 ? "bunny of " : "two bunnies of ") + std::to_string(bunnies.elements) +
           (bunnies.basis == "linear" ? "" : " quadratic") + " elements, " +
           readable(bunnies.young / 1e6, 3) + " MPa";
}

std::vector<Bunnies> all_bunnies(bool quick)
{
    if (quick)
        return {{1, 363, "linear", 1e7}, {2, 363, "linear", 1e6}};
    std::vector<Bunnies> all;
    for (const double young : {1e4, 5e4, 1e6, 1e7})
        for (const int elements : {363, 785, 1452, 10668})
            if (elements < 10000 || young >= 5e4)  // the softest one of that many takes an hour
                all.push_back({1, elements, "linear", young});
    all.push_back({1, 363, "quadratic", 1e6});
    for (const double young : {5e4, 1e6})
        all.push_back({2, 363, "linear", young});
    return all;
}

void bowls(RestRuns& runs, const RunOptions& options, Report& report)
{
    Table table({"scene", "max_inverted", "deepest_mm", "force_changes_percent", "energy_gain_j"});
    long steady = 0;
    int max_inverted = 0;
    for (const Bunnies& bunnies : all_bunnies(options.quick)) {
        const std::string name = in_words(bunnies);
        RestRuns::Case c{name, bunnies_in_bowl(bunnies, 0.01),
                         !options.quick       ? 16.0
                         : bunnies.count == 1 ? 6.0
                                              : 3.0,
                         bunnies.elements == 363 && bunnies.young == (bunnies.count == 1 ? 1e7 : 1e6)};
        c.seen_from = {0.8, 1.8, 1.2};
        ForceProbe force("bunny 1", "bowl");
        Steadiness steadiness;
        int inverted = 0;
        WatchProbe all([&](const World& world, const Contacts& contacts, double dt) {
            force.observe(world, contacts, dt);
            steadiness.observe(force, c.duration);
            inverted = std::max(inverted, inverted_elements(world));
        });
        const PileOutcome outcome = runs.run(c, &all);
        const double changes = steadiness.changes_percent();
        table.add({name, static_cast<long>(inverted), outcome.deepest_mm, changes, outcome.energy_gain_j});
        max_inverted = std::max(max_inverted, inverted);
        steady += changes < 1;
    }
    report.table("bowls_at_rest", table);
    report.page_table("bowls_at_rest", table, 2);
    report.fact("soft_at_rest", "bowls", static_cast<double>(table.rows().size()));
    report.fact("soft_at_rest", "steady_bowls", static_cast<double>(steady));
    report.fact("soft_at_rest", "max_inverted", max_inverted);
}

}  // namespace

/// A ton on a soft block, and soft bunnies that fall into a bowl.
void soft_at_rest(const RunOptions& options, Report& report)
{
    RestRuns runs(report, "soft_at_rest", chapter07_solver);
    blocks(runs, options);
    bowls(runs, options, report);
    runs.report("soft_at_rest", report, 3);
}

}  // namespace enduring::chapter07
