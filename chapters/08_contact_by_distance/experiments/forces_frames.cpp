#include "chapters/08_contact_by_distance/experiments/forces_frames.hpp"

#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08::force_rows {
namespace {

constexpr double radian = std::numbers::pi / 180;  // of a degree

}  // namespace

Rows wedges(const MakeSolver& make, bool full)
{
    Row row{"wedge", "wedge between two planes, no friction", "both normal forces", "m g cos b / sin(a + b)",
            1e-6};
    for (const auto& [left_deg, right_deg] :
         full ? std::vector<std::array<double, 2>>{{20, 35}, {10, 10}, {45, 60}, {2, 5}, {5, 80}}
              : std::vector<std::array<double, 2>>{{20, 35}, {2, 5}})
        for (const double dt : {1.0 / 60, 0.002}) {
            const double a = left_deg * radian, b = right_deg * radian, low = 0.2, high = 0.6;
            Scene scene = empty_scene(dt, 0);
            scene.world.planes = {{"left", Vec3::Zero(), Vec3(std::cos(a), std::sin(a), 0)},
                                  {"right", Vec3::Zero(), Vec3(-std::cos(b), std::sin(b), 0)}};
            add_rigid(scene, "wedge",
                      chapter07::prism({{-low * std::tan(a), low},
                                        {low * std::tan(b), low},
                                        {high * std::tan(b), high},
                                        {-high * std::tan(a), high}},
                                       0.4),
                      10)
                .hold({.translation = Vec3::Ones(), .rotation = Vec3::Zero()});
            Stepped run(std::move(scene), make);
            run.come_to_rest(3);
            double on_left = 0, on_right = 0;
            for (const Vec3& force : run.on_vertices(0))
                (force.x() > 0 ? on_left : on_right) += force.norm();
            const double weight = run.weight(0), left = weight * std::cos(b) / std::sin(a + b),
                         right = weight * std::cos(a) / std::sin(a + b);
            row.add(named("sides", left_deg) + named("° and", right_deg) + named("°, dt", dt),
                    100 * std::max(std::abs(on_left / left - 1), std::abs(on_right / right - 1)));
        }
    return {row};
}

namespace {

/// Two bars from the ground to a crown at (0, height). The left one ends there in an edge, the right one in a
/// small upright face.
struct Frame {
    double lean_deg;                       ///< of both bars against the ground
    double left_mass = 5, right_mass = 5;  ///< [kg]
};

Scene frame_scene(const Frame& frame, double dt)
{
    constexpr double length = 1, half_thickness = 0.05, half_face = 0.03;
    const double lean = frame.lean_deg * radian, foot = length * std::cos(lean),
                 height = length * std::sin(lean);
    const double out_x = half_thickness * std::sin(lean), out_y = half_thickness * std::cos(lean);
    Scene scene = empty_scene(dt, 2);
    add_ground(scene);
    const double x = 0.5 * foot, y = 0.5 * height;
    add_rigid(
        scene, "left",
        chapter07::prism({{-foot, 0}, {-x + out_x, y - out_y}, {0, height}, {-x - out_x, y + out_y}}, 0.3),
        frame.left_mass);
    add_rigid(scene, "right",
              chapter07::prism({{foot, 0},
                                {x + out_x, y + out_y},
                                {0, height + half_face},
                                {0, height - half_face},
                                {x - out_x, y - out_y}},
                               0.4),
              frame.right_mass);
    return scene;
}

}  // namespace

Rows frames(const MakeSolver& make, bool full)
{
    Row row{"frame", "two bars that lean against each other", "forces of both feet", "three hinges", 0.01};
    for (const double dt : full ? std::vector{1.0 / 60, 0.002} : std::vector{1.0 / 60})
        for (const Frame& frame : full ? std::vector<Frame>{{45}, {60}, {75}, {60, 5, 10}, {45, 20, 5}}
                                       : std::vector<Frame>{{45}, {60, 5, 10}}) {
            Scene scene = frame_scene(frame, dt);
            const double foot = std::cos(frame.lean_deg * radian), height = std::sin(frame.lean_deg * radian);
            const auto middle = [&](std::size_t i) {
                return dynamic_cast<const RigidBody&>(*scene.world.bodies[i]).motion().centre().x();
            };
            const double left_at = middle(0), right_at = middle(1);
            Stepped run(std::move(scene), make);
            run.come_to_rest(3);
            const double left = run.weight(0), right = run.weight(1);
            // moments of all about the right foot, then of the left bar about the crown
            const double left_up = (left * (foot - left_at) + right * (foot - right_at)) / (2 * foot),
                         thrust = (left_up * foot + left * left_at) / height;
            const Vec3 at_left = run.between(0, Stepped::planes), at_right = run.between(1, Stepped::planes);
            const double off = std::max((at_left - Vec3(thrust, left_up, 0)).norm(),
                                        (at_right - Vec3(-thrust, left + right - left_up, 0)).norm());
            row.add(named("bars at", frame.lean_deg) + named("°, the right one [kg]", frame.right_mass) +
                        named(", dt", dt),
                    100 * off / (left + right));
        }
    return {row};
}

