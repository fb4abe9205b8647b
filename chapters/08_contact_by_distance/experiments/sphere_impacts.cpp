#include "chapters/08_contact_by_distance/experiments/sphere_impacts.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "chapters/08_contact_by_distance/experiments/formula_runs.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace enduring::chapter08 {
namespace {

constexpr double ball_density = 1000;  // [kg/m^3]

struct RoundBall {
    double mass, inertia;  // of a round one
};

RoundBall round_ball(double radius)
{
    const double mass = ball_density * 4 / 3 * std::numbers::pi * std::pow(radius, 3);
    return {mass, 0.4 * mass * radius * radius};
}

/// With a vertex at the bottom.
SurfaceMesh ball_on_vertex(double radius, int subdivisions)
{
    const SurfaceMesh mesh = sphere(radius, subdivisions);
    return turned(mesh, Quaternion::FromTwoVectors(mesh.vertices.front(), -Vec3::UnitY()));
}

Vec3 area_vector(const SurfaceMesh& mesh, const Face& face)
{
    const auto corner = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(face.at(i))]; };
    return (corner(1) - corner(0)).cross(corner(2) - corner(0));
}

/// With the largest face on top: it is equilateral, in the middle of a face of the icosahedron.
SurfaceMesh ball_under_face(double radius, int subdivisions)
{
    const SurfaceMesh mesh = sphere(radius, subdivisions);
    const Face largest = *std::max_element(
        mesh.faces.begin(), mesh.faces.end(), [&](const Face& a, const Face& b) {
            return area_vector(mesh, a).norm() < area_vector(mesh, b).norm() * (1 - 1e-9);
        });
    return turned(mesh, Quaternion::FromTwoVectors(area_vector(mesh, largest), Vec3::UnitY()));
}

/// Moves it so that its lowest or highest point is at a height.
void shift_to(SurfaceMesh& mesh, bool lowest, double height)
{
    const auto lower = [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); };
    const auto [low, high] = std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(), lower);
    const Vec3 shift(0, height - (lowest ? low : high)->y(), 0);
    for (Vec3& vertex : mesh.vertices)
        vertex += shift;
}

void add_ball(Scene& scene, const std::string& name, const SurfaceMesh& mesh, double radius,
              const Vec3& velocity, double spin)
{
    scene.world.bodies.push_back(std::make_unique<RigidBody>(
        name, mesh, with_mass(mass_properties(mesh, ball_density), round_ball(radius).mass), velocity,
        Vec3(0, 0, spin)));
}

Scene scene_of(const SphereImpact& impact)
{
    Scene scene = chapter07::scene_of({}, impact.dt, 0, impact.mu, impact.mu);
    scene.world.gravity = Vec3::Zero();
    scene.world.restitution.between = {impact.restitution};
    SurfaceMesh mesh = ball_on_vertex(sphere_radius, impact.subdivisions);
    if (impact.askew)
        mesh = turned(mesh, Quaternion(Eigen::AngleAxisd(0.3, Vec3(1, 0, 2).normalized())));
    shift_to(mesh, true, impact.gap);
    add_ball(scene, "ball", mesh, sphere_radius, Vec3(impact.along, -impact.normal_speed, 0), impact.spin);
    if (impact.other_radius > 0) {
        scene.world.planes.clear();
        SurfaceMesh other = ball_under_face(impact.other_radius, impact.subdivisions);
        shift_to(other, false, 0);
        add_ball(scene, "other ball", other, impact.other_radius, Vec3::Zero(), impact.other_spin);
    }
    return scene;
}

double parting_speed(const Scene& scene)
{
    const double other = scene.world.bodies.size() > 1 ? formula_runs::motion_of(scene, 1).velocity().y() : 0;
    return formula_runs::motion_of(scene, 0).velocity().y() - other;
}

}  // namespace

//! [strike]
AfterImpact strike(const SphereImpact& impact)
{
    const RoundBall ball = round_ball(sphere_radius);
    double inverse_mass = 1 / ball.mass,
           inverse_along = 1 / ball.mass + sphere_radius * sphere_radius / ball.inertia,
           slip = impact.along + sphere_radius * impact.spin;
    if (const double r = impact.other_radius; r > 0) {
        const RoundBall other = round_ball(r);
        inverse_mass += 1 / other.mass;
        inverse_along += 1 / other.mass + r * r / other.inertia;
        slip += r * impact.other_spin;
    }
    const double sliding = impact.mu * (1 + impact.restitution) * impact.normal_speed / inverse_mass,
                 sticking = std::abs(slip) / inverse_along;
    const double impulse = -std::copysign(std::min(sliding, sticking), slip);
    //! [strike]

    Scene scene = scene_of(impact);
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    for (int i = 0, touched = 0; i < 10000 && touched < 2; ++i) {
        advance(scene.world, contacts, solver, impact.dt);
        touched += parting_speed(scene) > -0.01 * impact.normal_speed;
    }
    const RigidMotion& after = formula_runs::motion_of(scene, 0);
    AfterImpact result{
        {after.velocity().x(), impact.along + impulse / ball.mass},
        {sphere_radius * after.angular_velocity().z(),
         sphere_radius * impact.spin + impulse * sphere_radius * sphere_radius / ball.inertia},
        parting_speed(scene) / impact.normal_speed,
    };
    result.largest_off = std::max(std::abs(result.along.measured - result.along.formula),
                                  std::abs(result.rim.measured - result.rim.formula)) /
                         std::hypot(impact.normal_speed, slip);
    return result;
}

namespace {

Scene ball_on_ground(double dt, int subdivisions, double mu, double speed, double spin)
{
    Scene scene = chapter07::scene_of({}, dt, 0, mu, mu);
    SurfaceMesh mesh = ball_on_vertex(sphere_radius, subdivisions);
    shift_to(mesh, true, 0);
    add_ball(scene, "ball", mesh, sphere_radius, Vec3(speed, 0, 0), spin);
    return scene;
}

}  // namespace

SlideToRoll slide_to_roll(double dt, int subdivisions)
{
    constexpr double speed = 2, mu = 0.3, duration = 2 * speed / (7 * mu * formula_runs::earth);
    Scene scene = ball_on_ground(dt, subdivisions, mu, speed, 0);
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    const auto slip = [&] {
        return formula_runs::motion_of(scene, 0).velocity().x() +
               sphere_radius * formula_runs::motion_of(scene, 0).angular_velocity().z();
    };
    const auto go_on = [&](double until) {
        while (scene.world.time < until - 0.5 * dt)
            advance(scene.world, contacts, solver, dt);
    };
    go_on(0.2 * duration);
    const double first_slip = slip(), first_time = scene.world.time;
    go_on(0.8 * duration);
    const double rate = (first_slip - slip()) / (scene.world.time - first_time);
    go_on(1.1 * duration);
    return {{speed / rate, duration}, {formula_runs::motion_of(scene, 0).velocity().x(), 5.0 / 7 * speed}};
}

AgainstFormula keeps_rolling(double dt, int subdivisions)
{
    constexpr double speed = 1, duration = 0.5;
    Scene scene = ball_on_ground(dt, subdivisions, 0.5, speed, -speed / sphere_radius);
    const Solver solver = chapter08_solver(scene.contact);
    Contacts contacts;
    for (long i = std::lround(duration / dt); i > 0; --i)
        advance(scene.world, contacts, solver, dt);
    return {formula_runs::motion_of(scene, 0).velocity().x(), speed};
}

}  // namespace enduring::chapter08
