#include "chapters/08_contact_by_distance/crossings.hpp"

#include "chapters/02_collision_detection/certified.hpp"
#include "chapters/02_collision_detection/edge_triangle.hpp"
#include "chapters/02_collision_detection/impact_weights.hpp"
#include "chapters/05_categorisation/normal_span.hpp"
#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/own_points.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <set>

namespace enduring {
namespace {

struct TimedPair {
    double time;
    Contact pair;
    const Contact* known;  ///< the same pair in the list, or null
};

/// Gathers the crossings of each two bodies.
class Query {
public:
    Query(const World& world, const Nearness& nearness, const Contacts& known)
        : world_(world), nearness_(nearness)
    {
        for (const Contact& contact : known)
            known_[key_of(contact)] = &contact;
    }

    void vertex_face(int body_a, int vertex, int body_b, int face)
    {
        const SurfaceStep a = surface_of(world_, body_a), b = surface_of(world_, body_b);
        const VertexFaceStep step = vertex_face_step(a, vertex, b, face);
        const auto time = time_of_impact(step);
        if (!time || closest_on_triangle(step.v_t0, step.f0_t0, step.f1_t0, step.f2_t0).distance <=
                         touching_distance(world_, body_a, body_b))
            return;
        const auto weights = impact_weights(step, *time);
        const Vec3 before = step.v_t0 - weights[0] * step.f0_t0 - weights[1] * step.f1_t0 -
                            weights[2] * step.f2_t0,
                   normal = SurfaceMoment{b, 0}.face_normal(face).stableNormalized();
        const bool in_front = SurfaceMoment{b, *time}.face_normal(face).dot(before) >=
                              0;  // sheets have two sides
        add(*time,
            vertex_pair(body_a, vertex, body_b, b, face, face, weights, in_front ? normal : Vec3(-normal)));
    }

    void edge_edge(int body_a, int edge_a, int body_b, int edge_b)
    {
        const SurfaceStep a = surface_of(world_, body_a), b = surface_of(world_, body_b);
        const EdgeEdgeStep step = edge_edge_step(a, edge_a, b, edge_b);
        const auto time = time_of_impact(step);
        if (!time)
            return;
        const auto [s, t] = impact_weights(step, *time);
        const Vec3 before = lerp(step.ea0_t0, step.ea1_t0, s) - lerp(step.eb0_t0, step.eb1_t0, t);
        const auto along = [&](const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) -> Vec3 {
            return at_time(q0, q1, *time) - at_time(p0, p1, *time);
        };
        const Vec3 u = along(step.ea0_t0, step.ea0_t1, step.ea1_t0, step.ea1_t1),
                   v = along(step.eb0_t0, step.eb0_t1, step.eb1_t0, step.eb1_t1), across = u.cross(v);
        if (across.norm() <= 1e-8 * u.norm() * v.norm() ||
            before.norm() <= touching_distance(world_, body_a, body_b))
            return;  // along one line: its ends cross something, too
        const double side = across.dot(before) < 0 ? -1 : 1;
        const Vec3 normal =
            (side * (step.ea1_t0 - step.ea0_t0).cross(step.eb1_t0 - step.eb0_t0)).stableNormalized();
        Contact pair = edge_pair(body_a, a, edge_a, body_b, b, edge_b, s, t, normal);
        pair.orientation = side;
        add(*time, pair);
    }

    /// The vertices of a body that pass a plane, or whose springs are pressed farther than the skin.
    void planes(int body)
    {
        const Body& moving = *world_.bodies[static_cast<std::size_t>(body)];
        for (int plane = 0; !moving.is_static() && plane < static_cast<int>(world_.planes.size()); ++plane) {
            const Plane& of = world_.planes[static_cast<std::size_t>(plane)];
            for (int vertex = 0; vertex < moving.surface().vertex_count(); ++vertex) {
                const double end = of.normal.dot(moving.position(vertex, 1) - of.point);
                if (end >= 0)
                    continue;
                const Contact pair = plane_pair(body, plane, vertex);
                const double skin = known_.count(key_of(pair)) > 0 ? nearness_.behind_plane(body) : 0;
                const double from = skin + of.normal.dot(moving.position(vertex, 0) - of.point),
                             to = skin + end;
                if (from >= 0 && to < 0)
                    add(from / (from - to), pair);
            }
        }
    }

    /// By their places in World::bodies; planes come before all bodies, the first one is -1.
    std::map<TwoBodies, std::vector<TimedPair>> of_bodies;

private:
    void add(double time, Contact pair)
    {
        if (!pair.on_plane()) {
            pair.gap = nearness_.gap(pair.body_a, pair.body_b);
            put_on_own_surfaces(world_, time, pair);
        }
        const auto same = known_.find(key_of(pair));
        const int body_b = pair.on_plane() ? -1 - pair.body_b : pair.body_b;
        of_bodies[std::minmax({pair.body_a, body_b})].push_back(
            {time, pair, same == known_.end() ? nullptr : same->second});
    }

