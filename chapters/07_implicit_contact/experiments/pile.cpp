#include "chapters/07_implicit_contact/experiments/pile.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/energy.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace enduring::chapter07 {
namespace {

std::unique_ptr<Body> body_of(const Box& box, const std::string& name)
{
    SurfaceMesh mesh = enduring::box(box.size);
    const Eigen::AngleAxisd turn(box.turn_deg * std::numbers::pi / 180, box.axis);
    for (Vec3& vertex : mesh.vertices)
        vertex = box.centre + turn * vertex;
    return std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), box.mass),
                                       Vec3::Zero(), box.spin);
}

double deepest(const World& world, const Contacts& contacts)
{
    double depth = 0;
    for (const Contact& contact : contacts)
        if (contact.is_spring())
            depth = std::min(depth, contact_geometry(world, contact, 1).depth);
    return -depth;
}

}  // namespace

std::vector<Vec3> centres_of(const World& world)
{
    std::vector<Vec3> centres;
    for (const auto& body : world.bodies)
        centres.push_back(body->centre());
    return centres;
}

double longest_displacement(const World& world, const std::vector<Vec3>& from)
{
    double longest = 0;
    for (std::size_t body = 0; body < from.size(); ++body)
        longest = std::max(longest, (world.bodies[body]->centre() - from[body]).norm());
    return longest;
}

Scene scene_of(const std::vector<Box>& boxes, double dt, double slope_deg, double mu_s, double mu_d)
{
    Scene scene;
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = mu_s, .mu_d = mu_d};
    const double slope = slope_deg * std::numbers::pi / 180;
    scene.world.gravity = 9.81 * Vec3(-std::sin(slope), -std::cos(slope), 0);
    scene.world.planes.push_back({"ground"});
    for (std::size_t i = 0; i < boxes.size(); ++i)
        scene.world.bodies.push_back(body_of(boxes[i], "box " + std::to_string(i + 1)));
    return scene;
}

std::vector<Box> stack_of(int n, double first_mass, double last_mass, double turn_deg)
{
    std::vector<Box> boxes;
    for (int i = 0; i < n; ++i)
        boxes.push_back({i == 0       ? first_mass
                         : i == n - 1 ? last_mass
                                      : 10,
                         Vec3(0, 0.5 + i, 0), turn_deg * i});
    return boxes;
}

std::vector<Box> many_stacks(int n)
{
    std::vector<Box> boxes;
    const int side = static_cast<int>(std::ceil(std::sqrt(n / 5.0)));
    for (int stack = 0; stack < n / 5; ++stack) {
        const int row = stack / side, column = stack % side;
        for (Box box : stack_of(5)) {
            box.centre += 3 * Vec3(column, 0, row);
            boxes.push_back(box);
        }
    }
    return boxes;
}

std::vector<Box> loose_cubes(int n, int side, unsigned seed)
{
    std::mt19937 random(seed);
    const auto number = [&] { return static_cast<double>(random()) / std::mt19937::max(); };  // 0 to 1
    std::vector<Box> boxes;
    for (int i = 0; i < n; ++i) {
        const int layer = i / (side * side), place = i % (side * side);
        const Vec3 at(place % side - 0.5 * (side - 1), 0.6 + layer, place / side - 0.5 * (side - 1));
        const double x = number(), y = number(), z = number(), turn_deg = 180 * number();
        boxes.push_back({10, 1.8 * at, turn_deg, (Vec3(x, y, z) - Vec3::Constant(0.5)).normalized()});
    }
    return boxes;
}

void SolveStatistics::add(const SolveRecord& record)
{
    ++solves;
    unconverged += !record.converged;
    max_newton_steps = std::max(max_newton_steps, record.newton_steps);
    worst_residual = std::max(worst_residual, record.residual);
}

std::function<Solver(const ContactParameters&)> counting_solver(MakeSolver make, SolveStatistics& solves)
{
    return [make, &solves](const ContactParameters& parameters) {
        ImplicitSettings settings;
        settings.record = [&solves](const SolveRecord& record) { solves.add(record); };
        return make(parameters, settings);
    };
}

PileOutcome watch(Scene& scene, double duration, MakeSolver make, Probe* observer)
{
    PileOutcome outcome;
    ImplicitSettings settings;
    settings.record = [&](const SolveRecord& record) {
        outcome.solves.add(record);
        outcome.newton_steps_at_rest = record.newton_steps;
    };
    const Solver solver = make(scene.contact, settings);
    World& world = scene.world;
    Contacts contacts;
    const double first = total_energy(world).total();
    const int steps = static_cast<int>(std::lround(duration / scene.dt));
    const std::vector<Vec3> at_first = centres_of(world);
    std::vector<Vec3> at_half_time;
    if (observer)
        observer->observe(world, contacts, scene.dt);
    for (int i = 0; i < steps; ++i) {
        if (i == steps / 2)
            at_half_time = centres_of(world);
        advance(world, contacts, solver, scene.dt);
        outcome.energy_gain_j = std::max(outcome.energy_gain_j, total_energy(world).total() - first);
        outcome.deepest_mm = 1000 * deepest(world, contacts);
        outcome.deepest_ever_mm = std::max(outcome.deepest_ever_mm, outcome.deepest_mm);
        if (observer)
            observer->observe(world, contacts, scene.dt);
    }
    outcome.pairs = static_cast<long>(contacts.size());
    outcome.moved_mm = 1000 * longest_displacement(world, at_first);
    outcome.drift_um_per_s = 1e6 * longest_displacement(world, at_half_time) / (0.5 * duration);
    return outcome;
}

}  // namespace enduring::chapter07
