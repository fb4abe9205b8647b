#include "chapters/13_other_solvers/barrier.hpp"

#include "chapters/08_contact_by_distance/begins_inside.hpp"
#include "chapters/08_contact_by_distance/skin.hpp"
#include "chapters/13_other_solvers/incremental_potential.hpp"
#include "common/input/input_error.hpp"
#include "common/simulation/contact_geometry.hpp"
#include "common/simulation/deformable_body.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace enduring {
namespace {

/// The farthest that a vertex goes in the step as it is predicted [m].
double longest_way(const World& world)
{
    double longest = 0;
    for (const auto& body : world.bodies)
        for (std::size_t v = 0; v < body->positions_t0().size(); ++v)
            longest = std::max(longest, (body->positions_t1()[v] - body->positions_t0()[v]).norm());
    return longest;
}

[[noreturn]] void refuse(const std::string& one, const std::string& other)
{
    throw InputError("'" + one + "' begins inside '" + other + "'; a barrier cannot begin inside");
}

}  // namespace

//! [begin]
/// Surfaces half of d^hat inside, which have to be apart from each other and in front of all planes.
void BarrierMethod::begin(World& world)
{
    double size = std::numeric_limits<double>::infinity();
    for (const auto& body : world.bodies)
        if (!body->is_static())
            size = std::min(size, body->size());
    if (!std::isfinite(size)) {
        size_ = size;
        return;
    }
    const double inset = settings_.distance * size / 2;
    for (const auto& body : world.bodies)
        if (body->surface().is_closed() && dynamic_cast<const DeformableBody*>(body.get()) == nullptr)
            body->take_contact_surface(inset_surface(body->surface(), body->shape(), inset));
    for (const auto& [a, b] : bodies_inside_each_other(world))
        refuse(world.bodies[static_cast<std::size_t>(a)]->name(),
               world.bodies[static_cast<std::size_t>(b)]->name());
    for (const auto& body : world.bodies)
        for (const Plane& plane : world.planes)
            for (const Vec3& x : body->contact_t0())
                if (!body->is_static() && plane.normal.dot(x - plane.point) + inset <= 0)
                    refuse(body->name(), plane.name);
    size_ = size;  // a step that is refused here is refused again when its halves are tried
}
//! [begin]

//! [find]
Contacts BarrierMethod::find(World& world)
{
    whole_dt_ = world.whole_dt;
    if (size_ == 0)
        begin(world);
    Contacts contacts;
    if (!std::isfinite(size_))
        return contacts;
    for (const auto& body : world.bodies)
        if (body->is_static() && !std::equal(body->positions_t0().begin(), body->positions_t0().end(),
                                             body->positions_t1().begin()))
            throw InputError("body '" + body->name() +
                             "' moves as given; the barrier method knows what moves freely and what stands");
    reach_ = settings_.least_reach * size_ + settings_.reach * longest_way(world);
    search_.find_candidates(world,
                            std::vector<double>(world.bodies.size(), reach_ + settings_.distance * size_));
    const auto apart = [&](int body_a, int body_b, const NearestPoints& nearest) {
        if (nearest.difference.isZero(0))
            refuse(world.bodies[static_cast<std::size_t>(body_a)]->name(),
                   world.bodies[static_cast<std::size_t>(body_b)]->name());
        return nearest.difference.normalized();
    };
    search_.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
            const auto [f0, f1, f2] = b.face(face);
            const NearestPoints nearest =
                nearest_of_point_triangle({a.start(vertex), b.start(f0), b.start(f1), b.start(f2)});
            const auto& w = nearest.weights;
            contacts.push_back(vertex_pair(body_a, vertex, body_b, b, face, face, {-w[1], -w[2], -w[3]},
                                           apart(body_a, body_b, nearest)));
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
            const auto [a0, a1] = a.edge(edge_a);
            const auto [b0, b1] = b.edge(edge_b);
            const NearestPoints nearest =
                nearest_of_edges({a.start(a0), a.start(a1), b.start(b0), b.start(b1)});
            contacts.push_back(edge_pair(body_a, a, edge_a, body_b, b, edge_b, nearest.weights[1],
                                         -nearest.weights[3], apart(body_a, body_b, nearest)));
        });
    for (std::size_t body = 0; body < world.bodies.size(); ++body)
        for (std::size_t plane = 0; !world.bodies[body]->is_static() && plane < world.planes.size(); ++plane)
            for (int v = 0; v < world.bodies[body]->surface().vertex_count(); ++v) {
                contacts.push_back(plane_pair(static_cast<int>(body), static_cast<int>(plane), v));
                contacts.back().normal_t0 = world.planes[plane].normal;
            }
    sort_by_keys(contacts);
    return contacts;
}
//! [find]

