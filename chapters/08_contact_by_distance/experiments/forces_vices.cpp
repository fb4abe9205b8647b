#include "chapters/08_contact_by_distance/experiments/forces_vices.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/driven_body.hpp"

#include <algorithm>
#include <cmath>

namespace enduring::chapter08::force_rows {
namespace {

constexpr double wide = 0.2, thick = 0.1;  // of the body, of a wall [m]

/// From 0 to 1 between two times, with a cubic that begins and ends at rest.
double eased(double time, double from, double to)
{
    const double part = std::clamp((time - from) / (to - from), 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

/// Rows close enough that what a table does between two of them plays no part.
template <class Displacement>
GivenMotion sampled(double duration, const Displacement& at)
{
    constexpr int rows = 120;
    std::vector<GivenMotion::Row> table;
    for (int row = 0; row <= rows; ++row) {
        const double time = duration * row / rows;
        table.push_back({time, at(time), Vec3::Zero()});
    }
    return GivenMotion::through(std::move(table));
}

/// Its lowest point at y = `low`.
void add_gripped(Scene& scene, const Vice& vice, double low)
{
    const Vec3 at(vice.aside, low + wide / 2, 0);
    switch (vice.gripped) {
        case Gripped::box: add_rigid(scene, "body", moved(box(Vec3::Constant(wide)), at), vice.mass); return;
        case Gripped::ball: add_rigid(scene, "body", moved(sphere(wide / 2, 3), at), vice.mass); return;
        default: break;
    }
    DeformableSettings settings;
    settings.material = {.young = 1e6,
                         .poisson = 0.3,
                         .density = vice.mass / (wide * wide * wide),
                         .stiffness_damping = 0.005};
    settings.position = at;
    settings.impulse_response = ImpulseResponse::implicit;
    scene.world.bodies.push_back(
        std::make_unique<DeformableBody>("body", bar(Vec3::Constant(wide), {3, 3, 3}), settings));
}

/// Two walls, bodies 0 and 1, a centimetre from the body where it stands in the middle.
/// @param place  of the time: how far they have come [m], and how high [m]
template <class Place>
void add_walls(Scene& scene, double duration, double middle, const Place& place)
{
    constexpr double gap = 0.01;
    for (const int side : {-1, 1}) {
        const Vec3 centre(side * (wide / 2 + thick / 2 + gap), middle, 0);
        scene.world.bodies.push_back(std::make_unique<DrivenBody>(side < 0 ? "left wall" : "right wall",
                                                                  moved(box({thick, 0.3, 0.3}), centre),
                                                                  centre, sampled(duration, [&](double time) {
                                                                      const auto [in, up] = place(time);
                                                                      return Vec3(-side * in, up, 0);
                                                                  })));
    }
}

constexpr double clear = 0.01;  // of each wall at the start [m]

Squeezed outcome_of(Stepped& run, double duration)
{
    Squeezed found;
    const double from = run.body(2).centre().y();
    for (long i = std::lround(duration / run.dt()); i > 0; --i) {
        run.step();
        found.fastest = std::max(found.fastest, run.body(2).mean_velocity().norm());
        found.off_law = std::max(found.off_law, run.off_law());
    }
    const double left = run.between(2, 0).x(), right = -run.between(2, 1).x();
    found.force = std::max(left, right);
    found.difference = found.force > 0 ? std::abs(left - right) / found.force : INFINITY;
    found.lifted = run.body(2).centre().y() - from;
    found.carried = run.weight(2) > 0 ? run.on_bodies()[2].y() / run.weight(2) : 0;
    found.parts = run.most_parts();
    found.ended_badly = run.world().ended_badly;
    return found;
}

}  // namespace

std::string name_of(Gripped gripped)
{
    return gripped == Gripped::box ? "box" : gripped == Gripped::ball ? "ball" : "soft cube";
}

std::string name_of(const Vice& vice)
{
    return name_of(vice.gripped) + named(" of", vice.mass) + named(" kg,", 1000 * vice.overclosed) +
           named(" mm too close,", 1000 * vice.aside) + named(" mm aside, 1/Δt", std::round(1 / vice.dt));
}

Squeezed squeeze(const Vice& vice, const MakeSolver& make)
{
    Scene scene = empty_scene(vice.dt, 0.5);
    scene.world.gravity.setZero();
    add_walls(scene, 0.5, wide / 2, [&](double time) {
        return std::pair(eased(time, 0, 0.1) * (clear + vice.overclosed / 2), 0.0);
    });
    add_gripped(scene, vice, 0);
    Stepped run(std::move(scene), make);
    return outcome_of(run, 0.5);
}

Squeezed grip(const Vice& vice, const MakeSolver& make)
{
    Scene scene = empty_scene(vice.dt, 0.5);
    add_ground(scene);
    add_walls(scene, 1.4, 0.155, [&](double time) {
        return std::pair(eased(time, 0, 0.3) * (clear + vice.overclosed / 2), lift * eased(time, 0.5, 1.2));
    });
    add_gripped(scene, vice, 0);
    Stepped run(std::move(scene), make);
    return outcome_of(run, 1.4);
}

Rows vices(const MakeSolver& make, bool full)
{
    Row law{"vice", "two walls that close further than a body leaves room",
            "force of each pair, in each step", "k times its depth", 1e-4},
        // what a soft body answers is solved to a millionth, and its laws hold no better
        soft{"vice_soft", "the same, on a soft cube", "force of each pair, in each step", "k times its depth",
             2e-3},
        balance{"vice_balance", "the same", "forces of both walls", "equal", 0.01},
        parts{"vice_parts", "the same", "parts of a step", "3 at most", 3, "parts"};
    for (const Gripped gripped : {Gripped::box, Gripped::ball, Gripped::soft})
        for (const double overclosed :
             full ? std::vector{1e-5, 1e-4, 1e-3, 1e-2} : std::vector{1e-5, 1e-3, 1e-2})
            for (const double mass : full ? std::vector{0.05, 5.0, 500.0} : std::vector{5.0})
                for (const double aside : {0.0, 0.002}) {
                    if (gripped == Gripped::soft && (aside > 0 || (!full && overclosed < 1e-3)))
                        continue;
                    const Vice vice{gripped, overclosed, mass, aside, full ? 1.0 / 60 : 0.01};
                    const Squeezed found = squeeze(vice, make);
                    (gripped == Gripped::soft ? soft : law).add(name_of(vice), 100 * found.off_law);
                    balance.add(name_of(vice), 100 * found.difference);
                    parts.add(name_of(vice), static_cast<double>(found.parts + 100 * found.ended_badly));
                }
    return {law, soft, balance, parts};
}

Rows grippers(const MakeSolver& make, bool full)
{
    Row height{"gripper", "fingers that lift a body by 0.3 m", "height at the end", "that of the fingers", 3,
               "mm"},
        speed{"gripper_speed", "the same", "speed of the fastest step", "that of the fingers", 20},
        carried{"gripper_carries", "the same", "vertical force on the body at the end", "weight", 1},
        law{"gripper_law", "the same", "force of each pair, in each step", "k times its depth", 1e-4},
        parts{"gripper_parts", "the same", "parts of a step", "3 at most", 3, "parts"};
    const auto add = [&](const Vice& vice) {
        const Squeezed found = grip(vice, make);
        const std::string name = name_of(vice);
        height.add(name, 1000 * std::abs(found.lifted - lift));
        speed.add(name, 100 * std::max(0.0, found.fastest / fastest_lift - 1));
        carried.add(name, 100 * std::abs(found.carried - 1));
        law.add(name, 100 * found.off_law);
        parts.add(name, static_cast<double>(found.parts + 100 * found.ended_badly));
    };
    for (const Gripped gripped : {Gripped::box, Gripped::ball, Gripped::soft})
        for (const double overclosed : full ? std::vector{1e-4, 1e-3, 4e-3, 1e-2} : std::vector{1e-3, 1e-2})
            for (const double mass : full ? std::vector{0.05, 5.0, 500.0} : std::vector{0.05, 500.0})
                for (const double aside : full ? std::vector{0.0, 0.001} : std::vector{0.001}) {
                    // a soft body of 500 kg slips out: its own springs press too little
                    if (gripped == Gripped::soft && (mass > 5 || aside > 0 || overclosed < 4e-3 || !full))
                        continue;
                    for (const double dt : full ? std::vector{1.0 / 60, 1.0 / 240} : std::vector{0.01})
                        add({gripped, overclosed, mass, aside, dt});
                }
    // both fingers come into touch in one step, and what they push on the body adds up to nothing
    for (const Gripped gripped : {Gripped::box, Gripped::ball})
        add({gripped, 1e-3, 5, 0, 0.002});
    return {height, speed, carried, law, parts};
}

}  // namespace enduring::chapter08::force_rows
