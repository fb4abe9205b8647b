#include "chapters/08_contact_by_distance/experiments/soft_contact_scenes.hpp"

#include "chapters/07_implicit_contact/experiments/pile.hpp"
#include "common/geometry/quadratic.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <random>

namespace enduring::chapter08 {
namespace {

std::unique_ptr<DeformableBody> soft_body(const std::string& name, const TetrahedralMesh& mesh, Basis basis,
                                          const DeformableSettings& settings)
{
    return basis == Basis::linear
               ? std::make_unique<DeformableBody>(name, mesh, settings)
               : std::make_unique<DeformableBody>(name, with_edge_midpoints(mesh), settings);
}

DeformableSettings soft_material(double young, double density = 1000)
{
    DeformableSettings settings;
    settings.material = {.young = young, .poisson = 0.3, .density = density, .stiffness_damping = 0.005};
    settings.impulse_response = ImpulseResponse::implicit;
    return settings;
}

/// A rigid body of the same shape and density, in the same motion.
std::unique_ptr<RigidBody> rigid_like(const Body& soft, const DeformableSettings& settings)
{
    SurfaceMesh mesh;
    for (int vertex = 0; vertex < soft.surface().vertex_count(); ++vertex)
        mesh.vertices.push_back(soft.position(vertex, 0));
    for (const Face& face : soft.surface().faces())
        mesh.faces.push_back(face);
    return std::make_unique<RigidBody>(soft.name(), mesh, mass_properties(mesh, settings.material.density),
                                       settings.velocity, settings.angular_velocity);
}

constexpr int ring_cells = 14;  ///< around, and one across

/// A ring of square section around the axis z.
TetrahedralMesh soft_ring(double radius, double thick)
{
    TetrahedralMesh mesh;
    for (int i = 0; i < ring_cells; ++i)
        for (const double out : {-0.5, 0.5})
            for (const double along : {-0.5, 0.5}) {
                const double angle = 2 * std::numbers::pi * i / ring_cells, r = radius + out * thick;
                mesh.nodes.emplace_back(r * std::sin(angle), r * std::cos(angle), along * thick);
            }
    const auto node = [](int i, int out, int along) { return 4 * (i % ring_cells) + 2 * out + along; };
    for (int i = 0; i < ring_cells; ++i) {
        constexpr std::array<std::array<int, 3>, 6> orders{
            {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
        for (const auto& order : orders) {  // six around the diagonal of the cell
            std::array<int, 3> at{};
            std::array<int, 4> element{node(i, 0, 0), 0, 0, 0};
            for (std::size_t n = 0; n < 3; ++n) {
                at[static_cast<std::size_t>(order[n])] = 1;
                element[n + 1] = node(i + at[0], at[1], at[2]);
            }
            const auto x = [&](std::size_t n) { return mesh.nodes[static_cast<std::size_t>(element[n])]; };
            if ((x(1) - x(0)).cross(x(2) - x(0)).dot(x(3) - x(0)) < 0)
                std::swap(element[2], element[3]);
            mesh.elements.push_back(element);
        }
    }
    return mesh;
}

/// The middle line of a ring.
std::vector<Vec3> middle_line(const Body& ring)
{
    const auto& positions = dynamic_cast<const DeformableBody&>(ring).elastic().positions();
    std::vector<Vec3> line;
    line.reserve(ring_cells);
    for (int i = 0; i < ring_cells; ++i)
        line.emplace_back(positions.middleCols<4>(4 * i).rowwise().mean());
    return line;
}

double volume_of(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

}  // namespace

Scene soft_collision(const SoftCollision& collision)
{
    constexpr double side = 0.3, speed = 1.5;
    Scene scene = chapter07::scene_of({}, collision.dt, 0, 0, 0);
    scene.world.planes.clear();
    scene.world.gravity.setZero();
    std::mt19937 random(collision.seed);
    const auto number = [&] { return 2 * (static_cast<double>(random()) / std::mt19937::max()) - 1; };
    for (int i = 0; i < 2; ++i) {
        const double x = number(), y = number(), z = number();
        DeformableSettings settings = soft_material(collision.young);
        settings.material.stiffness_damping = 0;
        settings.rotation = Eigen::AngleAxisd(2 * number(), Vec3(x, y, z).normalized()).toRotationMatrix();
        settings.position = Vec3(i == 0 ? -0.3 : 0.3, 0.08 * number(), 0.08 * number());
        settings.velocity = Vec3(i == 0 ? speed : -speed, 0, 0);
        settings.angular_velocity = Vec3(number(), number(), number());
        std::unique_ptr<Body> cube = soft_body(
            "cube " + std::to_string(i + 1), bar(Vec3::Constant(side), {2, 2, 2}), collision.basis, settings);
        if (i < collision.rigid)
            cube = rigid_like(*cube, settings);
        scene.world.bodies.push_back(std::move(cube));
    }
    return scene;
}

Scene soft_chain(const SoftChain& chain)
{
    constexpr double radius = 0.1, thick = 0.035;
    Scene scene = chapter07::scene_of({}, chain.dt);
    scene.world.planes.clear();
    for (int i = 0; i < chain.rings; ++i) {
        DeformableSettings settings = soft_material(chain.young);
        settings.rotation =
            Eigen::AngleAxisd(0.5 * std::numbers::pi * (i % 2), Vec3::UnitY()).toRotationMatrix();
        settings.position = Vec3(0, 1 - 1.2 * radius * i, 0);
        if (i == 0)
            settings.fixed_nodes = {0, 1, 2, 3};
        scene.world.bodies.push_back(
            soft_body("ring " + std::to_string(i + 1), soft_ring(radius, thick), Basis::linear, settings));
    }
    return scene;
}

int linking_number(const Scene& scene, std::size_t one, std::size_t other)
{
    const std::vector<Vec3> line = middle_line(*scene.world.bodies[one]),
                            rim = middle_line(*scene.world.bodies[other]);
    Vec3 middle = Vec3::Zero();
    for (const Vec3& x : rim)
        middle += x / static_cast<double>(rim.size());
    int linked = 0;  // crossings of the line through the triangles between the rim and its middle
    for (std::size_t i = 0; i < line.size(); ++i)
        for (std::size_t j = 0; j < rim.size(); ++j) {
            const Vec3 &p = line[i], &q = line[(i + 1) % line.size()], &a = rim[j],
                       &b = rim[(j + 1) % rim.size()];
            const bool before = volume_of(middle, a, b, p) > 0, after = volume_of(middle, a, b, q) > 0;
            const bool first = volume_of(p, q, a, b) > 0;
            if (before != after && first == (volume_of(p, q, b, middle) > 0) &&
                first == (volume_of(p, q, middle, a) > 0))
                linked += after ? 1 : -1;
        }
    return linked;
}

Scene cube_on_light_cube(double young, double dt)
{
    Scene scene = chapter07::scene_of({}, dt);
    for (int i = 0; i < 2; ++i) {
        DeformableSettings settings = soft_material(young, i == 0 ? 1 : 1000);
        settings.material.stiffness_damping = 0.01;
        settings.position = Vec3(0.03 * i, 0.5 + 1e-4 + i * (1 + 1e-4), 0.02 * i);
        scene.world.bodies.push_back(soft_body("cube " + std::to_string(i + 1), bar(Vec3::Ones(), {3, 3, 3}),
                                               Basis::linear, settings));
    }
    return scene;
}

Scene twisted_soft_bar(Basis basis, double young, double dt)
{
    Scene scene = chapter07::scene_of({}, dt);
    scene.world.planes.clear();
    scene.world.gravity.setZero();
    const TetrahedralMesh mesh = bar({1, 0.2, 0.2}, {10, 2, 2});
    DeformableSettings settings = soft_material(young);
    settings.material.stiffness_damping = 0.002;
    const auto& nodes = basis == Basis::linear ? mesh.nodes : with_edge_midpoints(mesh).nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].x() < -0.5 + 1e-9)
            settings.fixed_nodes.push_back(static_cast<int>(i));
    scene.world.bodies.push_back(soft_body("bar", mesh, basis, settings));
    Body& body = *scene.world.bodies[0];
    std::vector<double> state = state_of(body);
    // positions of the surface and of the nodes come first
    const std::size_t points = body.surface().vertex_count() + nodes.size();
    for (std::size_t i = 0; i < points; ++i) {
        Eigen::Map<Vec3> x(&state[3 * i]);
        x = Eigen::AngleAxisd(2 * std::numbers::pi * (x.x() + 0.5), Vec3::UnitX()) * Vec3(x);
    }
    restore_state(body, state);
    return scene;
}

Vec3 angular_momentum(const World& world)
{
    Vec3 sum = Vec3::Zero();
    for (const auto& body : world.bodies)
        sum += body->angular_momentum(Vec3::Zero());
    return sum;
}

double turning(const World& world)
{
    double sum = 0;
    for (const auto& body : world.bodies)
        sum += body->angular_momentum(Vec3::Zero()).norm();
    return sum;
}

}  // namespace enduring::chapter08