namespace {

//! [newton]
/// Projected Newton's method from places that do not touch: every step ends at such places, with less energy.
/// @param is_solved  whether the last direction was shorter than the tolerance
Places minimum(const IncrementalPotential& potential, const Places& from, double least_step,
               const BarrierSettings& settings, bool& is_solved)
{
    is_solved = false;
    Places places = from;
    double energy = potential.value(places);
    for (int step = 0; step < settings.max_steps; ++step) {
        const PotentialSlopes slopes = potential.slopes(places);
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(slopes.hessian());
        const Eigen::VectorXd direction = -factor.solve(slopes.gradient());
        const double slope = slopes.gradient().dot(direction);
        double part = potential.free_part(places, direction);
        int halvings = 0;
        for (; part > 0 && halvings < settings.line_search_steps; ++halvings, part /= 2) {
            const Places to = potential.moved(places, part * direction);
            const double there = potential.value(to);
            if (there <= energy + 1e-4 * part * slope + 1e-14 * std::abs(energy)) {
                places = to;
                energy = there;
                break;
            }
        }
        is_solved = direction.lpNorm<Eigen::Infinity>() <= least_step;
        if (part == 0 || halvings == settings.line_search_steps || is_solved)
            break;
    }
    return places;
}
//! [newton]

}  // namespace

//! [barrier]
void BarrierMethod::operator()(MethodStep& step) const
{
    if (!std::isfinite(size_))
        return;
    IncrementalPotential potential(step, settings_, settings_.distance * size_, reach_, whole_dt_);
    Places places;
    for (const MovingBody& body : step.bodies)
        places.poses.push_back(body.start);
    for (const SoftNode& node : step.nodes)
        places.nodes.push_back(node.start);
    const double held = potential.held(places);
    for (int solve = 0; solve < settings_.lags; ++solve) {
        potential.lag(places);
        places = minimum(potential, places, settings_.tolerance * size_ * step.dt, settings_, step.is_solved);
    }
    step.given = held - potential.held(places);
    const std::vector<Vec3> impulses = potential.impulses(places);
    for (std::size_t n = 0; n < step.points.size(); ++n)
        step.points[n].impulse = impulses[n];
    for (std::size_t i = 0; i < step.bodies.size(); ++i)
        if (MovingBody& body = step.bodies[i]; body.moves) {
            body.pose = places.poses[i];
            body.velocity = (body.pose.position - body.start.position) / step.dt;
            body.angular_velocity =
                rotation_vector(body.pose.orientation * body.start.orientation.conjugate()) / step.dt;
        }
    for (std::size_t n = 0; n < step.nodes.size(); ++n) {
        SoftNode& node = step.nodes[n];
        node.place = places.nodes[n];
        node.velocity = (node.place - node.start) / step.dt;
    }
}
//! [barrier]

Solver chapter13_barrier_solver(const ContactParameters& parameters, const BarrierSettings& settings)
{
    const auto method = std::make_shared<BarrierMethod>(settings);
    Solver solver = method_solver(
        "barrier", parameters, [method](MethodStep& step) { (*method)(step); }, SoftBodies::any_law,
        PairSearch([method](World& world) { return method->find(world); }));
    solver.max_halvings = settings.max_halvings;
    return solver;
}

}  // namespace enduring
