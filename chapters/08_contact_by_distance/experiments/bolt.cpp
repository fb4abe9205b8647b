#include "chapters/08_contact_by_distance/experiments/bolt.hpp"

#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace enduring::chapter08 {
namespace {

constexpr double full_turn = 2 * std::numbers::pi, duration = 0.5;

/// The corners of a ridge's section, counter-clockwise: the distance from the axis, and the height in the
/// first turn [m].
using Section = std::array<std::array<double, 2>, 4>;

/// Heights at which the flanks of a bolt's ridge begin and end.
struct Flanks {
    double low, high, top, upper;

    Flanks(const Thread& thread, double shift, double wider)
    {
        const double rise = thread.flank * thread.depth, flat = 0.5 * thread.lead - rise;
        low = thread.flank * shift;
        high = rise + low;
        top = high + flat + wider;
        upper = top + rise;
    }
};

Section section_of_bolt(const Thread& thread)
{
    const Flanks at(thread, 0, 0);
    const double inner = thread.inner_radius, outer = inner + thread.depth;
    return {{{inner, at.low}, {outer, at.high}, {outer, at.top}, {inner, at.upper}}};
}

/// Between two turns of a groove that is the bolt's ridge, shifted outwards and higher by some play: the
/// flanks of both stay parallel.
Section section_of_nut(const Thread& thread, double play)
{
    const Flanks at(thread, play, 2 * play);
    const double inner = thread.inner_radius + play, outer = inner + thread.depth;
    return {
        {{inner, at.upper}, {outer, at.top}, {outer, at.high + thread.lead}, {inner, at.low + thread.lead}}};
}

/// A section that climbs around y, between two turns of it; closed at both ends.
SurfaceMesh swept(const Section& section, double lead, int segments, int from, int to)
{
    SurfaceMesh mesh;
    const int corners = static_cast<int>(section.size()), steps = (to - from) * segments;
    for (int i = 0; i <= steps; ++i) {
        const double turns = from + static_cast<double>(i) / segments, angle = full_turn * turns;
        for (const auto& [radius, height] : section)
            mesh.vertices.emplace_back(radius * std::cos(angle), lead * turns + height,
                                       -radius * std::sin(angle));
    }
    for (int i = 0; i < steps; ++i)
        for (int corner = 0; corner < corners; ++corner) {
            const int a = i * corners + corner, b = i * corners + (corner + 1) % corners, c = a + corners,
                      d = b + corners;
            mesh.faces.insert(mesh.faces.end(), {{a, c, d}, {a, d, b}});
        }
    const int last = steps * corners;
    mesh.faces.insert(mesh.faces.end(),
                      {{0, 1, 2}, {0, 2, 3}, {last, last + 2, last + 1}, {last, last + 3, last + 2}});
    return mesh;
}

}  // namespace

Scene scene_of(const BoltInNut& bolt)
{
    const Thread& thread = bolt.thread;
    Scene scene = chapter07::scene_of(std::vector<chapter07::Box>{}, bolt.dt, 0, 0, 0);
    scene.world.planes.clear();
    const SurfaceMesh nut = swept(section_of_nut(thread, bolt.play), thread.lead, bolt.segments, -2, 3);
    if (bolt.nut_held)
        scene.world.bodies.push_back(std::make_unique<StaticBody>(
            "nut", SurfaceTopology(static_cast<int>(nut.vertices.size()), nut.faces), nut.vertices));
    else
        scene.world.bodies.push_back(std::make_unique<RigidBody>("nut", nut, mass_properties(nut, 1000)));
    SurfaceMesh ridge = swept(section_of_bolt(thread), thread.lead, bolt.bolt_segments, 0, 2);
    for (Vec3& x : ridge.vertices)
        x.y() += bolt.above;
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
    fall.by_energy_mm = 1000 * (bolt.above + 0.5 * acceleration * duration * duration);
    return fall;
}

}  // namespace enduring::chapter08
