#include "chapters/12_joints/experiments/crane_scene.hpp"
#include "chapters/12_joints/experiments/experiments.hpp"
#include "common/experiments/render/film_probes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {

/// The rope, which is no body.
void draw_rope(Stage& stage, const World& world, const Contacts&)
{
    const Vec3 load = body_named(world, "load").centre(), hook = body_named(world, "hook").centre(),
               trolley = body_named(world, "trolley").centre();
    stage.segments.push_back({load + 0.15 * Vec3::UnitY(), hook, palette::ink, 3});
    stage.segments.push_back({hook, trolley, palette::ink, 3});
}

}  // namespace

/// A crane sets a load down on a soft slab, wholly and half: forces and sag against statics.
void crane(const RunOptions& options, Report& report)
{
    Table table({"lowered_m", "rope_n", "exact_rope_n", "slab_n", "exact_slab_n", "sag_mm", "exact_sag_mm"});
    double force_off = 0, sag_off = 0, error = 0;
    CraneRun first;
    for (const double part : {1.5, 0.5, 0.25}) {  // of the sag, and a slack rope
        const double lowered = crane_statics::way_down + part * crane_statics::sag;
        const Scene scene = load_scene(scene_file("crane"));
        ClipProbe film(scene, report.file("crane.webp"), options.quick ? 4 : 20, 480, 400,
                       {.until = 5, .mark = draw_rope});
        const CraneRun of = run_crane(lowered, options.quick ? 5 : 8,
                                      part > 1 ? std::vector<Probe*>{&film} : std::vector<Probe*>{});
        if (part > 1) {
            film.finish();
            first = of;
        }
        const double share = std::min(part, 1.0), weight = crane_statics::load * crane_statics::gravity,
                     sag = crane_statics::height - crane_statics::own_sag - of.end.top;
        table.add({lowered, of.end.rope, (1 - share) * weight, of.end.slab, share * weight, 1e3 * sag,
                   1e3 * share * crane_statics::sag});
        force_off = std::max({force_off, std::abs(of.end.rope - (1 - share) * weight) / weight,
                              std::abs(of.end.slab - share * weight) / weight});
        sag_off = std::max(sag_off, std::abs(sag - share * crane_statics::sag) / crane_statics::sag);
        error = std::max(error, of.error);
    }
    report.table("crane", table);
    report.page_table("crane", table, 4);
    constexpr double degrees = 180 / std::numbers::pi;
    report.fact("crane", "force_off", force_off, 2);
    report.fact("crane", "sag_off", sag_off, 2);
    report.fact("crane", "moment_off", std::abs(first.hanging.moment / crane_statics::moment - 1), 2);
    report.fact("crane", "swing_deg", degrees * first.swing, 2);
    report.fact("crane", "most_swing_deg", degrees * first.most, 2);
    report.fact("crane", "joint_error_m", error, 2);
}

}  // namespace enduring::chapter12
