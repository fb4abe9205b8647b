#include "chapters/08_contact_by_distance/near_pairs.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/own_points.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>

namespace enduring {
namespace {

Vec3 face_normal(const SurfaceStep& b, int face)
{
    return SurfaceMoment{b, 0}.face_normal(face).stableNormalized();
}

/// The feature of a face on which a point lies, by its weights, and the faces around it.
struct NearestFeature {
    int key;                      ///< the face, or behind all faces the edge, or behind these the vertex
    int vertex = -1;              ///< if it is one
    std::vector<int> neighbours;  ///< faces, with the face itself

    NearestFeature(const SurfaceStep& b, int face, const std::array<double, 3>& weights) : key(face)
    {
        const auto& topology = b.topology;
        const int faces = static_cast<int>(topology.faces().size()),
                  edges = static_cast<int>(topology.edges().size());
        const auto zeros = std::count(weights.begin(), weights.end(), 0.0);
        if (zeros == 1) {
            const auto opposite =
                static_cast<std::size_t>(std::find(weights.begin(), weights.end(), 0.0) - weights.begin());
            const int edge = topology.edges_of_face(face)[(opposite + 1) % 3];
            key = faces + edge;
            for (const int f : topology.faces_at_edge(edge))
                if (f >= 0)
                    neighbours.push_back(f);
        } else if (zeros == 2) {
            const auto corner = static_cast<std::size_t>(
                std::find_if(weights.begin(), weights.end(), [](double w) { return w != 0; }) -
                weights.begin());
            vertex = b.face(face)[corner];
            key = faces + edges + vertex;
            const auto around = topology.faces_around_vertex(vertex);
            neighbours.assign(around.begin(), around.end());
        }
    }
};

/// One vertex of A against all faces of B that come near.
class VertexSearch {
public:
    VertexSearch(const World& world, const Nearness& nearness, int body_a, int vertex, int body_b)
        : world_(world), gap_(nearness.gap(body_a, body_b)), a_(surface_of(world, body_a)),
          b_(surface_of(world, body_b)), body_a_(body_a), body_b_(body_b), vertex_(vertex),
          distance_(nearness.distance(body_a, body_b)), touching_(touching_distance(world, body_a, body_b)),
          p_(a_.start(vertex))
    {}

    void look_at(int face, Contacts& contacts, Grounds& grounds)
    {
        const ClosestOnTriangle closest = closest_on_face(p_, b_, face);
        if (closest.distance > distance_)
            return;
        if (closest.distance <= touching_)
            add_touching(face, closest, contacts);
        else
            add_near(face, closest, contacts, grounds);
    }

private:
    /// Where the points coincide, the faces tell the normal.
    void add_touching(int face, const ClosestOnTriangle& closest, Contacts& contacts)
    {
        const Vec3 normal = face_normal(b_, face);
        if (!is_foremost({a_, 0}, vertex_, -normal, distance_parts.cone_sine) || is_known_normal(normal))
            return;
        normals_.push_back(normal);
        contacts.push_back(vertex_pair(body_a_, vertex_, body_b_, b_, face, face, closest.weights, normal));
        contacts.back().gap = gap_;
    }

    void add_near(int face, const ClosestOnTriangle& closest, Contacts& contacts, Grounds& grounds)
    {
        const NearestFeature feature(b_, face, closest.weights);
        for (const int other : feature.neighbours)
            if (other != face && closest_on_face(p_, b_, other).distance < closest.distance - touching_)
                return;
        if (is_known_point(closest.point) || is_found_from_other_side(feature, closest))
            return;
        const Vec3 normal = (p_ - closest.point) / closest.distance;
        if (!is_foremost({a_, 0}, vertex_, -normal, distance_parts.cone_sine))
            return;
        Contact pair = vertex_pair(body_a_, vertex_, body_b_, b_, face, feature.key, closest.weights, normal);
        pair.gap = gap_;
        put_on_own_surfaces(world_, 0, pair);
        if (contact_geometry(world_, pair, 0).depth > touching_)
            return;
        points_.push_back(closest.point);
        contacts.push_back(pair);
        grounds.look_at(pair, closest.distance);
    }

