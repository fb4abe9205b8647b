#include "chapters/08_contact_by_distance/experiments/jam_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/07_implicit_contact/experiments/rest_scenes.hpp"
#include "chapters/08_contact_by_distance/experiments/shapes.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace enduring::chapter08 {
namespace {

/// What the scenes of all kinds choose first.
struct JamPlan {
    double angle;  ///< of planes against the vertical [rad]
    double mu, dt;
    Vec3 velocity;  ///< of what falls [m/s]
};

JamPlan random_plan(Numbers& numbers)
{
    const double angle = numbers.within(5, 30) * std::numbers::pi / 180, mu = numbers.within(0.3, 1.5);
    const double dt = 0.001 * std::pow(20, numbers.next());
    return {angle, mu, dt, -numbers.within(0.5, 3) * Vec3::UnitY()};
}

/// A plane through a point, which leans outwards by the angle.
Plane leaning(const std::string& name, const Vec3& point, const Vec3& outwards, double angle)
{
    return {name, point, -std::cos(angle) * outwards + std::sin(angle) * Vec3::UnitY()};
}

void add_body(Scene& scene, const SurfaceMesh& mesh, double mass, const Vec3& velocity = Vec3::Zero())
{
    const std::string name = "body " + std::to_string(scene.world.bodies.size() + 1);
    scene.world.bodies.push_back(
        std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass), velocity));
}

Eigen::Quaterniond small_turn(Numbers& numbers, double most_deg)
{
    const double angle = numbers.within(-most_deg, most_deg) * std::numbers::pi / 180;
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
}

/// How far a mesh has to be lifted until it touches these planes from above [m].
double lift_onto(const std::vector<Plane>& planes, const SurfaceMesh& mesh)
{
    double lift = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes)
        for (const Vec3& vertex : mesh.vertices)
            lift = std::max(lift, plane.normal.dot(plane.point - vertex) / plane.normal.y());
    return lift;
}

/// Where a body begins that touches after five steps.
Vec3 five_steps_above(const JamPlan& plan, double lift)
{
    return lift * Vec3::UnitY() - 5 * plan.dt * plan.velocity;
}

Scene wedge_scene(const JamPlan& plan, Numbers& numbers)
{
    Scene scene = chapter07::scene_of({}, plan.dt, 0, plan.mu, plan.mu);
    scene.world.planes = {leaning("left", Vec3::Zero(), -Vec3::UnitX(), plan.angle),
                          leaning("right", Vec3::Zero(), Vec3::UnitX(), plan.angle)};
    const Vec3 at(numbers.within(-0.05, 0.05), 0, 0);
    const SurfaceMesh cube = placed(box(Vec3::Ones()), small_turn(numbers, 10), at);
    const double lift = lift_onto(scene.world.planes, cube);
    add_body(scene, moved(cube, five_steps_above(plan, lift)), 10, plan.velocity);
    return scene;
}

Scene arch_scene(const JamPlan& plan, Numbers& numbers)
{
    const int stones = 5 + 2 * numbers.below(9);
    const double radius = numbers.within(2, 4);
    Scene scene = chapter07::arch(stones, radius, plan.dt, numbers.within(0.8, 1));
    scene.contact.friction = MassSplitting{.mu_s = plan.mu, .mu_d = plan.mu};
    const Vec3 at(numbers.within(-0.5, 0.5), radius + 0.5 + std::sqrt(0.5), 0);
    add_body(scene, placed(box(Vec3::Ones()), small_turn(numbers, 45), at + five_steps_above(plan, 0)),
             numbers.within(10, 100), plan.velocity);
    return scene;
}

Scene trough_scene(const JamPlan& plan, Numbers& numbers)
{
    constexpr double gap = 1e-3, thick = 0.2;
    Scene scene = chapter07::scene_of({}, plan.dt, 0, plan.mu, plan.mu);
    const int count = 2 + numbers.below(4);
    double right = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 size(numbers.within(0.3, 0.6), numbers.within(0.45, 0.5), numbers.within(0.4, 0.8));
        add_body(scene, moved(box(size), Vec3(right + size.x() / 2, size.y() / 2 + gap, 0)),
                 numbers.within(1, 10));
        right += size.x() + gap;
    }
    scene.world.planes.push_back(leaning("left", -gap * Vec3::UnitX(), -Vec3::UnitX(), plan.angle));
    scene.world.planes.push_back(leaning("right", right * Vec3::UnitX(), Vec3::UnitX(), plan.angle));
    const Vec3 above(right / 2, 0.5 + 4 * gap + thick / 2 + 0.02 * right, 0);
    add_body(scene,
             placed(box({0.9 * right, thick, 1}), small_turn(numbers, 2), above + five_steps_above(plan, 0)),
             numbers.within(100, 1000), plan.velocity);
    return scene;
}

Scene funnel_scene(const JamPlan& plan, Numbers& numbers)
{
    Scene scene = chapter07::scene_of({}, plan.dt, 0, plan.mu, plan.mu);
    for (const Vec3& outwards : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
        scene.world.planes.push_back(leaning("wall", 0.25 * outwards, outwards, plan.angle));
    const int count = 4 + numbers.below(6);
    double above = -std::numeric_limits<double>::infinity();  // the highest vertex so far
    for (int i = 0; i < count; ++i) {
        const SurfaceMesh mesh = placed(shape_of(mixed_family, numbers), numbers.turn(), Vec3::Zero());
        const auto [low, high] = std::minmax_element(
            mesh.vertices.begin(), mesh.vertices.end(),
            [](const Vec3& one, const Vec3& other) { return one.y() < other.y(); });
        const double lift = std::max(lift_onto(scene.world.planes, mesh), above + 0.01 - low->y());
        above = high->y() + lift;
        add_body(scene, moved(mesh, five_steps_above(plan, lift)), numbers.within(1, 10), plan.velocity);
    }
    return scene;
}

}  // namespace

std::string name_of(Jam jam)
{
    constexpr std::array<const char*, all_jams.size()> names{"a cube in a wedge", "an arch",
                                                             "boxes in a trough", "a heap in a funnel"};
    return names.at(static_cast<std::size_t>(jam));
}

Scene random_jam(Jam jam, unsigned seed)
{
    Numbers numbers(seed);
    const JamPlan plan = random_plan(numbers);
    switch (jam) {
        case Jam::wedge: return wedge_scene(plan, numbers);
        case Jam::arch: return arch_scene(plan, numbers);
        case Jam::trough: return trough_scene(plan, numbers);
        default: return funnel_scene(plan, numbers);
    }
}

}  // namespace enduring::chapter08
