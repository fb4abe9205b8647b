#include "chapters/08_contact_by_distance/touching_end.hpp"

#include "chapters/08_contact_by_distance/distance_parts.hpp"
#include "chapters/08_contact_by_distance/own_points.hpp"
#include "common/simulation/contact_geometry.hpp"

#include <algorithm>
#include <set>

namespace enduring {
namespace {

/// What has pairs already.
class Known {
public:
    Known(const Contacts& contacts, EndsOf wanted) : wanted_(wanted)
    {
        for (const Contact& contact : contacts) {
            if (contact.on_plane())
                continue;
            bodies_.insert(std::minmax(contact.body_a, contact.body_b));
            keys_.insert(key_of(contact));
            if (contact.kind == ContactKind::vertex_face)
                vertices_.insert({contact.body_a, contact.feature_a, contact.body_b});
        }
    }
    bool vertex(int body_a, int vertex, int body_b) const
    {
        return bodies(body_a, body_b) || vertices_.count({body_a, vertex, body_b}) > 0;
    }
    bool edges(int body_a, int edge_a, int body_b, int edge_b) const
    {
        return bodies(body_a, body_b) ||
               keys_.count({ContactKind::edge_edge, body_a, body_b, edge_a, edge_b}) > 0;
    }

private:
    bool bodies(int a, int b) const
    {
        return wanted_ == EndsOf::new_bodies && bodies_.count(std::minmax(a, b)) > 0;
    }

    EndsOf wanted_;
    std::set<TwoBodies> bodies_;
    std::set<std::tuple<int, int, int>> vertices_;
    std::set<PairKey> keys_;
};

/// Gathers the pairs.
class EndSearch {
public:
    EndSearch(const World& world, const Nearness& nearness) : world_(world), nearness_(nearness) {}

    void vertex_face(int body_a, int vertex, int body_b, int face)
    {
        const SurfaceStep a = surface_of(world_, body_a), b = surface_of(world_, body_b);
        const auto [f0, f1, f2] = b.face(face);
        const Vec3& p = a.end(vertex);
        const auto closest = closest_on_triangle(p, b.end(f0), b.end(f1), b.end(f2));
        if (!is_near(body_a, body_b, closest.distance))
            return;
        const Vec3 normal = (p - closest.point) / closest.distance,
                   ahead = SurfaceMoment{b, 1}.face_normal(face).stableNormalized();
        const double side = ahead.dot(normal) < 0 ? -1 : 1;
        if ((normal - side * ahead).norm() > distance_parts.least_fold ||  // beside the face
            !is_foremost({a, 1}, vertex, -normal, distance_parts.cone_sine))
            return;
        const Vec3 front = SurfaceMoment{b, 0}.face_normal(face).stableNormalized();
        add(vertex_pair(body_a, vertex, body_b, b, face, face, closest.weights, side * front));
    }

    void edge_edge(int body_a, int edge_a, int body_b, int edge_b)
    {
        const SurfaceStep a = surface_of(world_, body_a), b = surface_of(world_, body_b);
        const SurfaceStep a1{a.topology, a.t1, a.t1}, b1{b.topology, b.t1, b.t1};
        const auto closest = closest_inside(a1, edge_a, b1, edge_b);
        if (!closest || !is_near(body_a, body_b, closest->difference.norm()))
            return;
        const Vec3 normal = closest->difference.normalized();
        if (!in_cones_of_edges({a, 1}, edge_a, {b, 1}, edge_b, normal))
            return;
        const double side = across_edges(a1, edge_a, b1, edge_b).dot(normal) < 0 ? -1 : 1;
        const Vec3 first = (side * across_edges(a, edge_a, b, edge_b)).stableNormalized();
        Contact pair = edge_pair(body_a, a, edge_a, body_b, b, edge_b, closest->s, closest->t, first);
        pair.orientation = side;
        add(pair);
    }

    Contacts found;

private:
    bool is_near(int body_a, int body_b, double distance) const
    {
        return distance > touching_distance(world_, body_a, body_b) &&
               distance <= nearness_.distance(body_a, body_b);
    }
    void add(Contact pair)
    {
        pair.gap = nearness_.gap(pair.body_a, pair.body_b);
        put_on_own_surfaces(world_, 1, pair);
        if (contact_geometry(world_, pair, 1).depth < -touching_distance(world_, pair.body_a, pair.body_b))
            found.push_back(pair);
    }

    const World& world_;
    const Nearness& nearness_;
};

}  // namespace

Contacts pairs_at_the_end(const World& world, const CandidateSearch& search, const Nearness& nearness,
                          const Contacts& known, EndsOf wanted)
{
    const Known has(known, wanted);
    EndSearch ends(world, nearness);
    visit_apart(
        search, nearness.left_out,
        [&](int body_a, int vertex, int body_b, int face) {
            if (!has.vertex(body_a, vertex, body_b))
                ends.vertex_face(body_a, vertex, body_b, face);
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            if (!has.edges(body_a, edge_a, body_b, edge_b))
                ends.edge_edge(body_a, edge_a, body_b, edge_b);
        });
    return std::move(ends.found);
}

}  // namespace enduring
