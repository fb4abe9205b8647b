#include "chapters/08_contact_by_distance/experiments/swings.hpp"

#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double pi = std::numbers::pi, g = 9.81, first_gap = 1e-5;

/// Half a circle of facets about the z-axis, open upwards, seen from inside.
SurfaceMesh half_pipe(double radius, int facets, double length)
{
    SurfaceMesh mesh;
    for (int i = 0; i <= facets; ++i) {
        const double angle = pi * i / facets - pi / 2;
        for (const double z : {-length / 2, length / 2})
            mesh.vertices.emplace_back(radius * std::sin(angle), -radius * std::cos(angle), z);
    }
    for (int i = 0; i < facets; ++i) {
        const int a = 2 * i;
        mesh.faces.insert(mesh.faces.end(), {{a, a + 1, a + 3}, {a, a + 3, a + 2}});
    }
    return mesh;
}

/// The outer half of the tube of an upright torus, of its lower half, seen from inside.
SurfaceMesh half_torus(double ring, double tube, int facets, int across)
{
    SurfaceMesh mesh;
    for (int i = 0; i <= facets; ++i)
        for (int j = 0; j <= across; ++j) {
            const double angle = pi * i / facets - pi / 2, aside = pi * j / across - pi / 2;
            const double radius = ring + tube * std::cos(aside);
            mesh.vertices.emplace_back(radius * std::sin(angle), -radius * std::cos(angle),
                                       tube * std::sin(aside));
        }
    for (int i = 0; i < facets; ++i)
        for (int j = 0; j < across; ++j) {
            const int a = i * (across + 1) + j, next = a + across + 1;
            mesh.faces.insert(mesh.faces.end(), {{a, a + 1, next + 1}, {a, next + 1, next}});
        }
    return mesh;
}

/// The faces of a bowl that look at its middle.
SurfaceMesh hollow_of(const SurfaceMesh& bowl, double inner_radius)
{
    SurfaceMesh hollow{bowl.vertices, {}};
    for (const Face& face : bowl.faces)
        if (std::all_of(face.begin(), face.end(), [&](int vertex) {
                return bowl.vertices[static_cast<std::size_t>(vertex)].norm() < inner_radius * (1 + 1e-9);
            }))
            hollow.faces.push_back(face);
    return hollow;
}

/// How far behind any of the hollow's faces a point lies [m].
double depth_behind(const SurfaceMesh& hollow, const Vec3& point)
{
    double deepest = -INFINITY;
    for (const auto& [a, b, c] : hollow.faces) {
        const Vec3& x = hollow.vertices[static_cast<std::size_t>(a)];
        const Vec3 normal = (hollow.vertices[static_cast<std::size_t>(b)] - x)
                                .cross(hollow.vertices[static_cast<std::size_t>(c)] - x)
                                .normalized();
        deepest = std::max(deepest, normal.dot(x - point));
    }
    return deepest;
}

Eigen::Quaterniond turn_of(const Swing& swing, double angle)
{
    return Eigen::AngleAxisd(swing.direction, Vec3::UnitY()) * Eigen::AngleAxisd(angle, Vec3::UnitZ());
}

/// Puts the round thing and the body into the scene; the body as high above the facets as `first_gap`.
void set_up(Swing& swing, const SurfaceMesh& round, SurfaceMesh body, double dt)
{
    const Eigen::Quaterniond turn = turn_of(swing, -swing.amplitude);
    const Vec3 down = turn * Vec3(0, -1, 0);
    for (Vec3& x : body.vertices)
        x = turn * (x + Vec3(0, -swing.arm, 0));
    double deepest = -INFINITY;
    for (const Vec3& x : body.vertices)
        deepest = std::max(deepest, depth_behind(swing.hollow, x));
    for (Vec3& x : body.vertices)
        x -= (deepest + first_gap) / swing.slant * down;
    const MassProperties properties = with_mass(mass_properties(body, 1000), 1);
    swing.arm = properties.centre.norm();
    swing.scene = chapter07::scene_of(std::vector<chapter07::Box>{}, dt, 0, 0, 0);
    swing.scene.world.planes.clear();
    swing.scene.world.bodies.push_back(std::make_unique<StaticBody>(
        "round", SurfaceTopology(static_cast<int>(round.vertices.size()), round.faces), round.vertices));
    swing.scene.world.bodies.push_back(std::make_unique<RigidBody>("body", body, properties));
}

}  // namespace