Rows arches(const MakeSolver& make, bool full)
{
    Row feet{"arch", "half circle of stones", "forces of the ground on both feet",
             "half of the weight, and equal thrust", 1e-3},
        joints{"arch_joints", "the same", "forces and moments of each stone, thrust of each joint",
               "statics of the stone", 1e-3};
    for (const int stones : full ? std::vector{5, 7, 9, 15} : std::vector{5, 9})
        for (const double dt : full ? std::vector{0.01, 0.002} : std::vector{0.01}) {
            Stepped run(chapter07::arch(stones, 3, dt), make);
            run.run_for(2);
            const std::string name = std::to_string(stones) + " stones" + named(", dt", dt);
            const auto last = static_cast<std::size_t>(stones - 1);
            const double stone = run.weight(0), all = stone * stones;
            const Vec3 right = run.between(0, Stepped::planes),
                       left = run.between(static_cast<int>(last), Stepped::planes);
            feet.add(name, 100 *
                               std::max({std::abs(right.y() - all / 2), std::abs(left.y() - all / 2),
                                         std::abs(right.x() + left.x())}) /
                               all);
            double off = 0;
            const std::vector<Vec3> on_stones = run.on_bodies();
            for (std::size_t i = 0; i <= last; ++i) {
                off = std::max(off, (on_stones[i] - Vec3(0, stone, 0)).norm());
                const Vec3 centre = dynamic_cast<const RigidBody&>(run.body(i)).motion().centre();
                off = std::max(off, run.moment(i, centre).norm());  // lever 1 m: the stones' thickness
                if (i > 0)
                    off = std::max(
                        off,
                        std::abs(run.between(static_cast<int>(i - 1), static_cast<int>(i)).x() + right.x()));
            }
            joints.add(name, 100 * off / all);
        }
    return {feet, joints};
}

namespace {

constexpr double ring_radius = 0.1, ring_thickness = 0.03;  // [m]

/// Of a square section around the axis z, with flat facets at the top and at the bottom.
SurfaceMesh ring()
{
    constexpr int around = 16;
    SurfaceMesh mesh;
    for (int i = 0; i < around; ++i)
        for (const auto& [out, along] : {std::pair{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}) {
            const double angle = 2 * std::numbers::pi * (i + 0.5) / around,
                         r = ring_radius + out * ring_thickness;
            mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), along * ring_thickness);
        }
    for (int i = 0; i < around; ++i)
        for (int side = 0; side < 4; ++side) {
            const int a = 4 * i + side, b = 4 * i + (side + 1) % 4, next = 4 * ((i + 1) % around) - 4 * i;
            mesh.faces.push_back({a, b, b + next});
            mesh.faces.push_back({a, b + next, a + next});
        }
    for (Face& face : mesh.faces)  // outwards
        std::swap(face[1], face[2]);
    return mesh;
}

}  // namespace

Rows chains(const MakeSolver& make, bool full)
{
    Row row{"chain", "rings that hang through each other", "force of each on the one below", "weight below",
            0.01};
    for (const int rings : full ? std::vector{2, 4, 8} : std::vector{4})
        for (const double last_mass : {1.0, 20.0}) {
            Scene scene = empty_scene(0.005, 0.5);
            const double inside = 2 * (ring_radius - 0.5 * ring_thickness) * std::cos(std::numbers::pi / 16),
                         apart = inside - ring_thickness * std::cos(std::numbers::pi / 16);
            for (int i = 0; i < rings; ++i) {
                const Quaternion turn(Eigen::AngleAxisd(0.5 * std::numbers::pi * (i % 2), Vec3::UnitY()));
                const SurfaceMesh mesh = moved(turned(ring(), turn), Vec3(0, -i * apart, 0));
                if (i == 0)
                    add_static(scene, "hook", mesh);
                else
                    add_rigid(scene, "ring " + std::to_string(i), mesh, i == rings - 1 ? last_mass : 1);
            }
            Stepped run(std::move(scene), make);
            run.run_for(2);
            double below = 0, off = 0;
            for (int i = rings - 1; i > 0; --i) {
                below += run.weight(static_cast<std::size_t>(i));
                off = std::max(off, (run.between(i, i - 1) - Vec3(0, below, 0)).norm() / below);
            }
            row.add(std::to_string(rings) + " rings" + named(", the last one [kg]", last_mass), 100 * off);
        }
    return {row};
}

}  // namespace enduring::chapter08::force_rows