    bool is_known_normal(const Vec3& normal) const
    {
        return std::any_of(normals_.begin(), normals_.end(), [&](const Vec3& other) {
            return (other - normal).norm() < distance_parts.least_fold;
        });
    }
    bool is_known_point(const Vec3& point) const
    {
        return std::any_of(points_.begin(), points_.end(),
                           [&](const Vec3& other) { return (other - point).norm() <= 10 * touching_; });
    }
    /// Two vertices that are nearest to each other are one pair, of the one that comes first.
    bool is_found_from_other_side(const NearestFeature& feature, const ClosestOnTriangle& closest) const
    {
        if (feature.vertex < 0 || std::pair(body_a_, vertex_) < std::pair(body_b_, feature.vertex) ||
            !has_own_directions(*world_.bodies[static_cast<std::size_t>(body_b_)], feature.vertex))
            return false;
        const auto around = a_.topology.faces_around_vertex(vertex_);
        return !around.empty() && std::all_of(around.begin(), around.end(), [&](int face) {
            return closest_on_face(closest.point, a_, face).distance >= closest.distance - touching_;
        });
    }

    const World& world_;
    double gap_;
    SurfaceStep a_, b_;
    int body_a_, body_b_, vertex_;
    double distance_, touching_;
    Vec3 p_;
    std::vector<Vec3> normals_, points_;  ///< of its pairs so far
};

/// The pair of two edges that are near each other, if they touch.
void append_near_edges(const World& world, const Nearness& nearness, int body_a, int edge_a, int body_b,
                       int edge_b, Contacts& contacts)
{
    const SurfaceStep a = surface_of(world, body_a), b = surface_of(world, body_b);
    const auto closest = closest_inside(a, edge_a, b, edge_b);
    if (!closest || closest->difference.norm() > nearness.distance(body_a, body_b))
        return;
    const double distance = closest->difference.norm();
    const bool touch = distance <= touching_distance(world, body_a, body_b);
    const auto in_cones = [&](const Vec3& normal) {
        return in_cones_of_edges({a, 0}, edge_a, {b, 0}, edge_b, normal);
    };
    Vec3 normal = touch ? across_edges(a, edge_a, b, edge_b).normalized()
                        : Vec3(closest->difference / distance);
    if (touch && !in_cones(normal))
        normal = -normal;
    if (!in_cones(normal))
        return;
    Contact pair = edge_pair(body_a, a, edge_a, body_b, b, edge_b, closest->s, closest->t, normal);
    pair.gap = nearness.gap(body_a, body_b);
    put_on_own_surfaces(world, 0, pair);
    if (contact_geometry(world, pair, 0).depth <= touching_distance(world, body_a, body_b))
        contacts.push_back(pair);
}

}  // namespace

ClosestOnTriangle closest_on_face(const Vec3& p, const SurfaceStep& b, int face)
{
    const auto [f0, f1, f2] = b.face(face);
    return closest_on_triangle(p, b.start(f0), b.start(f1), b.start(f2));
}

std::optional<ClosestOnEdges> closest_inside(const SurfaceStep& a, int edge_a, const SurfaceStep& b,
                                             int edge_b)
{
    const auto [a0, a1] = a.edge(edge_a);
    const auto [b0, b1] = b.edge(edge_b);
    return closest_inside_edges(a.start(a0), a.start(a1), b.start(b0), b.start(b1), distance_parts.edge_sine);
}

Vec3 across_edges(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b)
{
    const auto [a0, a1] = a.edge(edge_a);
    const auto [b0, b1] = b.edge(edge_b);
    return (a.start(a1) - a.start(a0)).cross(b.start(b1) - b.start(b0));
}

bool in_cones_of_edges(const SurfaceMoment& a, int edge_a, const SurfaceMoment& b, int edge_b,
                       const Vec3& normal)
{
    return in_cone_of_edge(b, edge_b, normal, distance_parts.cone_sine, distance_parts.least_fold) &&
           in_cone_of_edge(a, edge_a, -normal, distance_parts.cone_sine, distance_parts.least_fold);
}

SurfaceStep surface_of(const World& world, int body)
{
    return surface_step(*world.bodies[static_cast<std::size_t>(body)]);
}

double touching_distance(const World& world, int body_a, int body_b)
{
    return distance_parts.touching * std::min(world.bodies[static_cast<std::size_t>(body_a)]->size(),
                                              world.bodies[static_cast<std::size_t>(body_b)]->size());
}

Contact vertex_pair(int body_a, int vertex, int body_b, const SurfaceStep& b, int face, int feature,
                    const std::array<double, 3>& weights, const Vec3& normal)
{
    Contact contact{ContactKind::vertex_face, body_a, body_b, vertex, feature};
    const auto [f0, f1, f2] = b.face(face);
    contact.vertices = {vertex, f0, f1, f2};
    contact.weights = {1, -weights[0], -weights[1], -weights[2]};
    contact.normal_t0 = normal;
    return contact;
}

Contact plane_pair(int body, int plane, int vertex)
{
    return {ContactKind::vertex_plane, body, plane, vertex, -1, {vertex, -1, -1, -1}, {1, 0, 0, 0}};
}

Contact edge_pair(int body_a, const SurfaceStep& a, int edge_a, int body_b, const SurfaceStep& b, int edge_b,
                  double s, double t, const Vec3& normal)
{
    Contact contact{ContactKind::edge_edge, body_a, body_b, edge_a, edge_b};
    const auto [a0, a1] = a.edge(edge_a);
    const auto [b0, b1] = b.edge(edge_b);
    contact.vertices = {a0, a1, b0, b1};
    contact.weights = {1 - s, s, t - 1, -t};
    contact.normal_t0 = normal;
    contact.orientation = normal.dot(across_edges(a, edge_a, b, edge_b)) < 0 ? -1 : 1;
    return contact;
}

void Grounds::look_at(const Contact& contact, double distance)
{
    auto& nearest =
        nearest_.try_emplace({contact.body_a, contact.feature_a, contact.body_b}, distance, contact.normal_t0)
            .first->second;
    if (distance < nearest.first)
        nearest = {distance, contact.normal_t0};
}

std::optional<Vec3> Grounds::normal(const Contact& contact) const
{
    const auto found = nearest_.find({contact.body_a, contact.feature_a, contact.body_b});
    return found == nearest_.end() ? std::nullopt : std::optional(found->second.second);
}

void append_near_pairs(const World& world, const CandidateSearch& search, const Nearness& nearness,
                       Contacts& contacts, Grounds& grounds)
{
    std::vector<std::array<int, 4>> all;  // all faces of a vertex together
    Contacts of_edges;                    // behind those of vertices
    visit_apart(
        search, nearness.left_out,
        [&](int body_a, int vertex, int body_b, int face) {
            all.push_back({body_a, vertex, body_b, face});
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            append_near_edges(world, nearness, body_a, edge_a, body_b, edge_b, of_edges);
        });
    std::sort(all.begin(), all.end());
    std::optional<VertexSearch> vertex_search;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto [body_a, vertex, body_b, face] = all[i];
        if (i == 0 || !std::equal(all[i].begin(), all[i].begin() + 3, all[i - 1].begin()))
            vertex_search.emplace(world, nearness, body_a, vertex, body_b);
        vertex_search->look_at(face, contacts, grounds);
    }
    contacts.insert(contacts.end(), of_edges.begin(), of_edges.end());
}

}  // namespace enduring
