#include "chapters/08_contact_by_distance/experiments/bouncing_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/experiments.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/experiments/render/moments.hpp"
#include "common/experiments/run/run.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enduring::chapter08 {
namespace {

const std::vector<double> coefficients{0, 0.25, 0.5, 0.75, 1};

std::vector<double> bounce_steps(const RunOptions& options)
{
    return options.quick ? std::vector{0.01} : std::vector{0.01, 0.005, 0.002};
}

std::string name_of(Floor floor)
{
    return floor == Floor::plane       ? "plane"
           : floor == Floor::triangles ? "triangles"
                                       : "a vertex of triangles";
}

/// The first bounce of a ball, against e^2.
void tell_heights(const RunOptions& options, Report& report)
{
    Table table({"floor", "e", "dt_s", "kept", "formula"});
    double worst = 0, stuck = 0;
    for (const Floor floor : {Floor::plane, Floor::triangles, Floor::corner_of_triangles})
        for (const double dt : bounce_steps(options))
            for (const double e : coefficients) {
                const double kept = kept_height(e, floor, dt);
                table.add({name_of(floor), e, dt, kept, e * e});
                if (e > 0)
                    worst = std::max(worst, std::abs(kept / (e * e) - 1));
                else
                    stuck = std::max(stuck, kept);
            }
    report.table("bouncing_heights", table);
    report.fact("bouncing", "drops", static_cast<double>(table.rows().size()));
    report.fact("bouncing", "height_percent", 100 * worst, 2);
    report.fact("bouncing", "stuck_percent", 100 * stuck, 2);
    Table curve({"e", "time_s", "height_m"});
    for (const double e : {0.25, 0.5, 0.75, 0.9}) {
        constexpr double dt = 0.01;
        double time = 0;
        for (const double height : heights_of_ball(e, dt, 3)) {
            curve.add({e, time, height});
            time += dt;
        }
    }
    report.table("bouncing", curve);
    report.plot("chapters/08_contact_by_distance/plots/bouncing.gp");
}

/// Five balls in a line.
void tell_cradle(const RunOptions& options, Report& report)
{
    Table table({"e", "gap_mm", "dt_s", "ball_1", "ball_2", "ball_3", "ball_4", "ball_5", "kinetic"});
    double worst = 0;
    for (const double e : {1.0, 0.5, 0.0})
        for (const double gap : {0.0, 1e-4, 1e-3, 1e-2})
            for (const double dt : bounce_steps(options)) {
                const Cradle end = cradle(e, gap, dt);
                const std::vector<double>& v = end.velocities;
                table.add({e, 1000 * gap, dt, v[0], v[1], v[2], v[3], v[4], end.kinetic});
                for (std::size_t ball = 0; e == 1 && ball < v.size(); ++ball)
                    worst = std::max(worst, std::abs(v[ball] - (ball == 4 ? 1 : 0)));
            }
    report.table("bouncing_cradle", table);
    Table page({"e", "gap_mm", "ball_1", "ball_2", "ball_3", "ball_4", "ball_5", "kinetic"});
    for (const double e : {1.0, 0.5})
        for (const double gap : {0.0, 1e-2}) {
            const Cradle end = cradle(e, gap, 0.01);
            const std::vector<double>& v = end.velocities;
            page.add({e, 1000 * gap, v[0], v[1], v[2], v[3], v[4], end.kinetic});
        }
    report.page_table("bouncing_cradle", page, 2);
    report.fact("bouncing", "cradle_percent", 100 * worst, 2);
    double ended_badly = 0, off = 0;
    for (const double gap : {0.0, 1e-3})
        for (const double dt : bounce_steps(options)) {
            const HangingCradle end = hanging_cradle(gap, dt);
            ended_badly += static_cast<double>(end.ended_badly);
            off = std::max(off, std::abs(end.handed_on - 1));
        }
    report.fact("bouncing", "hanging_ended_badly", ended_badly);
    report.fact("bouncing", "hanging_percent", 100 * off, 2);
}

void draw_cradle(Report& report)
{
    Scene scene = cradle_scene(1, 0, 0.01);
    scene.duration = 0.5;
    MomentsProbe pictures(scene, {0, 0.2, 0.42});
    run(scene, chapter08_solver(scene.contact), {&pictures});
    std::vector<Moment> moments = pictures.moments();
    frame_together(moments, {0.15, 0.45, 1}, 3.2);
    write_png(draw_moments(moments, 1, 720, 225), report.file("bouncing_cradle.png"));
}

/// What gains nothing, and what comes to rest.
void tell_energy(const RunOptions& options, Report& report)
{
    Table table({"scene", "e", "dt_s", "most_gained_percent", "left_percent"});
    double gained = 0;
    for (const double dt : bounce_steps(options))
        for (const double e : {0.0, 0.5, 0.9, 1.0}) {
            const auto add = [&](const std::string& scene, const EnergyOfRun& energy) {
                table.add({scene, e, dt, 100 * energy.most_gained, 100 * energy.left});
                gained = std::max(gained, 100 * energy.most_gained);
            };
            add("cube on its corner, no friction", cube_on_corner(e, 0, dt));
            add("cube on its corner", cube_on_corner(e, 0.3, dt));
            add("two soft cubes", soft_cubes(e, dt));
        }
    report.table("bouncing_energy", table);
    report.fact("bouncing", "gained_percent", gained, 1);
    report.fact("bouncing", "cube_left_percent", 100 * cube_on_corner(1, 0, 0.01).left, 3);
    report.fact("bouncing", "rubbing_cube_left_percent", 100 * cube_on_corner(1, 0.3, 0.01).left, 2);
    Table rest({"e", "dt_s", "at_rest_s"});
    double latest = 0;
    for (const double dt : bounce_steps(options))
        for (const double e : {0.0, 0.5, 0.9}) {
            const double at_rest = rest_of_stack(e, dt);
            rest.add({e, dt, at_rest});
            latest = std::max(latest, at_rest);
        }
    report.table("bouncing_rest", rest);
    report.fact("bouncing", "at_rest_s", latest, 2);
}

}  // namespace

/// A ball, a cradle, a cube, soft cubes and a stack with coefficients of restitution.
void bouncing(const RunOptions& options, Report& report)
{
    tell_heights(options, report);
    tell_cradle(options, report);
    draw_cradle(report);
    tell_energy(options, report);
}

}  // namespace enduring::chapter08
