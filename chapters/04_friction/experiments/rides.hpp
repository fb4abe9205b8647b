#pragma once

#include "common/geometry/box_shapes.hpp"
#include "common/geometry/moved_mesh.hpp"
#include "common/geometry/tetrahedral_shapes.hpp"
#include "common/scenes/scene.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"
#include "common/simulation/driven_body.hpp"
#include "common/simulation/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

/// Bodies that ride on what turns. Only headers: later chapters take the same rides.
namespace enduring::rides {

enum class Ground {
    table,      ///< level, turns about the vertical
    soft_slab,  ///< a deformable slab that lies on the table and carries the load
    /// a floor that turns about a level axis above it, head over heels, fast enough to press the load on
    wheel
};
enum class Load {
    block,  ///< stands on its corners: vertices on faces
    grate   ///< two ridges across a narrow ground: edges on edges
};

/// A load of 20 kg at 1 m from the axis, which comes to rest on what carries it during the first turn.
struct Ride {
    Ground ground = Ground::table;
    Load load = Load::block;
    int steps = 1256;              ///< of a turn; on the table 5 ms each
    double mu_s = 0.8;             ///< mu_d is half of it
    double turned_at_first = 0.3;  ///< of the load, about the ground's normal [rad]
    int turns = 2;                 ///< after the first

    double dt() const { return 2 * std::numbers::pi / (rate() * steps); }  ///< [s]
    double rate() const { return ground == Ground::wheel ? 6 : 1; }        ///< [rad/s]
    Vec3 axis() const { return ground == Ground::wheel ? Vec3(0, 0, 1) : Vec3(0, 1, 0); }
};

/// One turn after the first, with a step near the largest that the pairs bear.
inline Ride short_ride(Ground ground, Load load)
{
    Ride ride{ground, load};
    ride.steps = ground == Ground::wheel ? 209 : 1256;
    ride.turns = 1;
    return ride;
}

struct RideRecord {
    std::vector<double> creep;             ///< along the ground, in each turn after the first [m]
    bool slipped = false;                  ///< any pair, after the first turn
    int vertex_faces = 0, edge_edges = 0;  ///< pairs that push at the end
    double turned = 0;                     ///< the load against the ground, after the first turn [rad]
};

inline SurfaceMesh merged(SurfaceMesh one, const SurfaceMesh& other)
{
    const int first = static_cast<int>(one.vertices.size());
    one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const Face& face : other.faces)
        one.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
    return one;
}

inline Mat3 turned_about(const Vec3& axis, double angle)
{
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

/// The load with its lowest points at height 0, its middle on the vertical through the origin.
inline SurfaceMesh load_mesh(Load load)
{
    if (load == Load::block)
        return moved(box({0.24, 0.1, 0.2}), {0, 0.05, 0});
    const Mat3 on_edge = turned_about(Vec3::UnitZ(), std::numbers::pi / 4);
    const SurfaceMesh ridge = placed(box({0.08, 0.08, 0.6}), on_edge, {0, 0.04 * std::numbers::sqrt2, 0});
    return merged(moved(ridge, {-0.12, 0, 0}), moved(ridge, {0.12, 0, 0}));
}

inline SurfaceMesh ground_mesh(const Ride& ride)
{
    const double width = ride.load == Load::grate && ride.ground != Ground::soft_slab ? 0.3 : 0.7;
    const Vec3 middle = ride.ground == Ground::wheel ? Vec3(0, -1.05, 0) : Vec3(1, -0.05, 0);
    const int cells = ride.ground == Ground::soft_slab ? 1 : 5;
    return moved(box({0.7, 0.1, width}, {cells, 1, cells}), middle);
}

inline std::unique_ptr<Body> soft_slab(const Ride& ride, double top)
{
    DeformableSettings settings;
    settings.material = {.young = 4e5, .poisson = 0.3, .density = 500, .stiffness_damping = 0.01};
    settings.position = {1, top - 0.05, 0};
    settings.velocity = ride.rate() * ride.axis().cross(settings.position);
    settings.angular_velocity = ride.rate() * ride.axis();
    settings.impulse_response = ImpulseResponse::implicit;
    return std::make_unique<DeformableBody>(
        "slab", bar({0.5, 0.1, ride.load == Load::grate ? 0.3 : 0.5}, {4, 1, 4}), settings);
}

/// Everything moves along from the start, with gaps of a hair: a pair begins with a crossing.
inline World world_of(const Ride& ride)
{
    constexpr double gap = 1e-6;
    World world;
    world.bodies.push_back(
        std::make_unique<DrivenBody>("ground", ground_mesh(ride), Vec3::Zero(),
                                     GivenMotion::steady(Vec3::Zero(), ride.rate() * ride.axis())));
    double height = gap;
    if (ride.ground == Ground::soft_slab) {
        height += 0.1 + gap;
        world.bodies.push_back(soft_slab(ride, height - gap));
    }
    const Vec3 foot = ride.ground == Ground::wheel ? Vec3(0, height - 1, 0) : Vec3(1, height, 0);
    const SurfaceMesh load = placed(load_mesh(ride.load), turned_about(Vec3::UnitY(), ride.turned_at_first),
                                    foot);
    const MassProperties properties = with_mass(mass_properties(load, 1000), 20);
    world.bodies.push_back(std::make_unique<RigidBody>("load", load, properties,
                                                       ride.rate() * ride.axis().cross(properties.centre),
                                                       ride.rate() * ride.axis()));
    return world;
}

/// Takes the ride with any chapter's solver.
/// @param make_solver  from ContactParameters
template <class MakeSolver>
RideRecord take(const Ride& ride, const MakeSolver& make_solver)
{
    // [N/m]; the slab has many pairs
    const double stiffness = ride.ground == Ground::soft_slab ? 4000 : 40000;
    const ContactParameters parameters{
        PenaltyMethod::continuous, stiffness,
        MassSplitting{.mu_s = ride.mu_s, .mu_d = 0.5 * ride.mu_s, .spring = stiffness}};
    const Solver solver = make_solver(parameters);
    World world = world_of(ride);
    Contacts contacts;
    const auto& ground = dynamic_cast<const DrivenBody&>(*world.bodies.front());
    const Body& load = *world.bodies.back();

    RideRecord record;
    const auto place = [&](std::size_t vertex) { return ground.brought_back(load.positions_t0()[vertex]); };
    const auto middle = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t v = 0; v < load.positions_t0().size(); ++v)
            sum += place(v) / static_cast<double>(load.positions_t0().size());
        return sum;
    };
    Vec3 before = Vec3::Zero(), direction = Vec3::Zero();
    for (int turn = 0; turn <= ride.turns; ++turn) {
        for (int step = 0; step < ride.steps; ++step) {
            advance(world, contacts, solver, ride.dt());
            record.slipped = record.slipped ||
                             (turn > 0 && std::any_of(contacts.begin(), contacts.end(),
                                                      [](const Contact& c) { return c.spring.slip > 0; }));
        }
        const Vec3 moved = middle() - before;
        if (turn == 0)
            direction = (place(4) - place(0)).normalized();
        else
            record.creep.push_back((moved - moved.y() * Vec3::UnitY()).norm());
        before = middle();
    }
    record.turned = std::acos(std::min(1.0, direction.dot((place(4) - place(0)).normalized())));
    for (const Contact& contact : contacts)
        if (contact.impulse.norm() > 0)
            ++(contact.kind == ContactKind::vertex_face ? record.vertex_faces : record.edge_edges);
    return record;
}

}  // namespace enduring::rides
