#include "chapters/08_contact_by_distance/experiments/forces_rows.hpp"

#include "common/geometry/box_shapes.hpp"
#include "common/simulation/contact_forces.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/natural_units.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace enduring::chapter08::force_rows {

void Row::add(const std::string& run, double off_in_unit)
{
    const double found = std::isfinite(off_in_unit) ? off_in_unit : std::numeric_limits<double>::infinity();
    ++runs;
    if (worst.empty() || found > off) {
        off = found;
        worst = run;
    }
}

std::string named(const std::string& name, double value)
{
    std::ostringstream text;
    text << name << ' ' << value;
    return text.str();
}

Scene empty_scene(double dt, double mu)
{
    Scene scene;
    scene.dt = dt;
    scene.contact.friction = MassSplitting{.mu_s = mu, .mu_d = mu};
    return scene;
}

void add_ground(Scene& scene, double slope_rad)
{
    scene.world.planes.push_back(
        {"ground", Vec3::Zero(), Vec3(-std::sin(slope_rad), std::cos(slope_rad), 0)});
}

RigidBody& add_rigid(Scene& scene, const std::string& name, const SurfaceMesh& mesh, double mass,
                     const Vec3& velocity, const Vec3& angular_velocity)
{
    auto body = std::make_unique<RigidBody>(name, mesh, with_mass(mass_properties(mesh, 1000), mass),
                                            velocity, angular_velocity);
    RigidBody& added = *body;
    scene.world.bodies.push_back(std::move(body));
    return added;
}

void add_static(Scene& scene, const std::string& name, const SurfaceMesh& mesh)
{
    scene.world.bodies.push_back(std::make_unique<StaticBody>(
        name, SurfaceTopology(static_cast<int>(mesh.vertices.size()), mesh.faces), mesh.vertices));
}

Quaternion random_turn(std::mt19937& random)
{
    const auto number = [&] { return 2 * (static_cast<double>(random()) / std::mt19937::max()) - 1; };
    const double w = number(), x = number(), y = number(), z = number();
    return Quaternion(w, x, y, z).normalized();
}

Vec3 lowest(const SurfaceMesh& mesh)
{
    return *std::min_element(mesh.vertices.begin(), mesh.vertices.end(),
                             [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
}

SurfaceMesh together(SurfaceMesh one, const SurfaceMesh& other)
{
    const int before = static_cast<int>(one.vertices.size());
    one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (Face face : other.faces) {
        for (int& corner : face)
            corner += before;
        one.faces.push_back(face);
    }
    return one;
}

std::string name_of(Floor floor)
{
    return floor == Floor::plane ? "plane" : floor == Floor::box ? "box" : "cut box";
}

void add_floor(Scene& scene, Floor floor, double side)
{
    if (floor == Floor::plane) {
        add_ground(scene);
        return;
    }
    const int cells = floor == Floor::box ? 1 : 7;
    const Vec3 askew = floor == Floor::box ? Vec3(0, -0.1, 0) : Vec3(0.0131, -0.1, 0.0071);
    add_static(scene, "floor", moved(box({side, 0.2, side}, {cells, 1, cells}), askew));
}

Stepped::Stepped(Scene scene, const MakeSolver& make)
    : scene_(std::move(scene)), solver_(make(scene_.contact))
{}

void Stepped::step()
{
    thrown_before_ = world().thrown_away;
    advance(world(), contacts_, solver_, scene_.dt);
    most_parts_ = std::max(most_parts_, parts());
    for (const auto& body : world().bodies)
        fastest_ = std::max(fastest_, body->mean_velocity().norm());
}

void Stepped::run_for(double duration)
{
    for (long i = std::lround(duration / scene_.dt); i > 0; --i)
        step();
}

void Stepped::come_to_rest(double longest)
{
    // [m/s]; ten times: what comes to rest slowly lacks some 1e-8 of its weight
    constexpr double rest = 1e-12;
    const auto rests = [](const Body& body) {
        for (int i = 0; i < static_cast<int>(body.positions_t0().size()); ++i)
            if (!body.is_static() && body.velocity(i).norm() > rest)
                return false;
        return true;
    };
    run_for(0.1);
    const auto& bodies = world().bodies;
    const double until = world().time + longest;
    while (world().time < until &&
           !std::all_of(bodies.begin(), bodies.end(), [&](const auto& body) { return rests(*body); }))
        step();
}

std::vector<Vec3> Stepped::on_bodies() const { return body_forces(world(), contacts_, scene_.dt); }

Vec3 Stepped::between(int body, int other) const
{
    const double part = last_part(world(), scene_.dt);
    Vec3 sum = Vec3::Zero();
    for (const Contact& contact : contacts_) {
        const int b = contact.on_plane() ? planes : contact.body_b;
        const Vec3 on_a = pair_force(contact, part).total();
        if (contact.body_a == body && b == other)
            sum += on_a;
        else if (b == body && contact.body_a == other)
            sum -= on_a;
    }
    return sum;
}

std::vector<Vec3> Stepped::on_vertices(std::size_t body) const
{
    return vertex_forces(world(), contacts_, scene_.dt)[body];
}

Vec3 Stepped::moment(std::size_t index, const Vec3& about) const
{
    const std::vector<Vec3> forces = on_vertices(index);
    const auto positions = body(index).positions_t0();
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < forces.size(); ++i)
        sum += (positions[i] - about).cross(forces[i]);
    return sum;
}

double Stepped::off_law() const
{
    if (solver_.exact)
        return 0;
    constexpr double trembling = 1e-10;  // of a body's size, by which a pair that pushes nothing may be off
    const double part = last_part(world(), scene_.dt);
    double largest = 0, off = 0;
    for (const Contact& contact : contacts_) {
        if (!contact.is_spring())
            continue;
        const double depth = contact_geometry(world(), contact, 1).depth,
                     spring = contact.spring.stiffness * std::max(0.0, contact.spring.rest_offset - depth),
                     force = pair_force(contact, part).normal.norm();
        largest = std::max({largest, spring, force,
                            contact.spring.stiffness * trembling * natural_length(world(), contact)});
        off = std::max(off, std::abs(force - spring));
    }
    return largest > 0 ? off / largest : 0;
}

}  // namespace enduring::chapter08::force_rows
