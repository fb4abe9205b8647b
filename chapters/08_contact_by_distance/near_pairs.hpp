#pragma once

#include "chapters/02_collision_detection/candidate_search.hpp"
#include "chapters/08_contact_by_distance/feature_cones.hpp"
#include "chapters/08_contact_by_distance/own_directions.hpp"
#include "common/geometry/closest_points.hpp"

#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace enduring {

/// Two bodies by their places in World::bodies, the smaller first.
using TwoBodies = std::pair<int, int>;

//! [left_out]
/// What another rule serves: it gets no pair here, and may cross.
struct LeftOut {
    std::set<TwoBodies> bodies;                    ///< with all that they have
    std::set<std::tuple<int, int, int>> vertices;  ///< of a body, against another body
    std::set<std::tuple<int, int, int>> edges;     ///< the same

    bool vertex_face(int body_a, int vertex, int body_b) const
    {
        return bodies.count(std::minmax(body_a, body_b)) > 0 || vertices.count({body_a, vertex, body_b}) > 0;
    }
    bool edge_edge(int body_a, int edge_a, int body_b, int edge_b) const
    {
        return bodies.count(std::minmax(body_a, body_b)) > 0 || edges.count({body_a, edge_a, body_b}) > 0 ||
               edges.count({body_b, edge_b, body_a}) > 0;
    }
};
//! [left_out]

/// What nearest features are looked for with.
struct Nearness {
    std::function<double(int body_a, int body_b)>
        distance;  ///< of contact surfaces, up to which bodies may touch [m]
    std::function<double(int body_a, int body_b)>
        gap;  ///< of the bodies' own surfaces, below which they touch [m]
    std::function<double(int body)>
        behind_plane;  ///< how far behind a plane its surface for contact lies for a body [m]
    LeftOut left_out;  ///< what another rule serves
};

/// Of each vertex against a body: the nearest of its pairs, and the direction from there to the vertex. It is
/// where the vertex stands when a step begins.
class Grounds {
public:
    void look_at(const Contact& contact, double distance);
    /// Unit length; none for a vertex that has no pair with this body.
    std::optional<Vec3> normal(const Contact& contact) const;

private:
    std::map<std::tuple<int, int, int>, std::pair<double, Vec3>> nearest_;  ///< body_a, vertex, body_b
};

//! [near_pairs]
/// The pairs at the start of a step: where the distance of two surfaces for contact is smallest in their
/// neighbourhood, and the bodies' own surfaces touch or overlap there.
///
/// A vertex has a pair with each feature of the other surface, a face, an edge or a vertex, that is nearer to
/// it than the features around. Two edges have one if their nearest points lie inside both. The normal leads
/// from point to point, and lies within the cones of both features.
/// @param search  after find_candidates with boxes that are larger by half of the distance, or more
void append_near_pairs(const World& world, const CandidateSearch& search, const Nearness& nearness,
                       Contacts& contacts, Grounds& grounds);
//! [near_pairs]

/// The pair of a vertex with a feature of a face.
/// @param feature  the face, or behind all faces the edges and behind them the vertices of B
Contact vertex_pair(int body_a, int vertex, int body_b, const SurfaceStep& b, int face, int feature,
                    const std::array<double, 3>& weights, const Vec3& normal);
/// The pair of a vertex with a plane, by its place in World::planes.
Contact plane_pair(int body, int plane, int vertex);
/// The pair of two edges, s and t along them.
Contact edge_pair(int body_a, const SurfaceStep& a, int edge_a, int body_b, const SurfaceStep& b, int edge_b,
                  double s, double t, const Vec3& normal);

SurfaceStep surface_of(const World& world, int body);
/// The point of a face that is nearest to p, as the step begins.
ClosestOnTriangle closest_on_face(const Vec3& p, const SurfaceStep& b, int face);
/// The nearest points of two edges, as the step begins; none where these are ends, or the edges are parallel.
std::optional<ClosestOnEdges> closest_inside(const SurfaceStep& a, int edge_a, const SurfaceStep& b,
                                             int edge_b);
/// At right angles to two edges, as the step begins; as long as the area that they span.
Vec3 across_edges(const SurfaceStep& a, int edge_a, const SurfaceStep& b, int edge_b);
/// Whether a direction out of B lies in the cones of both edges.
bool in_cones_of_edges(const SurfaceMoment& a, int edge_a, const SurfaceMoment& b, int edge_b,
                       const Vec3& normal);

/// The candidates of a search, but for what another rule serves.
template <class VertexFace, class EdgeEdge>
void visit_apart(const CandidateSearch& search, const LeftOut& left_out, VertexFace&& vertex_face,
                 EdgeEdge&& edge_edge)
{
    search.visit_candidates(
        [&](int body_a, int vertex, int body_b, int face) {
            if (!left_out.vertex_face(body_a, vertex, body_b))
                vertex_face(body_a, vertex, body_b, face);
        },
        [&](int body_a, int edge_a, int body_b, int edge_b) {
            if (!left_out.edge_edge(body_a, edge_a, body_b, edge_b))
                edge_edge(body_a, edge_a, body_b, edge_b);
        });
}

/// Nearer than this, the difference of two points has no direction [m].
double touching_distance(const World& world, int body_a, int body_b);

}  // namespace enduring
