#include "chapters/08_speculative_contacts/experiments/bolt.hpp"

#include "chapters/08_speculative_contacts/solver.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace enduring::chapter08 {
namespace {

constexpr double full_turn = 2 * std::numbers::pi, duration = 0.5, bolt_gap = 1e-5, play = 5e-4;

/// A point of a thread's outline: its distance from the axis, and its height in the first turn [m].
using Outline = std::vector<std::array<double, 2>>;

/// From the groove below over the ridge to the groove above. The nut's groove is wider by some play.
/// @param shift  of the thread away from the axis [m]: its flanks stay where they are
Outline outline_of(const Thread& thread, double shift, double wider)
{
    const double rise = thread.flank * thread.depth, flat = 0.5 * thread.lead - rise;
    const double inner = thread.inner_radius + shift, outer = inner + thread.depth;
    const double low = thread.flank * shift, high = rise + low, top = high + flat + wider;
    return {{inner, low}, {outer, high}, {outer, top}, {inner, top + rise}};
}

/// An outline that climbs around y, between two turns of it.
SurfaceMesh swept(const Outline& outline, double lead, int segments, int from, int to)
{
    SurfaceMesh mesh;
    const int rows = static_cast<int>(outline.size()), steps = (to - from) * segments;
    for (int i = 0; i <= steps; ++i) {
        const double turns = from + static_cast<double>(i) / segments, angle = full_turn * turns;
        for (const auto& [radius, height] : outline)
            mesh.vertices.emplace_back(radius * std::cos(angle), lead * turns + height,
                                       -radius * std::sin(angle));
    }
    for (int i = 0; i < steps; ++i)
        for (int row = 0; row + 1 < rows; ++row) {
            const int a = i * rows + row, b = a + 1, c = a + rows, d = c + 1;
            mesh.faces.insert(mesh.faces.end(), {{a, c, d}, {a, d, b}});
        }
    return mesh;
}

SurfaceMesh turned_inside_out(SurfaceMesh mesh)
{
    for (Face& face : mesh.faces)
        std::swap(face[1], face[2]);
    return mesh;
}

}  // namespace

Scene scene_of(const BoltInNut& bolt)
{
    const Thread& thread = bolt.thread;
    Scene scene = chapter07::scene_of(std::vector<chapter07::Box>{}, bolt.dt, 0, 0, 0);
    scene.world.planes.clear();
    const SurfaceMesh nut =
        turned_inside_out(swept(outline_of(thread, play, 2 * play), thread.lead, bolt.segments, -2, 3));
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "nut", SurfaceTopology(static_cast<int>(nut.vertices.size()), nut.faces), nut.vertices));
    SurfaceMesh ridge = swept(outline_of(thread, 0, 0), thread.lead, bolt.bolt_segments, 0, 2);
    for (Vec3& x : ridge.vertices)
        x.y() += bolt_gap;
    MassProperties properties;  // of a slender shank that nothing touches
    properties.mass = BoltInNut::mass;
    properties.centre = Vec3(0, thread.lead, 0);
    properties.inertia = BoltInNut::mass * BoltInNut::squared_gyration * Mat3::Identity();
    scene.world.bodies.push_back(std::make_unique<RigidBody>("bolt", ridge, properties));
    return scene;
}

BoltFall drop_bolt(const BoltInNut& bolt, Probe* observer)
{
    BoltFall fall;
    Scene scene = scene_of(bolt);
    World& world = scene.world;
    const Solver solver = chapter07::counting_solver(chapter08_solver, fall.solves)(scene.contact);
    const auto& body = dynamic_cast<const RigidBody&>(*world.bodies[1]);
    const double first = total_energy(world).total(), height = body.motion().centre().y();
    const int steps = static_cast<int>(std::lround(duration / bolt.dt));
    Contacts contacts;
    for (int i = 0; i < steps; ++i) {
        advance(world, contacts, solver, bolt.dt);
        const Vec3& centre = body.motion().centre();
        fall.aside_mm = std::max(fall.aside_mm, 1000 * std::hypot(centre.x(), centre.z()));
        fall.energy_gain_j = std::max(fall.energy_gain_j, total_energy(world).total() - first);
        for (const Contact& contact : contacts) {
            fall.pairs += static_cast<double>(contact.is_spring()) / steps;
            fall.edge_pairs +=
                static_cast<double>(contact.is_spring() && contact.kind == ContactKind::edge_edge) / steps;
        }
        if (observer)
            observer->observe(world, contacts, bolt.dt);
    }
    const double rise = bolt.thread.lead / full_turn;  // a radian
    const double acceleration = world.gravity.norm() / (1 + BoltInNut::squared_gyration / (rise * rise));
    fall.fallen_mm = 1000 * (height - body.motion().centre().y());
    fall.by_energy_mm = 1000 * (bolt_gap + 0.5 * acceleration * duration * duration);
    return fall;
}

}  // namespace enduring::chapter08
