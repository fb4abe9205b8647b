#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/method_table.hpp"
#include "chapters/13_other_solvers/experiments/soft_scenes.hpp"
#include "common/experiments/run/processor_clock.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter13 {
namespace {

void run_for(Scene& scene, const Solver& solver, double seconds)
{
    Contacts contacts;
    for (int step = 0; step < std::lround(seconds / scene.dt); ++step)
        advance(scene.world, contacts, solver, scene.dt);
}

/// The mean height of the top over two swings, against rho g H^2 / (2 E).
Answer ask_column(const MakeMethod& make)
{
    Scene scene = soft_cube_scene({}, 0, 0);
    Contacts contacts;
    const double top = mean_over(scene, contacts, make(scene.contact), 80,
                                 [&] { return height_of_top(soft_body(scene)); });
    const double error = 100 * ((1 - top) / column_sinks() - 1);
    return {error, std::abs(error) < 5};
}

/// A bar that hangs as the base's implicit step leaves it, after half a second.
Answer ask_bar(const MakeMethod& make)
{
    Scene damped = clamped_bar(0.01, 20);
    for (int step = 0; step < 300; ++step) {
        damped.world.bodies[0]->predict(damped.world.gravity, damped.dt);
        damped.world.bodies[0]->commit(damped.dt);
    }
    Scene scene = clamped_bar();
    restore_state(*scene.world.bodies[0], state_of(*damped.world.bodies[0]));
    run_for(scene, make(scene.contact), 0.5);
    const double sag = 2 - height_of_tip(soft_body(damped));
    const double moved = 100 * std::abs(2 - height_of_tip(soft_body(scene)) - sag) / sag;
    return {moved, moved < 1};
}

/// Friction over normal force of a cube that slides, by what the ground has given.
Answer ask_slide(const MakeMethod& make)
{
    Scene scene = soft_cube_scene({}, 50);
    const Body& body = *scene.world.bodies[0];
    const Solver solver = make(scene.contact);
    run_for(scene, solver, 0.2);
    const Vec3 before = body.linear_momentum();
    run_for(scene, solver, 0.6);
    const Vec3 given = body.linear_momentum() - before - 0.6 * body.mass() * scene.world.gravity;
    const double mu = given.x() / given.y();
    return {mu, std::abs(mu - 0.5) < 0.01};
}

/// How far a free rigid box moves on which a soft cube lies.
Answer ask_box(const MakeMethod& make)
{
    Scene scene = chapter07::scene_of({{20, Vec3(0, 0.25, 0), 20, Vec3::UnitY(), Vec3(1.5, 0.5, 1.5)}}, 0.01);
    append_soft_cube(scene, {.centre = Vec3(0, 1, 0)});
    const Vec3 from = scene.world.bodies[0]->centre();
    run_for(scene, make(scene.contact), 0.8);
    const double moved = 1e3 * (scene.world.bodies[0]->centre() - from).norm();
    return {moved, moved < 2};
}

/// The percent of its fall that a cube rises again. Elements have no loss of their own: more than 100 is
/// wrong.
Answer ask_bounce(const MakeMethod& make)
{
    Scene scene = soft_cube_scene({.centre = Vec3(0, 1, 0), .poisson = 0.3});
    const Solver solver = make(scene.contact);
    run_for(scene, solver, 0.6);
    double highest = 0;
    for (int step = 0; step < 60; ++step) {
        run_for(scene, solver, scene.dt);
        highest = std::max(highest, scene.world.bodies[0]->centre().y());
    }
    const double percent = 100 * (highest - 0.5) / 0.5;
    return {percent, percent > 0 && percent < 100};
}

/// Momentum that a collision with a rigid cube loses.
Answer ask_collision(const MakeMethod& make)
{
    Scene scene = chapter07::scene_of({{10, Vec3(1.3, 0.3, 0.2), 50, Vec3(3, 1, 2).normalized()}}, 0.01, 0,
                                      0.3, 0.3);
    scene.world.planes.clear();
    scene.world.gravity.setZero();
    append_soft_cube(scene, {.centre = Vec3(-0.2, 0, 0), .poisson = 0.3, .velocity = Vec3(3, 0, 0)});
    run_for(scene, make(scene.contact), 0.6);
    const Vec3 after = scene.world.bodies[0]->linear_momentum() + scene.world.bodies[1]->linear_momentum();
    const double lost = 100 * (after - Vec3(30, 0, 0)).norm() / 30;
    return {lost, lost < 0.01};
}

/// Processor time of a step of a cube of 4^3 cells at rest [ms]; its base's prediction counts, too.
double step_ms(const MakeMethod& make, int cells)
{
    Scene scene = soft_cube_scene({.cells = cells}, 0);
    const Solver solver = make(scene.contact);
    const double start = processor_seconds();
    run_for(scene, solver, 0.2);
    return 1000 * (processor_seconds() - start) / 20;
}

}  // namespace

/// Soft scenes under each method that has soft bodies, and under chapter 10 beside them.
void soft_bodies(const RunOptions& options, Report& report)
{
    const std::vector<Question> questions{
        {"column", "sinks_error_percent", ask_column}, {"hanging bar", "moved_percent", ask_bar},
        {"slide", "friction_over_normal", ask_slide},  {"on a box", "box_moved_mm", ask_box},
        {"bounce", "percent_of_fall", ask_bounce},     {"collision", "momentum_lost_percent", ask_collision}};
    if (!report_answers(options, report, "soft_bodies", questions))
        return;
    const int cells = options.quick ? 2 : 4;
    Table speed({"method", "cells", "step_ms_by_clock"});
    for (const auto& [title, make] : all_answering())
        if (title == "XPBD" || title == "AVBD" || title == "barrier" || title == "chapter 10")
            speed.add({title, static_cast<long>(cells), step_ms(make, cells)});
    report.table("soft_speed", speed);
}

}  // namespace enduring::chapter13
