#include "chapters/07_implicit_contact/touching_pairs.hpp"

#include "chapters/02_collision_detection/body_broad_phase.hpp"
#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/03_penalty_impulses/crossing.hpp"
#include "chapters/03_penalty_impulses/crossing_detection.hpp"
#include "chapters/06_redefinition/edge_pairs.hpp"
#include "chapters/06_redefinition/pair_projection.hpp"

#include <algorithm>

namespace enduring {
namespace {

/// A scene is put together by some turns and shifts, each of which rounds a
/// coordinate by 1.1e-16 of its size. This is room for a hundred of them.
constexpr double rounding = 1e-14;

double largest_coordinate(const PairVertices& x)
{
    double largest = 0;
    for (const Vec3& vertex : x)
        largest = std::max(largest, vertex.cwiseAbs().maxCoeff());
    return largest;
}

/// Whether a depth is none but for rounding, and becomes one in the step.
bool sinks_from_zero(double depth_t0, double depth_t1, const PairVertices& x)
{
    const double nothing = rounding * largest_coordinate(x);
    return std::abs(depth_t0) <= nothing && depth_t1 < -nothing;
}

//! [touching]
std::optional<Crossing> touching(const VertexFaceStep& step)
{
    const PairVertices x{step.v_t0, step.f0_t0, step.f1_t0, step.f2_t0};
    const auto start = foot_on_triangle(x[0], x[1], x[2], x[3]);
    const auto end = foot_on_triangle(step.v_t1, step.f0_t1, step.f1_t1, step.f2_t1);
    if (!start || !end || overshoot(start->weights) > rounding ||
        !sinks_from_zero(start->depth, end->depth, x))
        return std::nullopt;
    return crossing_at(step, 0);
}

std::optional<Crossing> touching(const EdgeEdgeStep& step, const Vec3& outward)
{
    const Crossing crossing = crossing_at(step, 0);
    const PairVertices x{step.ea0_t0, step.ea1_t0, step.eb0_t0, step.eb1_t0};
    const auto start = feet_of_edges(x, crossing.orientation, smallest_edge_sine);
    const auto end = feet_of_edges({step.ea0_t1, step.ea1_t1, step.eb0_t1, step.eb1_t1}, crossing.orientation,
                                   smallest_edge_sine);
    if (!start || !end || !start->overlap(rounding) || !sinks_from_zero(start->depth, end->depth, x) ||
        !enters_edge(step, crossing, outward))
        return std::nullopt;
    return crossing;
}
//! [touching]

/// A tree around the step and a rounding more.
FaceTree wide_tree(const Body& body)
{
    const SurfaceStep step = surface_step(body);
    std::vector<Vec3> low(step.t0.begin(), step.t0.end()), high(step.t1.begin(), step.t1.end());
    double largest = 0;
    for (const Vec3& x : low)
        largest = std::max(largest, x.cwiseAbs().maxCoeff());
    for (std::size_t i = 0; i < low.size(); ++i) {
        const Vec3 start = low[i], end = high[i], margin = Vec3::Constant(rounding * largest);
        low[i] = start.cwiseMin(end) - margin;
        high[i] = start.cwiseMax(end) + margin;
    }
    FaceTree tree(step.topology, step.t0);
    tree.refit({step.topology, low, high});
    return tree;
}

void append(const std::optional<Crossing>& crossing, Contact pair, Contacts& contacts)
{
    if (!crossing)
        return;
    pair.weights = crossing->weights;
    if (pair.kind == ContactKind::edge_edge)
        pair.orientation = crossing->orientation;
    contacts.push_back(pair);
}

/// The pairs of two bodies, each named by its place in the world.
struct BodyPair {
    int body_a, body_b;
    SurfaceStep a, b;

    BodyPair(const World& world, int of_a, int of_b)
        : body_a(of_a), body_b(of_b), a(surface_step(*world.bodies[of_a])),
          b(surface_step(*world.bodies[of_b]))
    {}
    void append_vertex_face(int vertex, int face, const KnownPairs& known, Contacts& contacts) const
    {
        const auto [f0, f1, f2] = b.face(face);
        const Contact pair{ContactKind::vertex_face, body_a, body_b, vertex, face, {vertex, f0, f1, f2}};
        if (!known.contain(pair))
            append(touching(vertex_face_step(a, vertex, b, face)), pair, contacts);
    }
    void append_edge_edge(int edge_a, int edge_b, const KnownPairs& known, Contacts& contacts) const
    {
        const auto [a0, a1] = a.edge(edge_a);
        const auto [b0, b1] = b.edge(edge_b);
        const Contact pair{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b, {a0, a1, b0, b1}};
        if (!known.contain(pair))
            append(touching(edge_edge_step(a, edge_a, b, edge_b),
                            outward_at_edge(b, edge_b) - outward_at_edge(a, edge_a)),
                   pair, contacts);
    }
};

}  // namespace

void append_touching_pairs(const World& world, Contacts& contacts)
{
    const KnownPairs known(contacts);
    std::vector<FaceTree> trees;
    std::vector<SweptBox> boxes;
    for (const auto& body : world.bodies) {
        trees.push_back(wide_tree(*body));
        boxes.push_back(trees.back().box());
    }
    CandidatePairs pairs;
    for (const auto& [a, b] : overlapping_bodies(boxes)) {
        if (world.bodies[a]->is_static() && world.bodies[b]->is_static())
            continue;
        const BodyPair ab(world, a, b), ba(world, b, a);
        collect_pairs(trees[a], trees[b], pairs);
        for (const auto& [vertex, face] : pairs.vertex_face)
            ab.append_vertex_face(vertex, face, known, contacts);
        for (const auto& [face, vertex] : pairs.face_vertex)
            ba.append_vertex_face(vertex, face, known, contacts);
        for (const auto& [edge_a, edge_b] : pairs.edge_edge)
            ab.append_edge_edge(edge_a, edge_b, known, contacts);
    }
}

}  // namespace enduring
