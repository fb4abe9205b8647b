#include "chapters/08_contact_by_distance/experiments/harsh_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/true_depth.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "common/experiments/run/processor_clock.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace enduring::chapter08 {
namespace {

using Room = Eigen::AlignedBox3d;

double log_uniform(Numbers& numbers, double least, double most)
{
    return least * std::pow(most / least, numbers.next());
}

// One number after the other: the arguments of a call have no order.
Vec3 point_within(const Room& box, Numbers& numbers)
{
    Vec3 point;
    for (const int axis : {0, 1, 2})
        point[axis] = numbers.within(box.min()[axis], box.max()[axis]);
    return point;
}

/// A square rod along x with a point at each end.
SurfaceMesh needle(double length, double thickness)
{
    const double half = 0.5 * thickness, x = 0.4 * length;
    SurfaceMesh mesh;
    for (const double end : {-x, x})
        for (const auto& [y, z] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
            mesh.vertices.emplace_back(end, y, z);
    mesh.vertices.emplace_back(-0.5 * length, 0, 0);
    mesh.vertices.emplace_back(0.5 * length, 0, 0);
    for (int i = 0; i < 4; ++i) {
        const int next = (i + 1) % 4;
        mesh.faces.insert(mesh.faces.end(),
                          {{i, next, i + 4}, {next, next + 4, i + 4}, {8, next, i}, {9, i + 4, next + 4}});
    }
    return mesh;
}

SurfaceMesh harsh_shape(Numbers& numbers)
{
    const double which = numbers.next();
    if (which < 0.3)
        return box({0.6, 0.01, 0.6});
    if (which < 0.55)
        return needle(1, 0.02);
    if (which < 0.7)
        return shape_of(0, numbers);  // tetrahedra
    if (which < 0.85) {
        Vec3 size;
        for (const int axis : {0, 1, 2})
            size[axis] = numbers.within(0.1, 0.5);
        return box(size);
    }
    return shape_of(3 + numbers.below(4), numbers);  // balls, L shapes, U shapes, lumps
}

/// Where a body starts, and how it is thrown.
struct Throw {
    Mat3 turn;
    Vec3 place, velocity, spin;
};

Throw random_throw(const HarshScene& harsh, Numbers& numbers)
{
    const Room& room = harsh.room;
    const Vec3 third = room.sizes() / 6;
    Throw result;
    result.turn = numbers.turn().toRotationMatrix();
    result.place = point_within(room, numbers);
    const Vec3 aim = point_within({room.center() - third, room.center() + third}, numbers);
    result.velocity = harsh.speed * (aim - result.place).normalized();
    result.spin = 20 * (numbers.turn() * Vec3::UnitX());
    return result;
}

/// Whether a body lies in the room and in no other body.
bool has_place(const HarshScene& harsh, const Body& body)
{
    const auto points = body.positions_t0();
    const std::vector<std::unique_ptr<Body>>& others = harsh.scene.world.bodies;
    return std::all_of(points.begin(), points.end(),
                       [&](const Vec3& point) { return harsh.room.contains(point); }) &&
           std::all_of(others.begin(), others.end(), [&](const auto& other) {
               return other->is_static() ||
                      (chapter07::true_depth(body, *other) == 0 && chapter07::true_depth(*other, body) == 0);
           });
}

/// Throws a body from the first place that is free.
/// @param make  the body of a throw
template <class Make>
void add_where_free(HarshScene& harsh, Numbers& numbers, const Make& make)
{
    for (int tries = 0; tries < 1000; ++tries)
        if (std::unique_ptr<Body> body = make(random_throw(harsh, numbers)); has_place(harsh, *body)) {
            harsh.scene.world.bodies.push_back(std::move(body));
            return;
        }
    throw std::logic_error("a harsh scene has no place for its bodies");
}

void add_rigid(HarshScene& harsh, const std::string& name, Numbers& numbers)
{
    const SurfaceMesh shape = harsh_shape(numbers);
    const Vec3 middle = mass_properties(shape, 1000).centre;
    const double mass = log_uniform(numbers, 0.01, 100);
    add_where_free(harsh, numbers, [&](const Throw& thrown) {
        SurfaceMesh mesh = shape;
        for (Vec3& vertex : mesh.vertices)
            vertex = thrown.turn * (vertex - middle) + thrown.place;
        return std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass),
                                           thrown.velocity, thrown.spin);
    });
}

void add_soft_box(HarshScene& harsh, const std::string& name, Numbers& numbers)
{
    Vec3 size;
    std::array<int, 3> cells{};
    for (const int axis : {0, 1, 2}) {
        size[axis] = numbers.within(0.15, 0.5);
        cells[static_cast<std::size_t>(axis)] = 1 + numbers.below(3);
    }
    const TetrahedralMesh mesh = bar(size, cells);
    DeformableSettings settings;
    settings.material = {
        .young = log_uniform(numbers, 1e4, 1e7), .poisson = 0.3, .density = 1000, .stiffness_damping = 0.01};
    settings.impulse_response = ImpulseResponse::implicit;
    add_where_free(harsh, numbers, [&](const Throw& thrown) {
        settings.rotation = thrown.turn;
        settings.position = thrown.place;
        settings.velocity = thrown.velocity;
        settings.angular_velocity = thrown.spin;
        return std::make_unique<DeformableBody>(name, mesh, settings);
    });
}