Swing block_in_pipe(int facets, double dt)
{
    const Vec3 size(0.2, 0.1, 0.3);
    Swing swing;
    swing.crease = pi / facets;
    swing.amplitude = 0.6;
    swing.half_angle = std::asin(0.5 * size.x());
    swing.arm = std::cos(swing.half_angle) - 0.5 * size.y();
    swing.squared_gyration = (size.x() * size.x() + size.y() * size.y()) / 12;
    swing.hollow = half_pipe(swing.radius, facets, 1);
    set_up(swing, swing.hollow, box(size), dt);
    return swing;
}

Swing block_in_torus(int facets, double dt)
{
    constexpr double ring = 0.7, tube = 0.3, aside = pi / 8;  // its corners come on the middles of facets
    const Vec3 size(0.2, 0.1, 2 * tube * std::sin(aside));
    Swing swing;
    swing.radius = ring + tube * std::cos(aside);
    swing.crease = pi / facets;
    swing.amplitude = 0.6;
    swing.slant = std::cos(aside);
    swing.half_angle = std::asin(0.5 * size.x() / swing.radius);
    swing.arm = swing.radius * std::cos(swing.half_angle) - 0.5 * size.y();
    swing.squared_gyration = (size.x() * size.x() + size.y() * size.y()) / 12;
    swing.hollow = half_torus(ring, tube, facets, 12);
    set_up(swing, swing.hollow, box(size), dt);
    return swing;
}

Swing ball_in_bowl(int segments_around, int segments_along, double dt)
{
    BowlShape shape;
    shape.segments_around = segments_around;
    shape.segments_along = segments_along;
    Swing swing;
    swing.crease = shape.rim_angle / segments_along;
    swing.amplitude = 0.6;
    swing.arm = shape.inner_radius - 0.2;
    swing.direction = 0.1;
    const SurfaceMesh round = bowl(shape);
    swing.hollow = hollow_of(round, shape.inner_radius);
    set_up(swing, round, sphere(0.2, 3), dt);
    return swing;
}

namespace {

/// The part of its kinetic energy that the body keeps where one of the places at which it touches passes a
/// crease.
//! [kept_at_crease]
double kept_at_crease(const Swing& swing)
{
    const double k2 = swing.squared_gyration, r = swing.arm, sine = std::sin(swing.crease);
    if (swing.half_angle == 0)
        return 1 - sine * sine;
    const double lever = r * std::sin(swing.half_angle);
    const double own = 1 + lever * lever / k2, other = std::cos(2 * swing.half_angle) - lever * lever / k2;
    const double mass = own / (own * own - other * other);  // over that of the body
    return 1 - mass * std::pow(swing.radius * sine, 2) / (r * r + k2);
}
//! [kept_at_crease]

/// Where it turns round, from rest at one angle on the other side [rad].
double turns_at(const Swing& swing, double from, double kept)
{
    std::vector<double> creases;
    for (int i = -static_cast<int>(pi / swing.crease); i <= pi / swing.crease; ++i)
        for (const double aside : {-swing.half_angle, swing.half_angle})
            if (aside != 0 || swing.half_angle == 0)
                if (const double at = i * swing.crease + aside; at > -from)
                    creases.push_back(at);
    if (swing.half_angle == 0)  // found twice
        creases.erase(std::unique(creases.begin(), creases.end()), creases.end());
    std::sort(creases.begin(), creases.end());
    double last = -from, kinetic = 0;  // over m g r
    for (const double at : creases) {
        const double gained = std::cos(at) - std::cos(last);
        if (kinetic + gained < 0)
            break;
        kinetic = kept * (kinetic + gained);
        last = at;
    }
    return std::acos(std::clamp(std::cos(last) - kinetic, -1.0, 1.0));
}

}  // namespace

