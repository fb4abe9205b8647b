#include "chapters/12_joints/experiments/rope_over_edge.hpp"

#include "chapters/12_joints/experiments/machine.hpp"
#include "common/simulation/outside_load.hpp"
#include "common/simulation/static_body.hpp"

#include <cmath>
#include <numbers>

namespace enduring::chapter12 {
namespace {

Vec3 at_angle(double radius, double angle) { return radius * Vec3(std::cos(angle), std::sin(angle), 0); }

/// A drum along z, with a corner at each multiple of `turn` from `first` on.
std::unique_ptr<StaticBody> drum(double radius, double width, double turn, double first)
{
    const int corners = static_cast<int>(std::lround(2 * std::numbers::pi / turn));
    SurfaceMesh mesh;
    for (int i = 0; i < corners; ++i)
        for (const double z : {-width / 2, width / 2})
            mesh.vertices.push_back(at_angle(radius, first + i * turn) + z * Vec3::UnitZ());
    const int back = 2 * corners, front = back + 1;
    mesh.vertices.emplace_back(0, 0, -width / 2);
    mesh.vertices.emplace_back(0, 0, width / 2);
    for (int i = 0; i < corners; ++i) {
        const int next = (i + 1) % corners;
        mesh.faces.push_back({2 * i, 2 * next, 2 * next + 1});
        mesh.faces.push_back({2 * i, 2 * next + 1, 2 * i + 1});
        mesh.faces.push_back({back, 2 * next, 2 * i});
        mesh.faces.push_back({front, 2 * i + 1, 2 * next + 1});
    }
    const auto vertices = static_cast<int>(mesh.vertices.size());
    return std::make_unique<StaticBody>("drum", SurfaceTopology(vertices, mesh.faces), mesh.vertices);
}

}  // namespace

double largest_ratio(const RopeOverEdge& rope)
{
    const double slope = rope.mu * std::tan(rope.angle / rope.links / 2);
    return std::pow((1 + slope) / (1 - slope), rope.links);
}

RopePull pull_rope(const RopeOverEdge& rope, double ratio, double duration)
{
    constexpr double thick = 0.01, width = 0.04, mass = 0.05;
    const double turn = rope.angle / rope.links, pins = rope.radius * std::cos(turn / 2),
                 length = 2 * pins * std::sin(turn / 2);
    Machine machine(0.01, Vec3::Zero());
    machine.scene.contact.friction = MassSplitting{.mu_s = rope.mu, .mu_d = rope.mu};
    machine.scene.world.bodies.push_back(drum(rope.radius, 2 * width, turn, turn / 2));
    int before = -1;
    for (int i = 0; i < rope.links; ++i) {
        const double angle = (i + 0.5) * turn;
        const int link = machine.add_box(Vec3(thick, 0.9 * length, width), mass,
                                         at_angle(rope.radius + thick / 2, angle), angle);
        if (before >= 0)
            machine.add_joint(JointKind::hinge, link, before, at_angle(pins, i * turn));
        before = link;
    }
    const auto pull = [&](int link, double angle, double force) {  // along the rope, at its end
        machine.rigid(link).add_load(
            {.force = TimedVector(force * Vec3(std::sin(angle), -std::cos(angle), 0)),
             .point = at_angle(pins, angle)});
    };
    pull(1, 0, 1);
    pull(before, rope.angle, -ratio);
    const Body& middle = *machine.scene.world.bodies[static_cast<std::size_t>(1 + rope.links / 2)];
    const Vec3 start = middle.centre();
    machine.run(duration);
    return {(middle.centre() - start).norm(), machine.worst_error()};
}

}  // namespace enduring::chapter12