/// Slabs around the room, through each other at its edges.
void add_room(HarshScene& harsh, bool ground_is_plane)
{
    constexpr double thickness = 1;
    const Room& room = harsh.room;
    const Vec3 outer = room.sizes() + Vec3::Constant(2 * thickness);
    for (const int axis : {0, 1, 2})
        for (const int side : {-1, 1}) {
            if (axis == 1 && side == -1 && ground_is_plane) {
                harsh.scene.world.planes.push_back({"ground"});
                continue;
            }
            Vec3 size = outer, at = room.center();
            size[axis] = thickness;
            at[axis] += 0.5 * side * (room.sizes()[axis] + thickness);
            SurfaceMesh mesh = box(size);
            for (Vec3& vertex : mesh.vertices)
                vertex += at;
            harsh.scene.world.bodies.push_back(std::make_unique<StaticBody>(
                "slab " + std::to_string(2 * axis + (side + 1) / 2),
                SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
        }
}

}  // namespace

//! [harsh_scene]
HarshScene harsh_scene(unsigned seed, bool soft)
{
    Numbers numbers(seed);
    HarshScene harsh;
    const int bodies = 12 + numbers.below(16);
    const int soft_bodies = soft ? 1 + numbers.below(3) : 0;
    harsh.speed = log_uniform(numbers, 10, 100);
    harsh.scene.dt = log_uniform(numbers, 1e-3, 30e-3);
    const double mu = numbers.next(), side = 1.2 * std::cbrt(bodies);
    harsh.scene.contact.friction = MassSplitting{.mu_s = mu, .mu_d = mu};
    harsh.room = {Vec3(-0.5 * side, 0, -0.5 * side), Vec3(0.5 * side, side, 0.5 * side)};
    add_room(harsh, numbers.below(2) == 0);
    for (int i = 0; i < bodies; ++i) {
        const std::string name = "body " + std::to_string(i + 1);
        if (i < soft_bodies)
            add_soft_box(harsh, name, numbers);
        else
            add_rigid(harsh, name, numbers);
    }
    return harsh;
}
//! [harsh_scene]

namespace {

double energy_with_pairs(const World& world, const Contacts& contacts)
{
    return total_energy(world).total() + spring_energy(contacts);
}

double smallest_body(const World& world)
{
    double size = std::numeric_limits<double>::infinity();
    for (const auto& body : world.bodies)
        if (!body->is_static())
            size = std::min(size, body->size());
    return size;
}

int inverted_elements(const World& world)
{
    int inverted = 0;
    for (const auto& body : world.bodies)
        inverted += body->inverted_elements();
    return inverted;
}

/// Whether the solver could take it. If not, those of its parts that were taken stay.
bool take_step(HarshScene& harsh, Contacts& contacts, const Solver& solver, long& parts)
try {
    advance(harsh.scene.world, contacts, solver, harsh.scene.dt,
            [&](const std::string& pass) { parts += pass == "commit"; });
    return true;
} catch (const std::runtime_error&) {
    return false;
}

}  // namespace

HarshOutcome run_harsh(HarshScene& harsh, chapter07::MakeSolver make,
                       const std::function<void(const World&)>& observe)
{
    Scene& scene = harsh.scene;
    World& world = scene.world;
    HarshOutcome outcome{.speed = harsh.speed, .dt = scene.dt, .size_m = smallest_body(world)};
    int newton = 0;  // in this step
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        ++outcome.solves;
        outcome.unsolved += !record.converged;
        newton += record.newton_steps;
    };
    const Solver solver = make(scene.contact, settings);
    Contacts contacts;
    double energy = outcome.start_j = energy_with_pairs(world, contacts);
    observe(world);
    for (bool is_taken = true; is_taken && outcome.steps < harsh_steps; outcome.steps += is_taken) {
        newton = 0;
        const double begin = processor_seconds();
        is_taken = take_step(harsh, contacts, solver, outcome.parts);
        const double seconds = processor_seconds() - begin;
        outcome.all_steps_s += seconds;
        outcome.longest_step_s = std::max(outcome.longest_step_s, seconds);
        outcome.newton[static_cast<std::size_t>(outcome.steps)] = newton;
        const double before = std::exchange(energy, energy_with_pairs(world, contacts));
        if (energy - before > outcome.gain_j) {
            outcome.gain_j = energy - before;
            outcome.gain_step = outcome.steps + 1;
        }
        outcome.max_energy = std::max(outcome.max_energy, energy / outcome.start_j);
        outcome.at_end_m = chapter07::true_depth(world);
        outcome.deepest_m = std::max(outcome.deepest_m, outcome.at_end_m);
        outcome.max_inverted = std::max(outcome.max_inverted, inverted_elements(world));
        observe(world);
    }
    for (const auto& body : world.bodies)
        if (!body->is_static()) {
            ++outcome.bodies;
            outcome.lost += !harsh.room.contains(body->centre());
        }
    return outcome;
}

namespace {

Solver nothing_touches(const ContactParameters&, ImplicitSettings) { return {}; }

}  // namespace

HarshOutcome run_harsh(unsigned seed, bool soft, chapter07::MakeSolver make)
{
    HarshScene harsh = harsh_scene(seed, soft);
    HarshOutcome outcome = run_harsh(harsh, make);
    outcome.seed = seed;
    outcome.soft = soft;
    if (soft) {
        HarshScene free = harsh_scene(seed, soft);
        outcome.free_gain_j = run_harsh(free, nothing_touches).gain_j;
    }
    return outcome;
}

}  // namespace enduring::chapter08