double inelastic_bound(const Swing& swing)
{
    const double kept = kept_at_crease(swing);
    return turns_at(swing, turns_at(swing, swing.amplitude, kept), kept) / swing.amplitude;
}

double pendulum_period(const Swing& swing, double amplitude)
{
    double mean = 1, root = std::cos(0.5 * amplitude);  // their common limit gives the elliptic integral
    for (int i = 0; i < 10; ++i) {
        const double next = 0.5 * (mean + root);
        root = std::sqrt(mean * root);
        mean = next;
    }
    const double r = swing.arm;
    return 2 * pi * std::sqrt((r * r + swing.squared_gyration) / (g * r)) / mean;
}

namespace {

/// Follows the angle of a swing: where it passes the lowest place, and how far it comes back.
class SwingWatch {
public:
    SwingWatch(const Swing& swing, double dt)
        : back_(turn_of(swing, 0).inverse()), last_(-swing.amplitude), dt_(dt)
    {}
    void see(const Vec3& centre, double time)
    {
        const Vec3 at = back_ * centre;
        const double angle = std::atan2(at.x(), -at.y());
        if (last_ * angle <= 0 && last_ != angle)
            passages.push_back(time - dt_ * angle / (angle - last_));
        if (passages.size() == 2)
            comes_back = std::max(comes_back, -angle);
        last_ = angle;
    }
    std::vector<double> passages;  ///< of the lowest place [s]
    double comes_back = 0;         ///< after one period [rad]

private:
    Eigen::Quaterniond back_;
    double last_, dt_;
};

double deepest_vertex(const Swing& swing, const Body& body)
{
    double deepest = 0;
    for (const Vec3& x : body.positions_t0())
        if (std::hypot(x.x(), x.y(), x.z()) > 0.9 * swing.radius)
            deepest = std::max(deepest, depth_behind(swing.hollow, x));
    return deepest;
}

}  // namespace

SwingOutcome watch_swing(Swing& swing, Probe* observer)
{
    SwingOutcome outcome;
    World& world = swing.scene.world;
    const double dt = swing.scene.dt;
    const Solver solver = chapter07::counting_solver(chapter08_solver, outcome.solves)(swing.scene.contact);
    const auto& body = dynamic_cast<const RigidBody&>(*world.bodies[1]);
    SwingWatch angle(swing, dt);
    Contacts contacts;
    const double first = total_energy(world).total();
    const int steps = static_cast<int>(std::ceil(1.4 * pendulum_period(swing, swing.amplitude) / dt));
    for (int i = 0; i < steps && angle.passages.size() < 3; ++i) {
        advance(world, contacts, solver, dt);
        angle.see(body.motion().centre(), world.time);
        outcome.deepest_mm = std::max(outcome.deepest_mm, 1000 * deepest_vertex(swing, body));
        outcome.energy_gain_j = std::max(outcome.energy_gain_j, total_energy(world).total() - first);
        for (const Contact& contact : contacts) {
            outcome.pairs += contact.is_spring();
            outcome.edge_pairs += contact.is_spring() && contact.kind == ContactKind::edge_edge;
        }
        if (observer)
            observer->observe(world, contacts, dt);
    }
    outcome.pairs /= world.time / dt;
    outcome.edge_pairs /= world.time / dt;
    outcome.kept = angle.comes_back / swing.amplitude;
    if (angle.passages.size() == 3)
        outcome.period_s = angle.passages[2] - angle.passages[0];
    return outcome;
}

}  // namespace enduring::chapter08