    const World& world_;
    const Nearness& nearness_;
    std::map<PairKey, const Contact*> known_;
};

/// Whether one of these edges passes through another body where the step ends.
template <class Edges>
bool any_passes_through(const SurfaceStep& a, const Edges& edges, const SurfaceStep& b)
{
    for (const int edge : edges) {
        const auto [p, q] = a.edge(edge);
        const Vec3 low = a.end(p).cwiseMin(a.end(q)), high = a.end(p).cwiseMax(a.end(q));
        for (const auto& [f0, f1, f2] : b.topology.faces()) {
            const Vec3 &x = b.end(f0), &y = b.end(f1), &z = b.end(f2);
            if ((x.cwiseMin(y).cwiseMin(z).array() <= high.array()).all() &&
                (x.cwiseMax(y).cwiseMax(z).array() >= low.array()).all() &&
                find_edge_triangle_hit(a.end(p), a.end(q), x, y, z))
                return true;
        }
    }
    return false;
}

/// Whether the surfaces cross at a pair's features where the step ends: behind its face, or behind one to
/// which it has slid.
bool crosses_at_the_end(const World& world, const Contact& pair)
{
    const SurfaceStep a = surface_of(world, pair.body_a), b = surface_of(world, pair.body_b);
    if (pair.kind == ContactKind::edge_edge)
        return any_passes_through(a, std::array{pair.feature_a}, b) ||
               any_passes_through(b, std::array{pair.feature_b}, a);
    return any_passes_through(a, a.topology.edges_around_vertex(pair.feature_a), b) ||
           any_passes_through(b, b.topology.edges_of_face(pair.feature_b), a);
}

/// Whether two crossings of the same two bodies push these the same way.
bool push_alike(const Contact& one, const Contact& other)
{
    const double order = one.body_a == other.body_a ? 1 : -1;
    return one.on_plane() || order * one.normal_t0.dot(other.normal_t0) >= distance_parts.hand_on;
}

/// Of two bodies whose points all follow one answer: the first impact.
void take_first(const std::vector<TimedPair>& ascending, Crossings& crossings)
{
    const double first = ascending.front().time;
    std::vector<const TimedPair*> impact;
    for (const TimedPair& crossing : ascending) {
        const auto is_alike = [&](const TimedPair* one) { return push_alike(one->pair, crossing.pair); };
        if (crossing.time <= first + distance_parts.touching ||
            (crossing.time <= first + distance_parts.together &&
             std::any_of(impact.begin(), impact.end(), is_alike)))
            impact.push_back(&crossing);
    }
    bool any = false;
    for (const TimedPair* crossing : impact)
        if (crossing->known == nullptr) {
            crossings.brought.push_back(crossing->pair);
            any = true;
        }
    if (!any)
        crossings.let_through.push_back(ascending.front().pair);
}

/// The first of each vertex and each edge.
void take_first_of_each(const std::vector<TimedPair>& ascending, Crossings& crossings)
{
    std::set<std::pair<int, int>> used;  // body and vertex
    bool any = false;
    for (const TimedPair& crossing : ascending) {
        const Contact& pair = crossing.pair;
        const auto vertex = [&](int i) {
            return std::pair{i < pair.vertices_of_a() ? pair.body_a : pair.body_b,
                             pair.vertices[static_cast<std::size_t>(i)]};
        };
        const int own = pair.kind == ContactKind::edge_edge ? 4 : 1, all = pair.vertex_count();
        bool is_used = false;
        for (int i = 0; i < own; ++i)
            is_used = is_used || used.count(vertex(i)) > 0;
        if (is_used)
            continue;
        for (int i = 0; i < all; ++i)
            used.insert(vertex(i));
        if (crossing.known == nullptr) {
            crossings.brought.push_back(pair);
            any = true;
        } else if (!any)
            crossings.let_through.push_back(pair);
    }
}

/// Whether a pair is on its own side at both ends of the step.
bool is_on_own_side(const World& world, const Contact& pair)
{
    if (pair.on_plane())
        return false;
    for (const double tau : {0.0, 1.0}) {
        Vec3 apart = Vec3::Zero();
        for (int i = 0; i < 4; ++i) {
            const auto n = static_cast<std::size_t>(i);
            apart += pair.weights[n] * body_of_vertex(world, pair, i).contact_point(pair.vertices[n], tau);
        }
        if (contact_geometry(world, pair, tau).normal.dot(apart) <= 0)
            return false;
    }
    return true;
}

}  // namespace

bool ends_well(const World& world, const Contact& pair)
{
    return is_on_own_side(world, pair) && !crosses_at_the_end(world, pair);
}

Crossings find_crossings(const World& world, const CandidateSearch& search, const Nearness& nearness,
                         const Contacts& known)
{
    Query query(world, nearness, known);
    visit_apart(
        search, nearness.left_out,
        [&](int body_a, int vertex, int body_b, int face) {
            query.vertex_face(body_a, vertex, body_b, face);
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            query.edge_edge(body_a, edge_a, body_b, edge_b);
        });
    for (int body = 0; body < static_cast<int>(world.bodies.size()); ++body)
        query.planes(body);
    Crossings crossings;
    for (auto& [bodies, found] : query.of_bodies) {
        std::vector<TimedPair> on_arcs;
        std::erase_if(found, [&](const TimedPair& crossing) {
            const bool is_arc = crossing.known != nullptr && is_on_own_side(world, *crossing.known);
            if (is_arc)
                on_arcs.push_back(crossing);
            return is_arc;
        });
        if (found.empty()) {
            const auto let_through = std::find_if(
                on_arcs.begin(), on_arcs.end(),
                [&](const TimedPair& crossing) { return crosses_at_the_end(world, crossing.pair); });
            if (let_through != on_arcs.end())
                crossings.let_through.push_back(let_through->pair);
            continue;
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const TimedPair& one, const TimedPair& other) { return one.time < other.time; });
        const auto keeps = [&](int body) {
            return body < 0 || keeps_shape(*world.bodies[static_cast<std::size_t>(body)]);
        };
        keeps(bodies.first) && keeps(bodies.second) ? take_first(found, crossings)
                                                    : take_first_of_each(found, crossings);
    }
    return crossings;
}

}  // namespace enduring
