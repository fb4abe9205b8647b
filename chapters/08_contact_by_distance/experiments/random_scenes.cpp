#include "chapters/08_contact_by_distance/experiments/random_scenes.hpp"

#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/08_contact_by_distance/solver.hpp"
#include "common/geometry/box_shapes.hpp"
#include "common/geometry/closest_points.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/round_shapes.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/geometry/winding_number.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/rigid_body.hpp"
#include "common/simulation/static_body.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace enduring::chapter08 {
namespace {

class Draw {
public:
    explicit Draw(unsigned seed) : engine_(seed) {}
    double number(double low, double high)
    {
        return low + (high - low) * static_cast<double>(engine_()) / static_cast<double>(engine_.max());
    }
    Vec3 direction() { return Vec3(number(-1, 1), number(-1, 1), number(-1, 1)).stableNormalized(); }
    unsigned kind(unsigned count) { return static_cast<unsigned>(engine_() % count); }

private:
    std::mt19937 engine_;
};

SurfaceMesh shape_of(unsigned kind, double size)
{
    switch (kind) {
        case 0: return box(size * Vec3(1, 1, 1), {1, 2, 1});
        case 1: return box(size * Vec3(1.2, 0.02, 1.2), {2, 1, 2});
        case 2: return box(size * Vec3(0.05, 1.5, 0.05));
        default: return sphere(0.5 * size, 1);
    }
}

/// As stiff as its size and speed ask for, so that it bends visibly and is not crushed.
DeformableSettings soft_settings(double size, double speed, const Vec3& at, const Vec3& velocity)
{
    DeformableSettings settings;
    settings.material.density = 1000;
    settings.material.young = 1000 * (9.81 * size + 10 * speed * speed * size * size) * 20;
    settings.material.poisson = 0.3;
    settings.material.stiffness_damping = 0.005;
    settings.position = at;
    settings.velocity = velocity;
    settings.impulse_response = ImpulseResponse::implicit;
    return settings;
}

}  // namespace

Scene random_scene(unsigned seed)
{
    Draw draw(seed);
    Scene scene;
    const double size = std::pow(10, draw.number(-3, 3)),
                 speed = std::pow(10, draw.number(-1, std::log10(200.0)));
    scene.dt = std::pow(10, draw.number(-3, std::log10(0.04)));
    scene.duration = random_scene_steps * scene.dt;
    scene.contact.friction = MassSplitting{.mu_s = 0.5, .mu_d = 0.4};
    scene.world.gravity = seed % 4 == 3 ? Vec3::Zero() : Vec3(0, -9.81 * std::min(1.0, size / scene.dt), 0);
    if (seed % 3 != 2) {
        const SurfaceMesh floor = moved(box(size * Vec3(6, 1, 6), {3, 1, 3}), {0, -0.5 * size, 0});
        scene.world.bodies.push_back(std::make_unique<StaticBody>(
            "floor", SurfaceTopology(static_cast<int>(floor.vertices.size()), floor.faces), floor.vertices));
    }
    const int bodies = 2 + static_cast<int>(seed % 4);
    for (int i = 0; i < bodies; ++i) {
        const std::string name = "body " + std::to_string(i + 1);
        const unsigned kind = draw.kind(4);
        const Quaternion turn(Eigen::AngleAxisd(draw.number(0, 3), draw.direction()));
        const Vec3 at = size * Vec3(draw.number(-0.6, 0.6), 1.3 + 1.9 * i, draw.number(-0.6, 0.6)),
                   velocity = speed * size *
                              Vec3(draw.number(-0.3, 0.3), -draw.number(0, 1), draw.number(-0.3, 0.3)),
                   spin = std::min(1.0, speed) * draw.number(0, 3) * draw.direction();
        if (seed % 5 == 4) {
            scene.world.bodies.push_back(std::make_unique<DeformableBody>(
                name, bar(Vec3::Constant(0.8 * size), {2, 2, 2}), soft_settings(size, speed, at, velocity)));
            continue;
        }
        const SurfaceMesh mesh = placed(shape_of(kind, size), turn, at);
        scene.world.bodies.push_back(
            std::make_unique<RigidBody>(name, mesh, mass_properties(mesh, 1000), velocity, spin));
    }
    return scene;
}

bool any_crossing(const World& world)
{
    using Box = Eigen::AlignedBox3d;
    const auto box_of = [](const Body& body) {
        Box box;
        for (const Vec3& p : body.contact_t0())
            box.extend(p);
        return box;
    };
    std::vector<Box> boxes;  // what lies beside the other body's cannot cross it
    for (const auto& body : world.bodies)
        boxes.push_back(box_of(*body));
    const auto inside = [](const Body& a, const Body& b, const Box& box) {
        return std::any_of(a.contact_t0().begin(), a.contact_t0().end(), [&](const Vec3& p) {
            return box.contains(p) && winding_number(b.surface().faces(), b.contact_t0(), p) > 0.5;
        });
    };
    const auto pierced = [](const Body& a, const Body& b, const Box& box) {
        return std::any_of(a.surface().edges().begin(), a.surface().edges().end(), [&](const Edge& edge) {
            const Vec3 p = a.contact_point(edge[0], 0), q = a.contact_point(edge[1], 0);
            return box.intersects(Box(p).extend(q)) &&
                   std::any_of(b.surface().faces().begin(), b.surface().faces().end(), [&](const Face& f) {
                       return find_edge_triangle_hit(p, q, b.contact_point(f[0], 0), b.contact_point(f[1], 0),
                                                     b.contact_point(f[2], 0))
                           .has_value();
                   });
        });
    };
    const auto move = [&](std::size_t i, std::size_t j) {
        return !world.bodies[i]->is_static() || !world.bodies[j]->is_static();
    };
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = 0; j < boxes.size(); ++j)
            if (i != j && move(i, j) && boxes[i].intersects(boxes[j]) &&
                (inside(*world.bodies[i], *world.bodies[j], boxes[j]) ||
                 pierced(*world.bodies[i], *world.bodies[j], boxes[j])))
                return true;
    return false;
}

long crossing_steps(Scene& scene, int steps, const std::function<void()>& after_step)
{
    ImplicitSettings quiet;
    quiet.record = [](const SolveRecord&) {};
    const Solver solver = chapter08_solver(scene.contact, quiet);
    Contacts contacts;
    long crossing = 0;
    for (int step = 0; step < steps; ++step) {
        advance(scene.world, contacts, solver, scene.dt);
        crossing += any_crossing(scene.world);
        if (after_step)
            after_step();
    }
    return crossing;
}

double deepest_drawn(const World& world)
{
    double deepest = 0, size = INFINITY;
    for (const auto& body : world.bodies)
        if (!body->is_static())
            size = std::min(size, body->size());
    for (const auto& a : world.bodies)
        for (const auto& b : world.bodies)
            for (const Vec3& p : a->positions_t0()) {
                if (a == b || winding_number(b->surface().faces(), b->positions_t0(), p) < 0.5)
                    continue;
                double nearest = INFINITY;
                for (const auto& [f0, f1, f2] : b->surface().faces())
                    nearest = std::min(nearest, closest_on_triangle(p, b->position(f0, 0), b->position(f1, 0),
                                                                    b->position(f2, 0))
                                                    .distance);
                deepest = std::max(deepest, nearest);
            }
    return deepest / size;
}

}  // namespace enduring::chapter08
