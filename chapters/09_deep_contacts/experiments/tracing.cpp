#include "chapters/09_deep_contacts/experiments/experiments.hpp"
#include "chapters/09_deep_contacts/experiments/random_overlaps.hpp"
#include "common/experiments/report/sweep.hpp"

namespace enduring::chapter09 {
namespace {

/// What is summed over many overlaps.
struct CheckSums {
    long overlaps = 0, piercings = 0, curves = 0, open_curves = 0;
    long textbook_breaks = 0;  ///< overlaps in which the textbook's test leaves a curve open
    long asked = 0, wrong = 0;

    void add(const OverlapCheck& check)
    {
        overlaps += check.piercings > 0;
        piercings += check.piercings;
        curves += check.curves;
        open_curves += check.open_curves;
        textbook_breaks += !check.textbook_closes;
        asked += check.asked;
        wrong += check.wrong;
    }
};

using Meshes = std::vector<std::pair<std::string, SurfaceMesh>>;

std::pair<SurfaceMesh, SurfaceMesh> any_two(const Meshes& meshes, std::mt19937_64& random, bool on_lattice)
{
    std::uniform_int_distribution<std::size_t> any(0, meshes.size() - 1);
    const std::size_t one = any(random), other = any(random);
    SurfaceMesh a = place_at_random(meshes[one].second, random, on_lattice);
    SurfaceMesh b = place_at_random(meshes[other].second, random, on_lattice);
    return {std::move(a), std::move(b)};
}

/// Of each trial the state of the numbers before it, so that each can be made without those before; the
/// second half of them is on the lattice.
std::vector<std::mt19937_64> starts_of(const Meshes& meshes, int trials)
{
    std::mt19937_64 random(1);
    std::vector<std::mt19937_64> starts;
    for (int i = 0; i < trials; ++i) {
        starts.push_back(random);
        any_two(meshes, random, i >= trials / 2);
    }
    return starts;
}

}  // namespace

/// Every two of five shapes, placed at random; half of them with coordinates on a lattice.
void tracing(const RunOptions& options, Report& report)
{
    const auto meshes = overlap_meshes();
    const int trials = options.quick ? 150 : 10000;
    const std::vector<std::mt19937_64> starts = starts_of(meshes, trials);
    const auto checks = sweep<OverlapCheck>(options, "tracing", starts.size(), [&](std::size_t i) {
        const bool on_lattice = i >= starts.size() / 2;
        std::mt19937_64 random = starts[i];
        const auto [a, b] = any_two(meshes, random, on_lattice);
        return check_overlap(a, b, on_lattice, 40);
    });
    if (!checks)
        return;
    Table table({"coordinates", "trials", "overlaps", "piercings", "curves", "open_curves", "vertices_asked",
                 "wrong_vertices", "textbook_breaks"});
    CheckSums all;
    for (const bool on_lattice : {false, true}) {
        CheckSums sums;
        for (std::size_t i = 0; i < starts.size() / 2; ++i) {
            const OverlapCheck& check = (*checks)[on_lattice ? starts.size() / 2 + i : i];
            sums.add(check);
            all.add(check);
        }
        table.add({std::string(on_lattice ? "on a lattice" : "any"), static_cast<long>(trials / 2),
                   sums.overlaps, sums.piercings, sums.curves, sums.open_curves, sums.asked, sums.wrong,
                   sums.textbook_breaks});
    }
    report.table("tracing", table);
    report.page_table("tracing", table);
    report.fact("tracing", "trials", static_cast<double>(trials), 6);
    report.fact("tracing", "curves", static_cast<double>(all.curves), 8);
    report.fact("tracing", "open_curves", static_cast<double>(all.open_curves), 6);
    report.fact("tracing", "asked", static_cast<double>(all.asked), 8);
    report.fact("tracing", "wrong", static_cast<double>(all.wrong), 6);
}

}  // namespace enduring::chapter09
