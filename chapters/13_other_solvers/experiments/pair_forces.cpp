#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"
#include "chapters/13_other_solvers/experiments/experiments.hpp"
#include "chapters/13_other_solvers/experiments/method_table.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter13 {
namespace {

using namespace chapter08::force_rows;

/// Right below one percent.
Answer percent(double off) { return {100 * off, std::abs(off) < 0.01}; }

/// Runs for two seconds and asks the last step.
Stepped rested(Scene scene, const MakeMethod& make)
{
    Stepped run(std::move(scene), make);
    run.run_for(2);
    return run;
}

/// A cube's four pairs carry a quarter of its weight each.
Answer ask_quarters(const MakeMethod& make)
{
    const Stepped run = rested(chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01), make);
    const double quarter = run.weight(0) / 4;
    double off = 0;
    int pairs = 0;
    for (const Vec3& force : run.on_vertices(0))
        if (force.y() != 0) {
            off = std::max(off, (force - Vec3(0, quarter, 0)).norm() / quarter);
            ++pairs;
        }
    return percent(pairs == 4 ? off : INFINITY);
}

/// The pairs of a box with a symmetric grid of vertices: mirror images, against the largest.
Answer ask_mirror_images(const MakeMethod& make)
{
    Scene scene = empty_scene(0.01, 0.5);
    add_ground(scene);
    add_rigid(scene, "box", moved(box({1, 0.2, 0.8}, {4, 1, 4}), Vec3(0, 0.1, 0)), 10);
    const Stepped run = rested(std::move(scene), make);
    const std::vector<Vec3> forces = run.on_vertices(0);
    const auto places = run.body(0).positions_t0();
    const Vec3 centre = run.body(0).centre();
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if ((places[i] + places[k] - 2 * centre).cwiseProduct(Vec3(1, 0, 1)).norm() < 1e-3 &&
                std::abs(places[i].y() - places[k].y()) < 0.1) {
                largest = std::max({largest, forces[i].y(), forces[k].y()});
                off = std::max(off, std::abs(forces[i].y() - forces[k].y()));
            }
    return percent(largest > 0 ? off / largest : INFINITY);
}

/// Each cube of a stack is pressed by the weight of all above it.
Answer ask_stack(const MakeMethod& make)
{
    const Stepped run = rested(chapter07::scene_of(chapter07::stack_of(10), 0.01), make);
    double above = 0, off = 0;
    for (int i = 9; i >= 0; --i) {
        above += run.weight(static_cast<std::size_t>(i));
        const Vec3 force = run.between(i, i > 0 ? i - 1 : Stepped::planes);
        off = std::max(off, (force - Vec3(0, above, 0)).norm() / above);
    }
    return percent(off);
}

/// Below the threshold friction is m g sin, whatever it could be.
Answer ask_slope(const MakeMethod& make)
{
    const double angle = 20 * std::numbers::pi / 180;
    const Stepped run = rested(chapter07::scene_of({{10, Vec3(0, 0.5, 0), 0}}, 0.01, 20), make);
    const double along = run.weight(0) * std::sin(angle), up = run.weight(0) * std::cos(angle);
    const Vec3 force = run.on_bodies()[0];
    return percent(
        std::max(std::abs(std::hypot(force.x(), force.z()) - along) / along, std::abs(force.y() - up) / up));
}

/// Two cubes meet askew in flight: what one gets, the other one loses.
Answer ask_meeting(const MakeMethod& make)
{
    Scene scene = empty_scene(0.01, 0.5);
    scene.world.gravity.setZero();
    const SurfaceMesh cube = box({0.3, 0.3, 0.3});
    const auto tilted = [&](double angle, const Vec3& axis) {
        return turned(cube, Quaternion(Eigen::AngleAxisd(angle, axis.normalized())));
    };
    add_rigid(scene, "left", tilted(0.5, Vec3(1, 1, 0)), 1, Vec3(2, 0, 0));
    add_rigid(scene, "right", moved(tilted(-0.7, Vec3(0, 1, 1)), Vec3(0.5, 0.05, 0.03)), 4, Vec3(-1, 0, 0));
    Stepped run(std::move(scene), make);
    const Vec3 left = run.body(0).linear_momentum(), right = run.body(1).linear_momentum();
    run.run_for(0.5);
    const Vec3 gets = run.body(0).linear_momentum() - left, loses = right - run.body(1).linear_momentum();
    return percent(gets.norm() > 0.1 ? (gets - loses).norm() / gets.norm() : INFINITY);
}

/// A tilted cube lands: in each whole step forces times its length are the change of momentum but for
/// gravity's.
Answer ask_landing(const MakeMethod& make)
{
    Scene scene = empty_scene(0.01, 0.5);
    add_ground(scene);
    const SurfaceMesh cube = turned(box({0.3, 0.3, 0.3}),
                                    Quaternion(Eigen::AngleAxisd(0.4, Vec3(1, 0.3, 2).normalized())));
    add_rigid(scene, "cube", moved(cube, Vec3(0, 0.4, 0)), 3, Vec3(1, -2, 0));
    Stepped run(std::move(scene), make);
    double largest = 0, off = 0;
    for (int step = 0; step < 50; ++step) {
        const Vec3 before = run.body(0).linear_momentum();
        run.step();
        if (run.parts() > 1)  // pairs tell the last part alone
            continue;
        const Vec3 change = run.body(0).linear_momentum() - before,
                   given = run.dt() * (run.on_bodies()[0] + 3 * run.world().gravity);
        largest = std::max(largest, change.norm());
        off = std::max(off, (change - given).norm());
    }
    return percent(off / largest);
}

/// A ball drops straight and stays: the largest force times the step is its momentum, or less if a contact is
/// soft.
Answer ask_drop(const MakeMethod& make)
{
    constexpr double speed = 2.2, mass = 0.26, dt = 1.0 / 960;
    double most = 0;
    for (const double gap_in_steps : {0.2, 0.7}) {
        Scene scene = empty_scene(dt, 0.5);
        add_ground(scene);
        const double gap = speed * dt * gap_in_steps;
        add_rigid(scene, "ball", moved(sphere(0.15, 3), Vec3(0, 0.15 + gap, 0)), mass, Vec3(0, -speed, 0));
        Stepped run(std::move(scene), make);
        double largest = 0;
        for (int step = 0; step < 10; ++step) {
            run.step();
            if (run.parts() == 1)
                largest = std::max(largest, dt * run.on_bodies()[0].y());
        }
        most = std::max(most, largest / (mass * std::sqrt(speed * speed + 2 * 9.81 * gap)));
    }
    return {most, most < 1.01 && most > 0};
}

}  // namespace

/// Forces of the methods' pairs against statics and momentum.
void pair_forces(const RunOptions& options, Report& report)
{
    std::vector<Question> questions{
        {"cube at rest", "force of a pair, off m g / 4 [%]", ask_quarters},
        {"box at rest", "forces of mirror images, apart [%]", ask_mirror_images},
        {"slope", "force, off m g sin and m g cos [%]", ask_slope},
        {"cubes that meet", "momentum gained, off the momentum lost [%]", ask_meeting},
        {"cube that lands", "forces times Δt, off the change of momentum [%]", ask_landing},
        {"ball that drops", "largest force times Δt over m v", ask_drop}};
    if (!options.quick)
        questions.push_back({"stack of ten", "force between cubes, off the weight above [%]", ask_stack});
    report_answers(options, report, "pair_forces", questions);
}

}  // namespace enduring::chapter13
