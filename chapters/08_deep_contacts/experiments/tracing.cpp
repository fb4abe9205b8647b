#include "chapters/08_deep_contacts/experiments/experiments.hpp"
#include "chapters/08_deep_contacts/experiments/random_overlaps.hpp"
#include "common/experiments/report/progress.hpp"

namespace enduring::chapter08 {
namespace {

/// What is summed over many overlaps.
struct Sums {
    long trials = 0, overlaps = 0, piercings = 0, curves = 0, open_curves = 0, inconsistent = 0;
    long textbook_breaks = 0;  ///< overlaps in which the textbook's test leaves a curve open
    long asked = 0, wrong = 0;

    void add(const OverlapCheck& check)
    {
        ++trials;
        overlaps += check.piercings > 0;
        piercings += check.piercings;
        curves += check.curves;
        open_curves += check.open_curves;
        inconsistent += !check.consistent;
        textbook_breaks += !check.textbook_closes;
        asked += check.asked;
        wrong += check.wrong;
    }
};

}  // namespace

/// Every two of five shapes, placed at random; half of them with coordinates on a lattice.
void tracing(const RunOptions& options, Report& report)
{
    const auto meshes = overlap_meshes();
    const int trials = options.quick ? 150 : 10000;
    std::mt19937_64 random(1);
    Table table({"coordinates", "trials", "overlaps", "piercings", "curves", "open_curves", "broken_regions",
                 "vertices_asked", "wrong_vertices", "textbook_breaks"});
    Sums all;
    Progress progress("", trials, " overlaps");
    for (const bool on_lattice : {false, true}) {
        Sums sums;
        for (int i = 0; i < trials / 2; ++i) {
            std::uniform_int_distribution<std::size_t> any(0, meshes.size() - 1);
            const std::size_t one = any(random), other = any(random);
            const SurfaceMesh a = place_at_random(meshes[one].second, random, on_lattice);
            const SurfaceMesh b = place_at_random(meshes[other].second, random, on_lattice);
            const OverlapCheck check = check_overlap(a, b, on_lattice, 40);
            sums.add(check);
            all.add(check);
            progress.update(all.trials);
        }
        table.add({std::string(on_lattice ? "on a lattice" : "any"), static_cast<long>(trials / 2),
                   sums.overlaps, sums.piercings, sums.curves, sums.open_curves, sums.inconsistent,
                   sums.asked, sums.wrong, sums.textbook_breaks});
    }
    report.table("tracing", table);
    report.page_table("tracing", table);
    report.fact("tracing", "trials", static_cast<double>(trials), 6);
    report.fact("tracing", "curves", static_cast<double>(all.curves), 8);
    report.fact("tracing", "open_curves", static_cast<double>(all.open_curves), 6);
    report.fact("tracing", "asked", static_cast<double>(all.asked), 8);
    report.fact("tracing", "wrong", static_cast<double>(all.wrong), 6);
}

}  // namespace enduring::chapter08
